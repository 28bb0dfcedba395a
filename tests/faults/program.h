// The program as its users' shells run it: what comes in, what comes out, how it ends.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace plumb {

/// What a shell sets before it starts a program.
struct Circumstances {
    std::filesystem::path folder = {};  ///< Where it runs.
    std::string standard_output = {};   ///< A file or device; empty: into Ended::output.
    std::optional<std::uint64_t> memory_bytes = {};  ///< ulimit -v.
    std::optional<std::uint64_t> file_bytes = {};    ///< ulimit -f.
    bool as_nobody = false;                          ///< Without root's rights to everything.
};

struct Ended {
    int status = 0;  ///< As a shell has it: 128 + the signal that killed it.
    double clock_s = 0, cpu_s = 0;
    bool was_killed = false;  ///< By us, after the time that it was given.
    std::string output, errors;
};

/// A run of plumb. Killed when its owner goes.
class Program {
  public:
    Program(const std::vector<std::string>& arguments, const Circumstances& circumstances);
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    /// True once it listens to SIGINT and has worked for `cpu_s` since; false if it ended before.
    bool IsAtWork(double cpu_s) const;
    /// True once it has started a process of its own; false if it ended before.
    bool HasAChild() const;
    void Send(int signal) const;
    /// Seconds of processor that it has taken.
    double CpuS() const;
    /// Its end; killed after `patience_s`.
    Ended Wait(double patience_s);

  private:
    bool HasEnded() const;

    pid_t pid_ = -1;
    double begin_s_ = 0;
    std::filesystem::path output_, errors_;
};

/// From start to end, in at most `patience_s`: long, for a machine that others use too. How quick
/// the program is, its seconds of processor say.
Ended RunPlumb(const std::vector<std::string>& arguments, const Circumstances& circumstances,
               double patience_s = 300);

/// The words of a command line.
std::vector<std::string> Words(const std::string& line);

/// True where the tests run with root's rights, which no file refuses.
bool IsRoot();

/// Files anywhere below a folder whose name holds ".part": what was left half-written.
std::vector<std::string> PartsBelow(const std::filesystem::path& folder);

}  // namespace plumb
