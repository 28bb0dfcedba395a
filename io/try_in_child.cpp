#include "io/try_in_child.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <new>
#include <string_view>

#include "core/error.h"
#include "io/sanitizer_blame.h"

namespace plumb {
namespace {

using Clock = std::chrono::steady_clock;

// How a child that was not killed ends; a sanitizer and exit() of a library have others.
constexpr int kDoneStatus = 40, kThrewStatus = 41, kMemoryStatus = 42, kLibraryStatus = 43;
constexpr std::size_t kMostWords = 4000;

[[maybe_unused]] std::uint64_t AddressSpaceBytes() {  // A sanitizer's is terabytes.
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * std::uint64_t(sysconf(_SC_PAGESIZE));
}

// The second limit, where it is another one, is that at which the system does not ask any more.
void Limit(__rlimit_resource_t resource, std::uint64_t most, std::uint64_t at_last) {
    rlimit limit{};
    getrlimit(resource, &limit);
    limit.rlim_max = std::min<rlim_t>(at_last, limit.rlim_max);
    limit.rlim_cur = std::min<rlim_t>(most, limit.rlim_max);
    setrlimit(resource, &limit);
}

void TakeNoMoreThan(const ChildLimits& limits) {
    const auto cpu_s = std::uint64_t(std::ceil(limits.cpu_s));
    Limit(RLIMIT_CORE, 0, 0);
    Limit(RLIMIT_CPU, cpu_s, cpu_s + 1);  // SIGXCPU, then SIGKILL.
#ifndef __SANITIZE_ADDRESS__
    const std::uint64_t bytes = AddressSpaceBytes() + limits.memory_bytes;
    Limit(RLIMIT_AS, bytes, bytes);
#endif
    // At the first that is refused: some readers catch bad_alloc and call it an error of the file.
    std::set_new_handler([] { _exit(kMemoryStatus); });
}

[[noreturn]] void RunChild(const std::function<void()>& work, const ChildLimits& limits,
                           int answer) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // Nobody waits for an orphan.
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
#ifndef __SANITIZE_ADDRESS__
    dup2(nowhere, STDERR_FILENO);
#endif
    for (const int signal :
         {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGXFSZ, SIGPIPE}) {
        std::signal(signal, SIG_DFL);
    }
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, SIG_IGN);
    std::set_terminate([] { std::abort(); });
    TakeNoMoreThan(limits);
    EndAtReportsOfLibrariesWith(kLibraryStatus);
    std::string what;
    try {
        work();
        _exit(kDoneStatus);
    } catch (const std::bad_alloc&) {
        _exit(kMemoryStatus);
    } catch (const std::exception& error) {
        what = error.what();
    } catch (...) {
        what = "an exception of unknown kind";
    }
    what.resize(std::min(what.size(), kMostWords));
    // A pipe takes that much at once, or the parent is gone.
    if (write(answer, what.data(), what.size()) < 0) _exit(kThrewStatus);
    _exit(kThrewStatus);
}

// Signals of this thread that wait while one of these lives: one that comes before the wait for
// the child must end that wait, not be forgotten.
class HeldSignals {
  public:
    HeldSignals() {
        sigset_t held;
        sigemptyset(&held);
        for (const int signal : {SIGINT, SIGTERM}) sigaddset(&held, signal);
        pthread_sigmask(SIG_BLOCK, &held, &before_);
    }
    HeldSignals(const HeldSignals&) = delete;
    ~HeldSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    const sigset_t& Before() const { return before_; }

  private:
    sigset_t before_;
};

// What the child wrote before it closed its end; false if it had not by `end`. Throws Interrupted
// if a signal that the program handles came in.
bool ReadUntil(Clock::time_point end, int answer, const sigset_t& signals, std::string& words) {
    while (true) {
        const std::chrono::duration<double> left = end - Clock::now();
        const double left_s = std::max(0.0, left.count());
        const timespec wait{.tv_sec = time_t(left_s),
                            .tv_nsec = long(1e9 * (left_s - std::floor(left_s)))};
        pollfd waiting{.fd = answer, .events = POLLIN, .revents = 0};
        const int ready = ppoll(&waiting, 1, &wait, &signals);
        if (ready < 0 && errno == EINTR) throw Interrupted();
        if (ready <= 0) return false;
        char block[512];
        const ssize_t n = read(answer, block, sizeof block);
        if (n <= 0) return true;
        words.append(block, std::size_t(n));
    }
}

// A child that is waited for, and killed if nobody does.
class Child {
  public:
    explicit Child(pid_t pid) : pid_(pid) {}
    Child(const Child&) = delete;
    ~Child() {
        if (pid_ > 0) Kill();
    }

    int Wait() {
        int status = 0;
        while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
        }
        pid_ = -1;
        return status;
    }
    void Kill() {
        kill(pid_, SIGKILL);
        Wait();
    }

  private:
    pid_t pid_;
};

ChildEnd EndOf(int status, std::string words) {
    using Kind = ChildEnd::Kind;
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        if (signal == SIGXCPU) return {Kind::kTooLong, ""};
        return {Kind::kCrashed, strsignal(signal)};
    }
    switch (WEXITSTATUS(status)) {
        case kDoneStatus:
            return {Kind::kDone, ""};
        case kLibraryStatus:
            return {Kind::kCrashed, "a fault of memory in a library"};
        case kThrewStatus:
            return {Kind::kThrew, std::move(words)};
        case kMemoryStatus:
            return {Kind::kTooMuchMemory, ""};
#ifdef __SANITIZE_ADDRESS__
        case kSanitizerStatus:
            _exit(kSanitizerStatus);  // Its report is on standard error.
#endif
        default:  // A library called exit().
            return {Kind::kCrashed, "status " + std::to_string(WEXITSTATUS(status))};
    }
}

}  // namespace

ChildEnd TryInChild(const std::function<void()>& work, const ChildLimits& limits) {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) {
        throw MachineError(std::string("cannot make a pipe: ") + std::strerror(errno));
    }
    const HeldSignals signals;
    const pid_t pid = fork();
    const int error = errno;
    if (pid == 0) {
        close(ends[0]);
        RunChild(work, limits, ends[1]);
    }
    close(ends[1]);
    struct Closer {
        int fd;
        ~Closer() { close(fd); }
    } const answer{ends[0]};
    if (pid < 0) {
        throw MachineError(std::string("cannot start a process: ") + std::strerror(error));
    }
    Child child(pid);
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                        std::chrono::duration<double>(limits.clock_s));
    std::string words;
    if (!ReadUntil(end, answer.fd, signals.Before(), words)) {
        child.Kill();
        return {ChildEnd::Kind::kTooLong, ""};
    }
    return EndOf(child.Wait(), std::move(words));
}

}  // namespace plumb
