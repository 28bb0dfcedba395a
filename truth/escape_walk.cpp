#include "truth/escape_walk.h"

#include <cassert>
#include <cmath>
#include <mutex>

#include "core/error.h"
#include "core/parallel.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "rays/leave_surface.h"

namespace plumb {
namespace {

constexpr std::int64_t kReceiversPerChunk = 8;

// A ray that got behind a surface starts again, this much further from the edges each time:
// the last time 6e4 h, a hundredth of a triangle that is a thousandth of the scene.
constexpr int kRescues = 5;
constexpr double kRescueGrowth = 8;

// Follows the walks of one receiver together, bounce by bounce.
class Walker {
  public:
    Walker(const RayCaster& caster, const Mesh& mesh, const WalkOptions& options,
           const Monitor& monitor)
        : caster_(caster), mesh_(mesh), options_(options), monitor_(monitor) {}

    void Walk(const Receiver& receiver, std::int64_t number, EscapeCounts& counts) {
        Start(receiver, number);
        for (int k = 0; k <= options_.bounces && !walks_.empty(); ++k) {
            CheckCancelled(monitor_);
            hits_.resize(rays_.size());
            caster_.Closest(rays_, hits_);
            std::size_t kept = 0;
            for (std::size_t i = 0; i < walks_.size(); ++i) {
                const End end = Step(i, k);
                if (end == End::kGoesOn) {
                    walks_[kept] = walks_[i];
                    rays_[kept] = rays_[i];
                    ++kept;
                    continue;
                }
                const int column = end == End::kSky ? k : options_.bounces + 2;
                ++counts.Row(number, walks_[i].replicate)[std::size_t(column)];
            }
            walks_.resize(kept);
            rays_.resize(kept);
        }
        for (const State& walk : walks_) {
            ++counts.Row(number, walk.replicate)[std::size_t(options_.bounces) + 1];
        }
    }

    const Lost& GetLost() const { return lost_; }

  private:
    struct State {
        int replicate;
        std::uint32_t index;     // Of the point in its net.
        std::uint32_t triangle;  // That it left last, where, and on which side.
        Vec2 b;
        Vec3 n;
    };
    enum class End { kGoesOn, kSky, kLost };

    void Start(const Receiver& receiver, std::int64_t number) {
        const NetSampling& sampling = options_.sampling;
        const Triangle triangle = TriangleOf(mesh_, receiver.triangle);
        const Basis frame(receiver.Normal(triangle));
        nets_.clear();
        walks_.clear();
        rays_.clear();
        for (int r = 0; r < sampling.replicates; ++r) {
            nets_.push_back(NetSeed(sampling.seed, number, r));
            for (std::int64_t s = 0; s < sampling.points; ++s) {
                const std::uint32_t index = std::uint32_t(sampling.first + s);
                const Vec2 b = receiver.Place(SobolOwenPair(index, kPlace, nets_.back()));
                walks_.push_back({r, index, receiver.triangle, b, frame.n});
                rays_.push_back(LeaveSurface(triangle, b.x(), b.y(), frame.n));
                rays_.back().direction = Direction(frame, walks_.back(), kFirstDirection);
            }
        }
    }

    Vec3f Direction(const Basis& frame, const State& walk, std::uint32_t pair) const {
        const Vec2 u = SobolOwenPair(walk.index, pair, nets_[std::size_t(walk.replicate)]);
        return frame.ToWorld(SampleCosineHemisphere(u)).cast<float>();
    }

    // Whether a ray got where it cannot be; `count` is then the reason's.
    bool IsAstray(const Ray& ray, const Hit& hit, std::int64_t Lost::*& count) const {
        const Vec3 w = ray.direction.cast<double>();
        if (!hit.Met()) {
            count = w.allFinite() ? &Lost::not_sky : &Lost::not_a_number;
            return !w.allFinite() || !LeadsToSky(options_.sky, w.z());
        }
        count = &Lost::from_behind;
        return !options_.two_sided && TriangleOf(mesh_, hit.triangle).Cross().dot(w) > 0;
    }

    // Starts the ray again further inside the triangle, until it meets what it can meet.
    bool Rescue(const State& walk, Ray& ray, Hit& hit) {
        const Triangle triangle = TriangleOf(mesh_, walk.triangle);
        std::int64_t Lost::*count = nullptr;
        double margin = kMargin;
        for (int attempt = 0; attempt < kRescues; ++attempt) {
            margin *= kRescueGrowth;
            const Vec3f direction = ray.direction;
            ray = LeaveSurface(triangle, walk.b.x(), walk.b.y(), walk.n, margin);
            ray.direction = direction;
            caster_.Closest({&ray, 1}, {&hit, 1});
            if (!IsAstray(ray, hit, count)) {
                ++lost_.rescued;
                return true;
            }
        }
        ++(lost_.*count);
        return false;
    }

    // What became of ray i, the k-th of its walk; if it goes on, rays_[i] is the next one.
    End Step(std::size_t i, int k) {
        Ray& ray = rays_[i];
        Hit& hit = hits_[i];
        State& walk = walks_[i];
        std::int64_t Lost::*count = nullptr;
        if (IsAstray(ray, hit, count) && !Rescue(walk, ray, hit)) return End::kLost;
        if (!hit.Met()) return End::kSky;

        const Triangle triangle = TriangleOf(mesh_, hit.triangle);
        const Vec3 front = triangle.Normal();
        const bool from_front = front.dot(ray.direction.cast<double>()) <= 0;
        walk.triangle = hit.triangle;
        walk.b = {hit.b_1, hit.b_2};
        walk.n = from_front ? front : Vec3(-front);
        ray = LeaveSurface(triangle, hit.b_1, hit.b_2, walk.n);
        ray.direction = Direction(Basis(walk.n), walk, kLaterDirections + std::uint32_t(k));
        return End::kGoesOn;
    }

