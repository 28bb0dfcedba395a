#include "app/process.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "core/error.h"

namespace plumb::app {
namespace {

// Not by way of std::cerr, which may not be there yet.
void Say(const std::string& what) {
    dprintf(STDERR_FILENO, "plumb: %s\n", what.c_str());
}

[[noreturn]] void EndAfterUncaught() {
    int status = 3;
    if (std::current_exception()) {
        status = StatusOfException();
    } else {
        Say("ended unexpectedly");
    }
    _exit(status);  // Other threads are still at work: no tidying up.
}

// Libraries start threads before main() begins, and throw where there is no memory for them. What
// stands in this section runs before them.
void SetHandler(int, char**, char**) {
    std::set_terminate(EndAfterUncaught);
}
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const kBeforeLibraries)(int, char**, char**) = SetHandler;

void HoldOpen(int stream) {
    if (fcntl(stream, F_GETFD) >= 0 || errno != EBADF) return;
    // The wrong way round, so that to use it is still an error.
    const int taken = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    if (taken >= 0 && taken != stream) {
        dup2(taken, stream);
        close(taken);
    }
}

}  // namespace

void PrepareProcess() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) HoldOpen(stream);
    std::signal(SIGXFSZ, SIG_IGN);
    std::signal(SIGPIPE, SIG_IGN);
}

void FlushOutput() {
    errno = 0;
    std::cout.flush();
    if (std::cout) return;
    const std::string why = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
    throw MachineError("standard output: cannot write" + why);
}

int StatusOfException() {
    try {
        throw;
    } catch (const Error& error) {
        Say(error.what());
        return 2;
    } catch (const CheckFailed& error) {
        Say(error.what());
        return 1;
    } catch (const MachineError& error) {
        Say(error.what());
        return 3;
    } catch (const Interrupted&) {
        Say("interrupted");
        return 130;
    } catch (const std::bad_alloc&) {
        Say("out of memory");
        return 3;
    } catch (
        const std::exception& error) {  // Of the system or of a library: no thread, no file.
        Say(std::string("failed: ") + error.what());
        return 3;
    } catch (...) {
        Say("failed for an unknown reason");
        return 3;
    }
}

}  // namespace plumb::app
