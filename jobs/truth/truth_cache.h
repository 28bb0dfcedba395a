// Truths that were measured before, each under the hash of all that decides its counts.
//
// A state is kept after every pass. It serves whoever asks for the same scene, view, seed and
// quantities and would have come past it: points only ever double, so to go on from there gives
// the bits of a run that was never stopped. Who wants fewer samples than it has measures anew.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "jobs/truth/truth.h"
#include "jobs/truth/truth_state.h"

namespace plumb {

class TruthCache {
  public:
    /// Keeps nothing if the job wants no cache.
    TruthCache(const std::filesystem::path& folder, std::string key, TruthSizes sizes,
               const TruthJob& job);

    /// What there is to go on from. A job that is to resume gets an Error if there is nothing;
    /// otherwise a state that cannot be used leaves a note.
    std::optional<TruthCounts> Load();

    /// Unless a state with more samples is there.
    void Store(const TruthCounts& counts) const;

    const std::string& Note() const { return note_; }

  private:
    std::filesystem::path path_;
    std::string key_;
    TruthSizes sizes_;
    const TruthJob& job_;
    std::int64_t kept_points_ = 0;  ///< Of a state that is there and stays.
    std::string note_;
};

/// Why a run with these counts ends here: "samples", "target error", or nothing.
std::string StopRule(const TruthCounts& counts, const TruthJob& job);

}  // namespace plumb