    const RayCaster& caster_;
    const Mesh& mesh_;
    const WalkOptions& options_;
    const Monitor& monitor_;
    std::vector<std::uint64_t> nets_;
    std::vector<State> walks_;
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
    Lost lost_;
};

}  // namespace

void Validate(const WalkOptions& options) {
    Validate(options.sampling);
    if (options.bounces < 0 || options.bounces > 10000) {
        throw Error(MustBe("WalkOptions::bounces", options.bounces, "in [0, 10000]"));
    }
}

EscapeCounts::EscapeCounts(std::int64_t receivers, int replicates, int bounces,
                           std::int64_t points)
    : receivers_(receivers),
      replicates_(replicates),
      bounces_(bounces),
      points_(points),
      counts_(std::size_t(receivers) * replicates * (bounces + 3)) {}

std::span<std::uint32_t> EscapeCounts::Row(std::int64_t receiver, int replicate) {
    const std::size_t columns = std::size_t(bounces_) + 3;
    return std::span(counts_).subspan(
        (std::size_t(receiver) * replicates_ + replicate) * columns, columns);
}

std::span<const std::uint32_t> EscapeCounts::Row(std::int64_t receiver, int replicate) const {
    const std::size_t columns = std::size_t(bounces_) + 3;
    return std::span(counts_).subspan(
        (std::size_t(receiver) * replicates_ + replicate) * columns, columns);
}

Measured EscapeCounts::Column(std::int64_t receiver, int column, double confidence) const {
    std::vector<std::uint32_t> counts;
    for (int r = 0; r < replicates_; ++r) {
        counts.push_back(Row(receiver, r)[std::size_t(column)]);
    }
    return FromCounts(counts, points_, confidence);
}

Measured EscapeCounts::Bounce(std::int64_t receiver, int k, double confidence) const {
    assert(0 <= k && k <= bounces_);
    return Column(receiver, k, confidence);
}

Measured EscapeCounts::UnderWay(std::int64_t receiver, double confidence) const {
    return Column(receiver, bounces_ + 1, confidence);
}

Measured EscapeCounts::LostShare(std::int64_t receiver, double confidence) const {
    return Column(receiver, bounces_ + 2, confidence);
}

Measured EscapeCounts::Total(std::int64_t receiver, Albedo rho, double confidence) const {
    std::vector<double> low, high;
    SampleSpread spread_low, spread_high;
    const auto add = [](SampleSpread& spread, double x, std::uint32_t walks) {
        if (walks > 0) spread.Add(x, walks);
    };
    for (int r = 0; r < replicates_; ++r) {
        const std::span<const std::uint32_t> row = Row(receiver, r);
        double sum = 0, weight = 1;
        for (int k = 0; k <= bounces_; ++k, weight *= rho.value) {
            sum += weight * row[std::size_t(k)];
            add(spread_low, weight, row[std::size_t(k)]);
        }
        const std::uint32_t under_way = row[std::size_t(bounces_) + 1];
        const std::uint32_t lost_walks = row[std::size_t(bounces_) + 2];
        low.push_back(sum);
        high.push_back(sum + weight * under_way + lost_walks);
        add(spread_high, weight, under_way);
        add(spread_high, 1, lost_walks);
        add(spread_low, 0, under_way + lost_walks);
        for (std::size_t k = 0; k <= std::size_t(bounces_); ++k) {
            add(spread_high, std::pow(rho.value, double(k)), row[k]);
        }
    }
    const Measured least = FromSums(low, points_, spread_low, confidence);
    const Measured most = FromSums(high, points_, spread_high, confidence);
    return {.value = (least.value + most.value) / 2,
            .standard_error = std::max(least.standard_error, most.standard_error),
            .interval = {.low = least.interval.low, .high = most.interval.high}};
}

void EscapeCounts::Merge(const EscapeCounts& later) {
    assert(later.counts_.size() == counts_.size() && later.bounces_ == bounces_);
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += later.counts_[i];
    points_ += later.points_;
    lost += later.lost;
}

EscapeCounts WalkToTheSky(const RayCaster& caster, const Mesh& mesh,
                          std::span<const Receiver> receivers, const WalkOptions& options,
                          Monitor& monitor) {
    Validate(options);
    EscapeCounts counts(std::int64_t(receivers.size()), options.sampling.replicates,
                        options.bounces, options.sampling.points);
    std::mutex mutex;
    ParallelFor(
        std::int64_t(receivers.size()), kReceiversPerChunk,
        [&](std::int64_t begin, std::int64_t end) {
            InParts(options.sampling, monitor, [&](const NetSampling& part) {
                WalkOptions of_part = options;
                of_part.sampling = part;
                Walker walker(caster, mesh, of_part, monitor);
                for (std::int64_t i = begin; i < end; ++i) {
                    walker.Walk(receivers[std::size_t(i)], i, counts);
                }
                const std::lock_guard lock(mutex);
                counts.lost += walker.GetLost();
            });
        },
        monitor, "walks");
    return counts;
}

}  // namespace plumb
