// The nets of which every truth is made: their scatter is its error, with kTruthNets - 1 degrees of
// freedom.
#pragma once

namespace plumb {

inline constexpr int kTruthNets = 8;

}  // namespace plumb
