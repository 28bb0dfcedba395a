// A piece of work tried in a process of its own, with a limit to its memory and its time.
//
// Readers of other people's formats crash, loop and ask for all the memory there is: of assimp
// 5.2 those of PLY, OFF, 3MF, Collada and others do on damaged files, where no exception can be
// caught. What ends well in the child is then done again in the parent, from the same bytes, to
// the same end; what does not is not begun there.
//
// Limits   Memory beyond what the parent has is bounded by RLIMIT_AS, its processor's time by
//          RLIMIT_CPU, and time on the clock by the parent, who kills the child.
// Beware   The address sanitizer reserves terabytes, so with it there is no limit of memory; what
//          it reports in the child is printed; a report about this program ends the parent with
//          the same status, kSanitizerStatus, one about a library (io/sanitizer_blame.h) is a
//          crash of the child.
// Cost     the work twice over.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace plumb {

struct ChildLimits {
    std::uint64_t memory_bytes = 1 << 30;  ///< Beyond what the parent has.
    double cpu_s = 10;                     ///< Rounded up to whole seconds.
    double clock_s = 15;
};

struct ChildEnd {
    enum class Kind { kDone, kThrew, kCrashed, kTooMuchMemory, kTooLong };
    Kind kind;
    std::string
        what;  ///< Of the exception, at most 4000 bytes; of a crash, the signal or status.
};

inline constexpr int kSanitizerStatus = 66;

/// How `work` ends in a child process. What it prints is dropped. A child that dies by a signal
/// has crashed, whichever it is; Ctrl-C does not reach it, but ends the wait: then
/// Interrupted is thrown. Throws MachineError if there can be no child.
ChildEnd TryInChild(const std::function<void()>& work, const ChildLimits& limits);

}  // namespace plumb
