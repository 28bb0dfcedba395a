#include "jobs/truth/truth_state.h"

#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <sstream>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "io/content_hash.h"

namespace plumb {
namespace {

constexpr std::size_t kDigits = 64;  // Of a SHA-256.

class Writer {
  public:
    explicit Writer(std::string& bytes) : bytes_(bytes) {}

    template <class T>
    void operator()(std::span<T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    }

  private:
    std::string& bytes_;
};

class Reader {
  public:
    explicit Reader(std::string_view bytes) : left_(bytes) {}

    template <class T>
    void operator()(std::span<T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        fits_ = fits_ && values.size_bytes() <= left_.size();
        if (!fits_ || values.empty()) return;
        std::memcpy(static_cast<void*>(values.data()), left_.data(), values.size_bytes());
        left_.remove_prefix(values.size_bytes());
    }

    bool Fits() const { return fits_; }
    bool IsAtEnd() const { return left_.empty(); }

  private:
    std::string_view left_;
    bool fits_ = true;
};

template <class T>
std::span<T> One(T& value) {
    return {&value, 1};
}

// Hands every number of the counts to `visit`, in one order for writing and reading.
template <class Counts, class Visit>
void VisitNumbers(Counts& counts, Visit&& visit) {
    for (auto* open : {&counts.alpha, &counts.V}) {
        if (!*open) continue;
        visit(std::span((*open)->open));
        visit(One((*open)->lost));
    }
    if (counts.walks) {
        for (std::int64_t i = 0; i < counts.walks->Receivers(); ++i) {
            for (int r = 0; r < counts.walks->Replicates(); ++r) {
                visit(counts.walks->Row(i, r));
            }
        }
        visit(One(counts.walks->lost));
    }
    const auto visit_colours = [&](auto& sums) {
        visit(std::span(sums.sum));
        visit(std::span(sums.spread));
        visit(One(sums.ceiling));
    };
    if (counts.near) {
        visit(std::span(counts.near->sum));
        visit(std::span(counts.near->spread));
    }
    if (counts.irradiance) {
        visit_colours(counts.irradiance->sums);
        visit(One(counts.irradiance->lost));
        visit(One(counts.irradiance->cut));
    }
    if (counts.beauty) visit_colours(*counts.beauty);
    visit(std::span(counts.rms_errors));
}

// Counts of the right size, all zero.
TruthCounts Empty(std::int64_t points, const TruthSizes& sizes, const TruthJob& job) {
    const std::size_t cells = std::size_t(sizes.receivers) * kTruthNets;
    const auto colours = [&](std::int64_t n) { return RgbSums(n, kTruthNets, points); };
    const OpenCounts open{.replicates = kTruthNets,
                          .points = points,
                          .open = std::vector<std::uint32_t>(cells),
                          .lost = {}};
    TruthCounts counts;
    counts.points = points;
    if (job.alpha) counts.alpha = open;
    if (job.bounces > 0) {
        counts.walks.emplace(sizes.receivers, kTruthNets, job.bounces, points);
    } else if (job.V) {
        counts.V = open;
    }
    if (job.reach_m > 0) {
        counts.near =
            NearSums{.replicates = kTruthNets,
                     .points = points,
                     .sum = std::vector<double>(cells),
                     .spread = std::vector<SampleSpread>(std::size_t(sizes.receivers))};
    }
    if (job.irradiance) {
        counts.irradiance = IrradianceSums{.sums = colours(sizes.receivers), .lost = {}};
    }
    if (job.beauty) counts.beauty = colours(sizes.pixels);
    for (std::int64_t n = points; n >= kFirstPassPoints; n /= 2) counts.rms_errors.push_back(0);
    return counts;
}

template <class T>
void MergeInto(std::optional<T>& all, std::optional<T>&& later) {
    if (!later) return;
    if (all) {
        all->Merge(*later);
    } else {
        all = std::move(later);
    }
}

}  // namespace

void Merge(TruthCounts& all, TruthCounts&& later) {
    MergeInto(all.alpha, std::move(later.alpha));
    MergeInto(all.V, std::move(later.V));
    MergeInto(all.walks, std::move(later.walks));
    MergeInto(all.near, std::move(later.near));
    MergeInto(all.irradiance, std::move(later.irradiance));
    MergeInto(all.beauty, std::move(later.beauty));
    all.points += later.points;
}

Lost LostIn(const TruthCounts& counts) {
    Lost lost;
    if (counts.alpha) lost += counts.alpha->lost;
    if (counts.V) lost += counts.V->lost;
    if (counts.walks) lost += counts.walks->lost;
    if (counts.irradiance) lost += counts.irradiance->lost;
    return lost;
}

std::string KeyOfTruth(const LoadedScene& loaded, const Camera& camera, const TruthJob& job,
                       const std::string& tool_version, const std::string& sources_hash) {
    std::ostringstream text;
    const bool walks = job.bounces > 0, near = job.reach_m > 0;
    text << std::hexfloat << tool_version << ' ' << sources_hash << ' ' << loaded.digest << ' '
         << job.seed << ' ' << job.alpha << ' ' << (job.V && !walks) << ' ' << job.irradiance
         << ' ' << job.beauty << ' ' << job.bounces << ' ' << job.reach_m << ' '
         << (near ? int(job.falloff) : 0) << ' ' << camera.fov_rad << ' ' << camera.width_px
         << ' ' << camera.height_px;
    for (const Vec3& v : {camera.position_m, camera.target_m, camera.up}) {
        text << ' ' << v.x() << ' ' << v.y() << ' ' << v.z();
    }
    return Sha256Hex(text.str());
}

std::string ToBytes(const TruthCounts& counts, const std::string& key) {
    std::string bytes = key;
    Writer write(bytes);
    write(One(counts.points));
    VisitNumbers(counts, write);
    return bytes + Sha256Hex(bytes);
}

std::optional<TruthCounts> TruthFromBytes(const std::string& bytes, const std::string& key,
                                          const TruthSizes& sizes, const TruthJob& job) {
    if (bytes.size() < key.size() + kDigits || !bytes.starts_with(key)) return std::nullopt;
    const std::string_view all = bytes;
    const std::string_view content = all.substr(0, all.size() - kDigits);
    if (all.substr(content.size()) != Sha256Hex(content)) return std::nullopt;
    Reader read(content.substr(key.size()));
    std::int64_t points = 0;
    read(One(points));
    if (!read.Fits() || points < kFirstPassPoints ||
        !std::has_single_bit(std::uint64_t(points))) {
        return std::nullopt;
    }
    TruthCounts counts = Empty(points, sizes, job);
    VisitNumbers(counts, read);
    if (!read.Fits() || !read.IsAtEnd()) return std::nullopt;
    return counts;
}

}  // namespace plumb
