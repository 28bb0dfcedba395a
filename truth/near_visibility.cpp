#include "truth/near_visibility.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "rays/leave_surface.h"

namespace plumb {

double OpennessAt(double d_m, double reach_m, Falloff falloff) {
    if (d_m >= reach_m) return 1;
    const double x = d_m / reach_m;
    switch (falloff) {
        case Falloff::kHard:
            return 0;
        case Falloff::kLinear:
            return x;
        case Falloff::kSao:
            return 1 - std::pow(1 - x * x, 3);
        case Falloff::kQuadratic:
            return x * x;
        case Falloff::kFarEnd:
            return std::max(0.0, (x - kFarEndStart) / (1 - kFarEndStart));
    }
    return 1;
}

void Validate(const NearOptions& options) {
    Validate(options.sampling);
    if (!(options.reach_m > 0 && std::isfinite(options.reach_m))) {
        throw Error(MustBe("NearOptions::reach_m", options.reach_m, "in (0, infinity)"));
    }
}

Measured NearSums::Of(std::int64_t receiver, double confidence) const {
    return FromSums({&sum[std::size_t(receiver * replicates)], std::size_t(replicates)}, points,
                    spread[std::size_t(receiver)], confidence);
}

void NearSums::Merge(const NearSums& later) {
    assert(later.sum.size() == sum.size() && later.replicates == replicates);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += later.sum[i];
    for (std::size_t i = 0; i < spread.size(); ++i) spread[i].Merge(later.spread[i]);
    points += later.points;
}

std::vector<NearSums> MeasureNearEach(const RayCaster& caster, const Mesh& mesh,
                                      std::span<const Receiver> receivers,
                                      const NearOptions& options,
                                      std::span<const Falloff> falloffs, Monitor& monitor) {
    Validate(options);
    const NetSampling& sampling = options.sampling;
    const std::size_t R = std::size_t(sampling.replicates);
    std::vector<NearSums> sums(falloffs.size(),
                               NearSums{.replicates = int(R),
                                        .points = sampling.points,
                                        .sum = std::vector<double>(receivers.size() * R),
                                        .spread = std::vector<SampleSpread>(receivers.size())});
    ParallelFor(
        std::int64_t(receivers.size()), 16,
        [&](std::int64_t begin, std::int64_t end) {
            std::vector<Ray> rays;
            std::vector<Hit> hits;
            const auto measure = [&](const NetSampling& part, std::size_t i) {
                const Triangle triangle = TriangleOf(mesh, receivers[i].triangle);
                const Basis frame(receivers[i].Normal(triangle));
                rays.resize(std::size_t(part.points));
                hits.resize(rays.size());
                for (std::size_t r = 0; r < R; ++r) {
                    const std::uint64_t net = NetSeed(part.seed, std::int64_t(i), int(r));
                    for (std::size_t s = 0; s < rays.size(); ++s) {
                        const std::uint32_t index = std::uint32_t(part.first + std::int64_t(s));
                        const Vec2 b = receivers[i].Place(SobolOwenPair(index, kPlace, net));
                        rays[s] = LeaveSurface(triangle, b.x(), b.y(), frame.n);
                        rays[s].far = float(options.reach_m);
                        const Vec3 w =
                            SampleCosineHemisphere(SobolOwenPair(index, kFirstDirection, net));
                        rays[s].direction = frame.ToWorld(w).cast<float>();
                    }
                    caster.Closest(rays, hits);
                    for (std::size_t k = 0; k < falloffs.size(); ++k) {
                        for (const Hit& hit : hits) {
                            const double g =
                                hit.Met() ? OpennessAt(hit.t, options.reach_m, falloffs[k]) : 1;
                            sums[k].sum[i * R + r] += g;
                            sums[k].spread[i].Add(g);
                        }
                    }
                }
            };
            InParts(sampling, monitor, [&](const NetSampling& part) {
                for (std::int64_t i = begin; i < end; ++i) measure(part, std::size_t(i));
            });
        },
        monitor, "near visibility");
    return sums;
}

NearSums MeasureNear(const RayCaster& caster, const Mesh& mesh,
                     std::span<const Receiver> receivers, const NearOptions& options,
                     Monitor& monitor) {
    return std::move(
        MeasureNearEach(caster, mesh, receivers, options, {&options.falloff, 1}, monitor)
            .front());
}

}  // namespace plumb
