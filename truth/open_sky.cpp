#include "truth/open_sky.h"

#include <array>
#include <cassert>
#include <cmath>
#include <mutex>

#include "core/error.h"
#include "core/parallel.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "rays/leave_surface.h"
#include "truth/cosine_directions.h"

namespace plumb {
namespace {

constexpr std::int64_t kReceiversPerChunk = 16;

// Works through the receivers of one chunk; keeps its memory from one to the next.
class Counter {
  public:
    Counter(const RayCaster& caster, const Mesh& mesh, const OpenSkyOptions& options)
        : caster_(caster), mesh_(mesh), options_(options) {
        static_assert(2 * kFirstDirection + 1 < kSobolDimensions);
        for (std::int64_t s = 0; s < options.sampling.points; ++s) {
            const std::uint32_t index = std::uint32_t(options.sampling.first + s);
            digits_.first.push_back(SobolReversed(index, 2 * kFirstDirection));
            digits_.second.push_back(SobolReversed(index, 2 * kFirstDirection + 1));
        }
    }

    void Count(const Receiver& receiver, std::int64_t number, std::span<std::uint32_t> open) {
        const NetSampling& sampling = options_.sampling;
        const std::size_t n = std::size_t(sampling.points);
        const Triangle triangle = TriangleOf(mesh_, receiver.triangle);
        const Basis frame(receiver.Normal(triangle));
        directions_.resize(n * open.size());
        if (receiver.spread) rays_.resize(directions_.size());
        Ray start;
        if (!receiver.spread) start = Start(triangle, receiver, frame, Vec2::Zero());
        for (std::size_t r = 0; r < open.size(); ++r) {
            const std::uint64_t net = NetSeed(sampling.seed, number, int(r));
            MakeDirections(net, frame, std::span(directions_).subspan(r * n, n));
            if (!receiver.spread) continue;
            for (std::size_t s = 0; s < n; ++s) {
                const std::uint32_t index = std::uint32_t(sampling.first + std::int64_t(s));
                Ray& ray = rays_[r * n + s];
                ray = Start(triangle, receiver, frame, SobolOwenPair(index, kPlace, net));
                ray.direction = directions_[r * n + s];
            }
        }
        met_.resize(BitWords(directions_.size()));
        if (receiver.spread) {
            caster_.Any(rays_, met_);
        } else {
            caster_.AnyFromPoint(start, directions_, met_);
        }
        const bool all_finite = frame.s.allFinite() && frame.n.allFinite();
        const bool sky_everywhere = all_finite && options_.sky == Sky::kAllAround;
        std::size_t i = 0;
        for (std::uint32_t& of_net : open) {
            for (std::size_t s = 0; s < n; ++s, ++i) {
                const bool met = (met_[i / 64] >> (i % 64)) & 1;
                of_net += !met && (sky_everywhere || IsSky(directions_[i]));
            }
        }
    }

    const Lost& GetLost() const { return lost_; }

  private:
    void MakeDirections(std::uint64_t net, const Basis& frame, std::span<Vec3f> out) const {
        if (options_.weighting == HemisphereWeight::kCosine) {
            CosineDirections(digits_, net, kFirstDirection, frame, out);
            return;
        }
        const std::uint64_t key_0 = SobolOwenKey(2 * kFirstDirection, net);
        const std::uint64_t key_1 = SobolOwenKey(2 * kFirstDirection + 1, net);
        for (std::size_t s = 0; s < out.size(); ++s) {
            // SobolOwenPair(index, kFirstDirection, net), with what nets share made once.
            const Vec2 u(ScrambleReversed(digits_.first[s], key_0),
                         ScrambleReversed(digits_.second[s], key_1));
            out[s] = frame.ToWorld(SampleUniformHemisphere(u)).cast<float>();
        }
    }

    // Of a direction in which nothing is met; counts what is lost.
    bool IsSky(const Vec3f& direction) {
        if (!direction.allFinite()) {
            ++lost_.not_a_number;
            return false;
        }
        const bool sky = LeadsToSky(options_.sky, direction.z());
        lost_.not_sky += !sky;
        return sky;
    }

    Ray Start(const Triangle& triangle, const Receiver& receiver, const Basis& frame,
              const Vec2& u) const {
        const Vec2 b = receiver.Place(u);
        Ray ray = LeaveSurface(triangle, b.x(), b.y(), frame.n);
        ray.far = float(options_.reach_m);
        return ray;
    }

    const RayCaster& caster_;
    const Mesh& mesh_;
    const OpenSkyOptions& options_;
    PairDigits digits_;
    std::vector<Vec3f> directions_;
    std::vector<Ray> rays_;
    std::vector<std::uint64_t> met_;
    Lost lost_;
};

}  // namespace

void Validate(const OpenSkyOptions& options) {
    Validate(options.sampling);
    if (!(options.reach_m > 0)) {
        throw Error(MustBe("OpenSkyOptions::reach_m", options.reach_m, "> 0"));
    }
}

Measured OpenCounts::Of(std::int64_t receiver, double confidence) const {
    return FromCounts({&open[std::size_t(receiver * replicates)], std::size_t(replicates)},
                      points, confidence);
}

void OpenCounts::Merge(const OpenCounts& later) {
    assert(later.open.size() == open.size() && later.replicates == replicates);
    for (std::size_t i = 0; i < open.size(); ++i) open[i] += later.open[i];
    points += later.points;
    lost += later.lost;
}

OpenCounts CountOpenSky(const RayCaster& caster, const Mesh& mesh,
                        std::span<const Receiver> receivers, const OpenSkyOptions& options,
                        Monitor& monitor) {
    Validate(options);
    const std::size_t R = std::size_t(options.sampling.replicates);
    OpenCounts counts{.replicates = int(R),
                      .points = options.sampling.points,
                      .open = std::vector<std::uint32_t>(receivers.size() * R),
                      .lost = {}};
    std::mutex mutex;
    ParallelFor(
        std::int64_t(receivers.size()), kReceiversPerChunk,
        [&](std::int64_t begin, std::int64_t end) {
            InParts(options.sampling, monitor, [&](const NetSampling& part) {
                OpenSkyOptions of_part = options;
                of_part.sampling = part;
                Counter counter(caster, mesh, of_part);
                for (std::int64_t i = begin; i < end; ++i) {
                    counter.Count(receivers[std::size_t(i)], i,
                                  std::span(counts.open).subspan(std::size_t(i) * R, R));
                }
                const std::lock_guard lock(mutex);
                counts.lost += counter.GetLost();
            });
        },
        monitor, "sky visibility");
    return counts;
}

}  // namespace plumb
