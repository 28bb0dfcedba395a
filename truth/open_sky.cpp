#include "truth/open_sky.h"

#include <cassert>
#include <cmath>
#include <mutex>

#include "core/error.h"
#include "core/parallel.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "truth/leave_surface.h"

namespace plumb {
namespace {

constexpr std::int64_t kReceiversPerChunk = 16;

// Works through the receivers of one chunk; keeps its memory from one to the next.
class Counter {
  public:
    Counter(const RayCaster& caster, const Mesh& mesh, const OpenSkyOptions& options)
        : caster_(caster), mesh_(mesh), options_(options) {}

    void Count(const Receiver& receiver, std::int64_t number, std::span<std::uint32_t> open) {
        const NetSampling& sampling = options_.sampling;
        const std::size_t n = std::size_t(sampling.points);
        const Triangle triangle = TriangleOf(mesh_, receiver.triangle);
        const Basis frame(receiver.Normal(triangle));
        directions_.resize(n * open.size());
        if (receiver.spread) rays_.resize(directions_.size());
        Ray start;
        if (!receiver.spread) start = Start(triangle, receiver, frame, Vec2::Zero());
        std::size_t next = 0;
        for (int r = 0; r < int(open.size()); ++r) {
            const std::uint64_t net = NetSeed(sampling.seed, number, r);
            for (std::size_t s = 0; s < n; ++s, ++next) {
                const std::uint32_t index = std::uint32_t(sampling.first + std::int64_t(s));
                const Vec2 u = SobolOwenPair(index, kFirstDirection, net);
                const Vec3 w = options_.weighting == HemisphereWeight::kCosine
                                   ? SampleCosineHemisphere(u)
                                   : SampleUniformHemisphere(u);
                directions_[next] = frame.ToWorld(w).cast<float>();
                if (!receiver.spread) continue;
                rays_[next] =
                    Start(triangle, receiver, frame, SobolOwenPair(index, kPlace, net));
                rays_[next].direction = directions_[next];
            }
        }
        met_.resize(BitWords(directions_.size()));
        if (receiver.spread) {
            caster_.Any(rays_, met_);
        } else {
            caster_.AnyFromPoint(start, directions_, met_);
        }
        for (std::size_t i = 0; i < directions_.size(); ++i) {
            if ((met_[i / 64] >> (i % 64)) & 1) continue;
            if (!directions_[i].allFinite()) {
                ++lost_.not_a_number;
            } else if (!LeadsToSky(options_.sky, directions_[i].z())) {
                ++lost_.not_sky;
            } else {
                ++open[i / n];
            }
        }
    }

    const Lost& GetLost() const { return lost_; }

  private:
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
            Counter counter(caster, mesh, options);
            for (std::int64_t i = begin; i < end; ++i) {
                counter.Count(receivers[std::size_t(i)], i,
                              std::span(counts.open).subspan(std::size_t(i) * R, R));
            }
            const std::lock_guard lock(mutex);
            counts.lost += counter.GetLost();
        },
        monitor, "sky visibility");
    return counts;
}

}  // namespace plumb
