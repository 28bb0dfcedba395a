// Ctrl-C and SIGTERM in the middle of the work of every subcommand: status 130 within two seconds,
// and no output that is there by halves.
#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <ostream>

#include "tests/faults/program.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr double kPatienceS = 2;
constexpr int kThreads = 2;

struct Long {
    const char* line;  ///< Would take minutes.
    double cpu_s;      ///< How far into the work the signal comes.
};

void PrintTo(const Long& work, std::ostream* out) {
    *out << work.line;
}

class Signals : public TempFolder, public testing::WithParamInterface<Long> {
  protected:
    // A black picture of 2^24 pixels that takes no room on the disk.
    void SetUp() override {
        const std::string head = "Pf\n4096 4096\n-1\n";
        std::filesystem::resize_file(Put("large.pfm", head),
                                     head.size() + std::uintmax_t{4096} * 4096 * sizeof(float));
    }
};

TEST_P(Signals, EndTheRunWithin2Seconds) {
    for (const int signal : {SIGINT, SIGTERM}) {
        Program program(Words(GetParam().line + (" --threads " + std::to_string(kThreads))),
                        {.folder = folder_});
        ASSERT_TRUE(program.IsAtWork(GetParam().cpu_s)) << program.Wait(10).errors;
        const double cpu_s = program.CpuS();
        const auto begin = std::chrono::steady_clock::now();
        program.Send(signal);
        const Ended ended = program.Wait(600);
        const double clock_s =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        EXPECT_EQ(ended.status, 130) << ended.errors;
        EXPECT_THAT(ended.errors, HasSubstr("interrupted"));
        // On a machine that others use too, what it worked says more than the clock.
        EXPECT_TRUE(clock_s <= kPatienceS || ended.cpu_s - cpu_s <= kThreads * kPatienceS)
            << clock_s << " s, " << ended.cpu_s - cpu_s << " s of processors";
        EXPECT_THAT(PartsBelow(folder_), IsEmpty());
    }
}

// Early: while the scene or the map is made. Later: in the middle of tracing, linking, timing.
constexpr Long kWork[] = {
    {"simulate make:stone_wall:256 --slices 1024", 0},
    {"simulate make:stone_wall:256 --slices 1024", 1},
    {"simulate make:stone_wall:512 --method rays --rays 65536", 1},
    {"fit make:stone_wall:256 make:bricks:256 --slices 256", 0.5},
    {"truth atrium --spp 65536", 0},
    {"truth wedge --facets --spp 65536", 0.5},
    {"render atrium --technique sao-paper --samples 4096", 0.5},
    {"report atrium", 0.5},
    {"score large.pfm large.pfm", 0.1},
    {"score large.pfm large.pfm large.pfm", 2},
    {"bench light make:stone_wall:512", 1},
    {"bench raster atrium --rounds 1000", 0.5},
    {"bench truth atrium --paths 100000000", 1},
};

INSTANTIATE_TEST_SUITE_P(Every, Signals, testing::ValuesIn(kWork));

}  // namespace
}  // namespace plumb
