#include "io/try_in_child.h"

#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/error.h"

namespace plumb {
namespace {

using Kind = ChildEnd::Kind;

TEST(TryInChild, TellsHowItEnded) {
    EXPECT_EQ(TryInChild([] {}, {}).kind, Kind::kDone);
    const ChildEnd threw = TryInChild([] { throw Error("a.obj: no faces"); }, {});
    EXPECT_EQ(threw.kind, Kind::kThrew);
    EXPECT_EQ(threw.what, "a.obj: no faces");
    EXPECT_EQ(TryInChild([] { throw 1; }, {}).kind, Kind::kThrew);
    EXPECT_EQ(TryInChild([] { throw std::runtime_error(std::string(9000, 'x')); }, {}).what,
              std::string(4000, 'x'));
}

TEST(TryInChild, DeathByAnySignalIsACrash) {
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGKILL, SIGUSR1}) {
        const ChildEnd end = TryInChild([&] { raise(signal); }, {});
        EXPECT_EQ(end.kind, Kind::kCrashed) << signal;
    }
}

// Ctrl-C goes to a whole group of processes: it must not look like the end of the work.
TEST(TryInChild, DoesNotDieOfCtrlC) {
    const ChildEnd end = TryInChild(
        [] {
            raise(SIGINT);
            raise(SIGTERM);
            throw Error("was reached");
        },
        {});
    EXPECT_EQ(end.what, "was reached");
}

void Nothing(int) {}

TEST(TryInChild, AnInterruptEndsTheWaitAndTheChild) {
    const auto before = std::signal(SIGINT, Nothing);
    const pid_t parent = getpid();
    EXPECT_THROW(TryInChild(
                     [&] {
                         kill(parent, SIGINT);
                         pause();
                     },
                     {.clock_s = 60}),
                 Interrupted);
    std::signal(SIGINT, before);
}

TEST(TryInChild, LimitsTheClock) {
    EXPECT_EQ(TryInChild([] { pause(); }, {.clock_s = 0.1}).kind, Kind::kTooLong);
}

TEST(TryInChild, LimitsTheProcessor) {
    const auto turn = [] {
        volatile int k = 0;
        while (k == 0) {
        }
    };
    EXPECT_EQ(TryInChild(turn, {.cpu_s = 1, .clock_s = 600}).kind, Kind::kTooLong);
}

#ifndef __SANITIZE_ADDRESS__
TEST(TryInChild, LimitsMemoryEvenOfWhoCatchesIt) {
    const auto take = [](std::size_t mebibytes) {
        return [=] {
            try {
                const std::unique_ptr<char[]> block(new char[mebibytes << 20]);
                // Otherwise the compiler leaves the allocation out.
                const_cast<volatile char&>(block[0]) = 1;
            } catch (const std::bad_alloc&) {  // As assimp does.
            }
        };
    };
    EXPECT_EQ(TryInChild(take(512), {.memory_bytes = 256 << 20}).kind, Kind::kTooMuchMemory);
    EXPECT_EQ(TryInChild(take(128), {.memory_bytes = 256 << 20}).kind, Kind::kDone);
}
#endif

TEST(TryInChild, AReaderThatCallsExitHasCrashed) {
    EXPECT_EQ(TryInChild([] { std::_Exit(0); }, {}).kind, Kind::kCrashed);
}

#ifdef __SANITIZE_ADDRESS__
// Our own fault, not the file's: it must not pass for damage.
TEST(TryInChild, AReportOfEitherSanitizerEndsTheParent) {
    const auto overflow = [] {
        volatile int most = std::numeric_limits<int>::max();
        most = most + 1;
    };
    const auto overrun = [] {
        std::vector<int> one(1);
        volatile const int* values = one.data();
        std::_Exit(values[std::size_t(one.size())]);
    };
    EXPECT_EXIT(TryInChild(overflow, {}), testing::ExitedWithCode(kSanitizerStatus),
                "signed integer overflow");
    EXPECT_EXIT(TryInChild(overrun, {}), testing::ExitedWithCode(kSanitizerStatus),
                "heap-buffer-overflow");
}

// What a library asks for on a damaged file, as it would without the sanitizer.
TEST(TryInChild, AReportAboutALibraryIsACrashOfIt) {
    const auto overrun = [] {
        const std::vector<char> few(8);
        EVP_MD_CTX* context = EVP_MD_CTX_new();
        EVP_DigestInit_ex(context, EVP_sha256(), nullptr);
        EVP_DigestUpdate(context, few.data(), 40);
    };
    const ChildEnd end = TryInChild(overrun, {});
    EXPECT_EQ(end.kind, Kind::kCrashed);
    EXPECT_EQ(end.what, "a fault of memory in a library");
}
#endif

}  // namespace
}  // namespace plumb
