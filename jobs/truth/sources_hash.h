// Which code computes truths: a state in the cache must not outlive the algorithm that made it.
//
// The build hashes all sources of core/, truth/ and jobs/truth/ (jobs/CMakeLists.txt). So any
// change there, of a comment too, makes every state another's: to measure once more is cheaper
// than to go on from what another algorithm counted.
#pragma once

namespace plumb {

/// 64 hexadecimal digits.
const char* TruthSourcesHash();

}  // namespace plumb
