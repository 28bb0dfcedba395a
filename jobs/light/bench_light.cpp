#include "jobs/light/bench_light.h"

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "core/warp.h"
#include "heightfield/facet.h"
#include "heightfield/ray_cast.h"
#include "jobs/light/convergence_study.h"
#include "truth/embree_caster.h"

namespace plumb {
namespace {

constexpr int kConvergenceTexels = 64;

double Median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

// The same rays for both casters.
struct CastRays {
    std::vector<std::int64_t> facet;
    std::vector<Vec3> origin_m, direction;  // Double, from texel (0, 0).
    std::vector<Ray> embree;                // Float, off the surface.
};

// The usual offset of 32 epsilon along the normal: bench rays need to be alike, not exact.
Ray OffSurface(const Vec3& x, const Vec3& n, const Vec3& d) {
    const double h = 32 * 0x1p-23 * x.cwiseAbs().maxCoeff();
    Ray ray;
    ray.origin_m = (x + h * n).cast<float>();
    ray.near = float(h);
    ray.direction = d.cast<float>();
    return ray;
}

CastRays MakeRays(const HeightField& field, const LightBenchSettings& s) {
    CastRays rays;
    RayOptions options;
    options.rays = s.casting_rays;
    options.distribution = RayDistribution::kCosine;
    const Vec3 corner(0.5 * field.SpacingXM(), 0.5 * field.SpacingYM(), 0);
    const std::int64_t facets = std::min(s.casting_facets, field.Facets());
    for (std::int64_t k = 0; k < facets; ++k) {
        const std::int64_t number = k * field.Facets() / facets;
        const Facet facet = FacetOf(field, number);
        const Basis basis(facet.normal);
        for (int r = 0; r < s.casting_rays; ++r) {
            const Vec3 x =
                OriginM(facet, Origins::kSpread, options.seed, number, std::uint32_t(r));
            const Vec3 d = basis.ToWorld(RayDirection(options, number, std::uint32_t(r)));
            rays.facet.push_back(number);
            rays.origin_m.push_back(x - corner);
            rays.direction.push_back(d);
            rays.embree.push_back(OffSurface(x, facet.normal, d));
        }
    }
    return rays;
}

CastingBench BenchCasting(const HeightField& field, const LightBenchSettings& s,
                          const Clock& clock) {
    const bool endless = field.GetBoundary() != Boundary::kOpen;
    const EmbreeCaster embree(ToMesh(field, endless ? 1 : 0));
    const CastRays rays = MakeRays(field, s);
    const EmbreeBareLoop loop(embree, rays.embree);
    const WalkGrid grid(field);
    const double far_m = FarDistanceM(field);
    const std::size_t n = rays.facet.size();
    std::vector<std::int64_t> met(n);
    std::vector<double> walk_s, embree_s, ratio;
    for (int round = 0; round <= s.rounds; ++round) {
        const double begin_s = clock();
        for (std::size_t i = 0; i < n; ++i) {
            met[i] =
                CastFromFacet(grid, rays.facet[i], rays.origin_m[i], rays.direction[i], far_m);
        }
        const double middle_s = clock();
        loop.Closest(0, n);
        const double end_s = clock();
        if (round == 0) continue;
        walk_s.push_back(middle_s - begin_s);
        embree_s.push_back(end_s - middle_s);
        ratio.push_back(walk_s.back() / embree_s.back());
    }

    CastingBench bench;
    bench.rays = std::int64_t(n);
    bench.walk_rays_per_second = double(n) / Median(walk_s);
    bench.embree_rays_per_second = double(n) / Median(embree_s);
    bench.time_ratio = Median(ratio);
    bench.time_ratio_low = *std::min_element(ratio.begin(), ratio.end());
    bench.time_ratio_high = *std::max_element(ratio.begin(), ratio.end());

    std::vector<Hit> hits(n);
    embree.Closest(rays.embree, hits);
    const int columns = (endless ? 3 : 1) * field.CellsX();
    std::int64_t agree = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (!hits[i].Met()) {
            agree += met[i] == kSky;
            continue;
        }
        const int quad = int(hits[i].triangle / 2);
        const int column = quad % columns % field.CellsX(),
                  row = quad / columns % field.CellsY();
        agree += met[i] >= 0 && met[i] / 2 == std::int64_t(row) * field.CellsX() + column;
    }
    bench.agreement = double(agree) / double(n);
    return bench;
}

SimulationBench BenchSimulation(const Surface& surface, LinkMethod method,
                                const LightBenchSettings& s, const Clock& clock,
                                const PeakMemory& peak_memory, Monitor& monitor) {
    SimulateSettings settings;
    settings.method = method;
    settings.slices.slices = s.slices;
    settings.rays.rays = s.rays;
    settings.bounces = s.bounces;
    settings.check_furnace = false;
    Timings timings;
    const double begin_s = clock();
    const SurfaceLight light =
        SimulateSurface(surface.source.name, surface.field, settings, monitor, &timings, clock);
    SimulationBench bench;
    bench.total_s = clock() - begin_s;
    bench.method = SamplingOf(settings).method;
    bench.per_facet = SamplingOf(settings).per_facet;
    for (const StageTiming& stage : timings.stages) {
        if (stage.stage == "links") bench.links_s = stage.seconds;
        if (stage.stage == "bounces") bench.bounces_s = stage.seconds;
    }
    bench.units_per_second = double(surface.field.Facets()) * bench.per_facet / bench.links_s;
    bench.links = light.links;
    bench.bytes_per_link =
        double(light.link_bytes) / double(std::max<std::int64_t>(1, light.links));
    bench.peak_memory_bytes = peak_memory();
    return bench;
}

// Bytes a second of one bounce over links made with few slices, and of copying as many bytes.
void BenchStreams(const Surface& surface, const LightBenchSettings& s, const Clock& clock,
                  LightBench& bench, Monitor& monitor) {
    const Links links =
        LinksBySlices(surface.field, {.slices = std::min(8, s.slices)}, monitor);
    std::vector<double> E = links.V;
    std::vector<char> from(links.MemoryBytes() / 2, 1), to(from.size());
    std::vector<double> gather_s, copy_s;
    constexpr std::int64_t kChunk = 1 << 20;
    for (int round = 0; round <= s.rounds; ++round) {
        const double begin_s = clock();
        E = Gather(links, E, monitor);
        const double middle_s = clock();
        ParallelFor(
            std::int64_t(from.size()), kChunk, [&](std::int64_t begin, std::int64_t end) {
                std::memcpy(to.data() + begin, from.data() + begin, std::size_t(end - begin));
            });
        const double end_s = clock();
        if (round == 0) continue;
        gather_s.push_back(middle_s - begin_s);
        copy_s.push_back(end_s - middle_s);
    }
    bench.gather_bytes_per_second = double(links.MemoryBytes()) / Median(gather_s);
    bench.copy_bytes_per_second = 2 * double(from.size()) / Median(copy_s);
}

}  // namespace

LightBench BenchLight(const Surface& surface, const LightBenchSettings& settings,
                      const Clock& clock, const PeakMemory& peak_memory, Monitor& monitor) {
    LightBench bench;
    bench.map = surface.source.name;
    bench.width_texels = surface.field.Width();
    bench.height_texels = surface.field.Height();
    bench.facets = surface.field.Facets();
    bench.threads = ThreadCount();
    bench.bounces = settings.bounces;
    for (const LinkMethod method : {LinkMethod::kSlices, LinkMethod::kRays}) {
        bench.simulations.push_back(
            BenchSimulation(surface, method, settings, clock, peak_memory, monitor));
    }
    bench.casting = BenchCasting(surface.field, settings, clock);
    BenchStreams(surface, settings, clock, bench, monitor);
    if (settings.study_convergence) {
        bench.convergence =
            StudyConvergence(bench.map, MiddleOf(surface.field, kConvergenceTexels),
                             {.runs = settings.rounds}, clock, monitor);
    }
    return bench;
}

}  // namespace plumb
