#include "io/survives.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>

namespace plumb {
namespace {

[[noreturn]] void RunChild(const std::function<void()>& work) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // Nobody waits for an orphan.
    const rlimit none{.rlim_cur = 0, .rlim_max = 0};
    setrlimit(RLIMIT_CORE, &none);
    const int nowhere = open("/dev/null", O_WRONLY);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGINT, SIGTERM}) {
        std::signal(signal, SIG_DFL);
    }
    try {
        work();
    } catch (...) {  // The parent will see it.
    }
    _exit(0);
}

}  // namespace

bool Survives(const std::function<void()>& work) {
    const pid_t child = fork();
    if (child < 0) return true;
    if (child == 0) RunChild(work);
    int status = 0;
    while (waitpid(child, &status, 0) < 0) {
        if (errno != EINTR) return true;
    }
    // Interrupted from outside is not the work's fault.
    const bool stopped =
        WIFSIGNALED(status) && (WTERMSIG(status) == SIGINT || WTERMSIG(status) == SIGTERM);
    return stopped || (WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

}  // namespace plumb
