// The program as a process among others: what the system may do to it, and how it ends.
#pragma once

#include <stdexcept>

namespace plumb::app {

/// At the begin of main(). A file that grows beyond `ulimit -f` and a reader of a pipe that went
/// become errors of the write, not signals that kill; a standard stream that is closed is
/// held open on /dev/null, so that no file of ours takes its place. Already before, an exception
/// that nobody can catch (in a thread, in a library that is loaded) ends the program with a
/// message and status 3.
void PrepareProcess();

/// Writes out what is left of standard output. Throws MachineError if it did not all go: a full
/// disk, a closed stream.
void FlushOutput();

/// Everything ran and was written, and a check of the results failed. Exit status 1.
class CheckFailed : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The exit status of the exception that is being handled, after its message on standard error.
int StatusOfException();

}  // namespace plumb::app
