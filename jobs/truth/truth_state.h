// All that was counted so far of one truth, as values and as bytes on the disk.
//
// The bytes are those of the job's key, the counts, and the SHA-256 of both: a file that is of
// another job, cut off or damaged is not taken for a state.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jobs/truth/sources_hash.h"
#include "jobs/truth/truth.h"
#include "jobs/truth/truth_nets.h"
#include "truth/beauty.h"
#include "truth/escape_walk.h"
#include "truth/irradiance.h"
#include "truth/near_visibility.h"
#include "truth/open_sky.h"

namespace plumb {

inline constexpr std::int64_t kFirstPassPoints = 8;  ///< Of each net; doubled by every pass.

/// Which members are there follows from the job.
struct TruthCounts {
    std::int64_t points = 0;  ///< Of each net.
    std::optional<OpenCounts> alpha, V;
    std::optional<EscapeCounts> walks;
    std::optional<NearSums> near;
    std::optional<IrradianceSums> irradiance;
    std::optional<RgbSums> beauty;   ///< Of pixels.
    std::vector<double> rms_errors;  ///< After each pass, of what the target error is about.
};

struct TruthSizes {
    std::int64_t receivers = 0, pixels = 0;
};

/// Adds later points of the same nets.
void Merge(TruthCounts& all, TruthCounts&& later);

/// Walks lost in all quantities together.
Lost LostIn(const TruthCounts& counts);

/// SHA-256 of all that decides the counts, the code that makes them too, but not of when to
/// stop nor of what is derived from the counts (albedos).
std::string KeyOfTruth(const LoadedScene& loaded, const Camera& camera, const TruthJob& job,
                       const std::string& tool_version,
                       const std::string& sources_hash = TruthSourcesHash());

std::string ToBytes(const TruthCounts& counts, const std::string& key);

/// Nothing if the bytes are not a whole state of the job with that key.
std::optional<TruthCounts> TruthFromBytes(const std::string& bytes, const std::string& key,
                                          const TruthSizes& sizes, const TruthJob& job);

}  // namespace plumb
