#include "jobs/truth/truth_cache.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "io/whole_file.h"

namespace plumb {
namespace {

constexpr std::size_t kNameDigits = 32;  // Of the hash: enough to tell files apart.

// Whether a run of this job comes past these counts.
bool IsOnTheWay(const TruthCounts& counts, const TruthJob& job) {
    if (counts.points > job.max_spp / kTruthNets) return false;
    return job.target_error == 0 ||
           std::none_of(counts.rms_errors.begin(), counts.rms_errors.end() - 1,
                        [&](double error) { return error <= job.target_error; });
}

}  // namespace

TruthCache::TruthCache(const std::filesystem::path& folder, std::string key, TruthSizes sizes,
                       const TruthJob& job)
    : key_(std::move(key)), sizes_(sizes), job_(job) {
    if (job.use_cache) path_ = folder / (key_.substr(0, kNameDigits) + ".state");
}

std::optional<TruthCounts> TruthCache::Load() {
    const auto refuse = [&](const std::string& why) -> std::optional<TruthCounts> {
        if (job_.resume) throw Error(path_.string() + ": " + why);
        return std::nullopt;
    };
    if (path_.empty()) {
        if (job_.resume) throw Error("resume without a cache, must have one");
        return std::nullopt;
    }
    std::error_code none;
    if (!std::filesystem::exists(path_, none)) {
        return refuse(
            "is missing: nothing was kept of this scene, view, seed and these quantities");
    }
    std::optional<TruthCounts> kept = TruthFromBytes(ReadWholeFile(path_), key_, sizes_, job_);
    if (!kept) {
        note_ = path_.filename().string() + " in the cache is damaged and was not used";
        return refuse("is damaged, must be removed");
    }
    if (!IsOnTheWay(*kept, job_)) {
        kept_points_ = kept->points;
        return refuse("has more samples than are asked for");
    }
    return kept;
}

void TruthCache::Store(const TruthCounts& counts) const {
    if (path_.empty() || counts.points <= kept_points_) return;
    WriteWholeFile(path_, ToBytes(counts, key_));
}

std::string StopRule(const TruthCounts& counts, const TruthJob& job) {
    if (counts.points == 0) return "";
    if (job.target_error > 0 && counts.rms_errors.back() <= job.target_error) {
        return "target error";
    }
    if (counts.points >= job.max_spp / kTruthNets) return "samples";
    return "";
}

}  // namespace plumb
