#include "jobs/light/bench_light.h"

#include <algorithm>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "core/warp.h"
#include "heightfield/facet.h"
#include "heightfield/ray_cast.h"
#include "jobs/bench_facts.h"
#include "jobs/light/amplitude_study.h"
#include "jobs/light/convergence_study.h"
#include "jobs/memory_copy.h"
#include "rays/embree/embree_caster.h"

namespace plumb {
namespace {

constexpr int kConvergenceTexels = 64;

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

// Share of the rays that both send to the same cell or to the sky.
double Agreement(const HeightField& field, const CastRays& rays,
                 std::span<const std::int64_t> met, const EmbreeCaster& embree, bool endless) {
    std::vector<Hit> hits(met.size());
    embree.Closest(rays.embree, hits);
    const int columns = (endless ? 3 : 1) * field.CellsX();
    std::int64_t agree = 0;
    for (std::size_t i = 0; i < met.size(); ++i) {
        if (!hits[i].Met()) {
            agree += met[i] == kSky;
            continue;
        }
        const int quad = int(hits[i].triangle / 2);
        const int column = quad % columns % field.CellsX(),
                  row = quad / columns % field.CellsY();
        agree += met[i] >= 0 && met[i] / 2 == std::int64_t(row) * field.CellsX() + column;
    }
    return double(agree) / double(met.size());
}

doc::Section BenchCasting(const HeightField& field, const LightBenchSettings& s,
                          const RunContext& run) {
    const bool endless = field.GetBoundary() != Boundary::kOpen;
    const EmbreeCaster embree(ToMesh(field, endless ? 1 : 0));
    const CastRays rays = MakeRays(field, s);
    const EmbreeBareLoop loop(embree, rays.embree);
    const WalkGrid grid(field);
    const double far_m = FarDistanceM(field);
    const std::size_t n = rays.facet.size();
    std::vector<std::int64_t> met(n);
    const TurnTimes times =
        TimeInTurns({{.run =
                          [&] {
                              for (std::size_t i = 0; i < n; ++i) {
                                  met[i] = CastFromFacet(grid, rays.facet[i], rays.origin_m[i],
                                                         rays.direction[i], far_m);
                              }
                          }},
                     {.run = [&] { loop.Closest(0, n); }}},
                    s.rounds, run.clock, run.monitor);

    doc::Table table{.key = "casting",
                     .columns = {{.key = "caster", .title = "Caster", .role = doc::Role::kName},
                                 TimeColumn("mrays_per_s", "Million rays a second", "M/s",
                                            doc::Better::kMore),
                                 TimeColumn("of_embree", "Time over that of Embree", "",
                                            doc::Better::kLess, "Round by round.")}};
    table.Add({"facet walk", 1e-6 * times.Rate(0, double(n)), times.Ratio(0, 1)});
    table.Add({"Embree rtcIntersect1", 1e-6 * times.Rate(1, double(n)), times.Ratio(1, 1)});
    return {
        .id = "casting",
        .title = "Casting rays, one thread",
        .facts = {{{.key = "casting_rays", .title = "Rays, cosine-weighted"}, std::int64_t(n)},
                  {{.key = "agreement",
                    .title = "Same cell, or both the sky",
                    .digits = 5,
                    .better = doc::Better::kMore,
                    .meaning = "Share of the rays. Embree sees float coordinates and a "
                               "surface that ends one tile beyond the middle one."},
                   Agreement(field, rays, met, embree, endless)}},
        .tables = {std::move(table)}};
}

doc::Section BenchSimulations(const Surface& surface, const LightBenchSettings& s,
                              const PeakMemory& peak_memory, const RunContext& run) {
    struct Simulated {
        SimulateSettings settings = {};
        std::int64_t links = 0;
        double bytes_per_link = 0;
        double peak_bytes = 0;  // Once the first run is over.
    };
    std::vector<Simulated> simulated(2);
    std::vector<SelfTimed> things;
    for (Simulated& one : simulated) {
        one.settings.method =
            &one == simulated.data() ? LinkMethod::kSlices : LinkMethod::kRays;
        one.settings.slices.slices = s.slices;
        one.settings.rays.rays = s.rays;
        one.settings.bounces = s.bounces;
        one.settings.check_furnace = false;
        things.push_back([&one, &surface, &peak_memory, &run] {
            Timings timings;
            const double begin_s = run.clock();
            const SurfaceLight light =
                SimulateSurface(surface.source.name, surface.field, one.settings, run.monitor,
                                &timings, run.clock);
            const double total_s = run.clock() - begin_s;
            one.links = light.links;
            one.bytes_per_link =
                double(light.link_bytes) / double(std::max<std::int64_t>(1, light.links));
            if (one.peak_bytes == 0) one.peak_bytes = peak_memory();
            double links_s = 0, bounces_s = 0;
            for (const StageTiming& stage : timings) {
                if (stage.stage == "links") links_s = stage.seconds;
                if (stage.stage == "bounces") bounces_s = stage.seconds;
            }
            return std::vector<double>{links_s, bounces_s, total_s - links_s - bounces_s};
        });
    }
    const TurnTimes times = TakeTurns(things, s.rounds, run.monitor);

    using doc::Better, doc::Role;
    doc::Table table{
        .key = "simulations",
        .columns = {{.key = "method", .title = "Method", .role = Role::kName},
                    {.key = "per_facet", .title = "A facet", .role = Role::kName},
                    TimeColumn("links_s", "Links", "s"),
                    TimeColumn("bounces_s", "Bounces", "s"),
                    TimeColumn("total_s", "All", "s"),
                    TimeColumn("m_per_s", "Slices or rays", "M/s", Better::kMore,
                               "While links are made."),
                    {.key = "links", .title = "Links"},
                    {.key = "bytes_per_link", .title = "Bytes a link", .better = Better::kLess},
                    TimeColumn("peak_gib", "Peak memory", "GiB", Better::kLess,
                               "Of the process, up to the end of the first such simulation.")}};
    for (std::size_t k = 0; k < simulated.size(); ++k) {
        const Simulated& one = simulated[k];
        const Sampling sampling = SamplingOf(one.settings);
        const double units = double(surface.field.Facets()) * sampling.per_facet;
        const Measured links_s = times.SecondsOfPart(k, 0);
        table.Add({sampling.method, sampling.per_facet, links_s, times.SecondsOfPart(k, 1),
                   times.Seconds(k), 1e-6 * PerSecond(units, links_s), one.links,
                   one.bytes_per_link, one.peak_bytes / (1024.0 * 1024 * 1024)});
    }
    return {.id = "simulations", .title = "Whole simulations", .tables = {std::move(table)}};
}

// One bounce over links made with few slices, beside a copy of as many bytes.
doc::Section BenchStreams(const Surface& surface, const LightBenchSettings& s,
                          const RunContext& run) {
    SimulateSettings few;
    few.slices.slices = std::min(8, s.slices);
    const Links links =
        MakeLinksOf(surface.field, FacetPieces(surface.field, few.cut), few, run.monitor);
    std::vector<double> E = links.V;
    MemoryCopy copy(links.MemoryBytes());
    const TurnTimes times = TimeInTurns(
        {{.run = [&] { E = Gather(links, E, run.monitor); }}, {.run = std::ref(copy)}},
        s.rounds, run.clock, run.monitor);
    doc::Table table{
        .key = "streams",
        .columns = {{.key = "stream", .title = "Stream", .role = doc::Role::kName},
                    TimeColumn("gb_per_s", "Bytes a second", "GB/s", doc::Better::kMore),
                    TimeColumn("of_copy", "Time over that of the copy", "")}};
    table.Add({"one bounce, its links", 1e-9 * times.Rate(0, double(links.MemoryBytes())),
               times.Ratio(0, 1)});
    table.Add(
        {"a copy, read and written", 1e-9 * times.Rate(1, copy.Bytes()), times.Ratio(1, 1)});
    return {.id = "streams",
            .title = "One bounce beside copying memory, all threads",
            .tables = {std::move(table)}};
}

}  // namespace

doc::Document BenchLight(const Surface& surface, const LightBenchSettings& settings,
                         const PeakMemory& peak_memory, const RunContext& run) {
    const HeightField& field = surface.field;
    const std::string& name = surface.source.name;
    doc::Document document{.kind = "bench_light",
                           .title = "Speed of the light simulation: " + name,
                           .subtitle = std::to_string(field.Width()) + " x " +
                                       std::to_string(field.Height()) + " texels, " +
                                       std::to_string(field.Facets()) + " facets, " +
                                       std::to_string(settings.bounces) + " bounces",
                           .provenance = doc::ProvenanceOf(run)};
    document.provenance.inputs = {{name, surface.source.sha256}};
    document.sections = {BenchSimulations(surface, settings, peak_memory, run),
                         BenchCasting(field, settings, run),
                         BenchStreams(surface, settings, run)};
    document.sections[0].facts = BenchFacts(ThreadCount(), settings.rounds);
    if (settings.study_convergence) {
        document.sections.push_back(ConvergenceSection(StudyConvergence(
            NameOfMiddle(name, field, kConvergenceTexels), MiddleOf(field, kConvergenceTexels),
            {.rounds = settings.rounds}, run.clock, run.monitor)));
        document.sections.back().facts.clear();  // Threads are said above.
    }
    return document;
}

}  // namespace plumb
