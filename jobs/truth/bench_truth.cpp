#include "jobs/truth/bench_truth.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/sobol.h"
#include "core/time_in_turns.h"
#include "core/warp.h"
#include "jobs/bench_facts.h"
#include "rays/embree/embree_caster.h"
#include "rays/leave_surface.h"
#include "truth/escape_walk.h"
#include "truth/open_sky.h"
#include "truth/pixels.h"

namespace plumb {
namespace {

constexpr NetSampling kSpeedSampling{.replicates = 8, .points = 8};
constexpr int kRays = 64;  // Of both counts above.
constexpr std::int64_t kReceiversPerChunk = 16;

// The rays of CountOpenSky for V of points, made again: nothing is taken from its insides.
std::vector<Ray> RaysOfV(const Mesh& mesh, std::span<const Receiver> receivers) {
    std::vector<Ray> rays;
    rays.reserve(receivers.size() * kRays);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Triangle triangle = TriangleOf(mesh, receivers[i].triangle);
        const Basis frame(receivers[i].Normal(triangle));
        Ray ray = LeaveSurface(triangle, receivers[i].b_1, receivers[i].b_2, frame.n);
        for (int r = 0; r < kSpeedSampling.replicates; ++r) {
            const std::uint64_t net = NetSeed(kSpeedSampling.seed, std::int64_t(i), r);
            for (std::uint32_t s = 0; s < kSpeedSampling.points; ++s) {
                const Vec2 u = SobolOwenPair(s, kFirstDirection, net);
                ray.direction = frame.ToWorld(SampleCosineHemisphere(u)).cast<float>();
                rays.push_back(ray);
            }
        }
    }
    return rays;
}

class SpeedBench {
  public:
    SpeedBench(const EmbreeCaster& caster, const Mesh& mesh,
               std::span<const Receiver> receivers, const RunContext& run)
        : caster_(caster),
          mesh_(mesh),
          receivers_(receivers),
          run_(run),
          bare_(caster, RaysOfV(mesh, receivers)) {}

    std::vector<doc::Cell> Run(int threads, int rounds) {
        SetThreadCount(threads);
        const TurnTimes times =
            TimeInTurns({{.run = [&] { open_ = Measure(); }},
                         {.run =
                              [&] {
                                  met_ = Loop([&](std::size_t begin, std::size_t end) {
                                      return bare_.AnyStream(begin, end, kRays);
                                  });
                              },
                          .prepare = [&] { bare_.Refill(); }},
                         {.run =
                              [&] {
                                  Loop([&](std::size_t begin, std::size_t end) {
                                      return bare_.Any(begin, end);
                                  });
                              }}},
                        rounds, run_.clock, run_.monitor);
        const double n = double(receivers_.size()) * kRays;
        return {threads, 1e-6 * times.Rate(0, n), 1e-6 * times.Rate(1, n),
                1e-6 * times.Rate(2, n), times.Ratio(1, 0)};
    }

    std::int64_t DifferingRays() const {
        return std::abs(std::int64_t(receivers_.size()) * kRays - open_ - met_);
    }

  private:
    std::int64_t Measure() const {
        const OpenCounts counts = CountOpenSky(caster_, mesh_, receivers_,
                                               {.sampling = kSpeedSampling}, run_.monitor);
        return std::accumulate(counts.open.begin(), counts.open.end(), std::int64_t{0});
    }

    // The bare loop over all rays, in the chunks that the measurement is cut into.
    template <class F>
    std::int64_t Loop(const F& met_of) const {
        std::vector<std::int64_t> met(receivers_.size() / kReceiversPerChunk + 1);
        ParallelFor(std::int64_t(receivers_.size()), kReceiversPerChunk,
                    [&](std::int64_t begin, std::int64_t end) {
                        met[std::size_t(begin / kReceiversPerChunk)] =
                            met_of(std::size_t(begin) * kRays, std::size_t(end) * kRays);
                    });
        return std::accumulate(met.begin(), met.end(), std::int64_t{0});
    }

    const EmbreeCaster& caster_;
    const Mesh& mesh_;
    std::span<const Receiver> receivers_;
    const RunContext& run_;
    EmbreeBareLoop bare_;
    std::int64_t open_ = 0, met_ = 0;
};

// White noise five cells high within a rim: slopes up to 79 degrees, and no way out but up.
Mesh NoisyField(int cells) {
    const double height = 5.0 / cells;
    Mesh mesh;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i) {
            const bool rim = i == 0 || j == 0 || i == cells || j == cells;
            const double z = rim ? 1 : RandomUnit(9, std::uint64_t(i), std::uint64_t(j), 0);
            mesh.vertices_m.push_back(
                Vec3(double(i) / cells, double(j) / cells, height * z).cast<float>());
        }
    }
    const std::uint32_t columns = std::uint32_t(cells) + 1;
    for (std::uint32_t j = 0; j + 1 < columns; ++j) {
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = i + j * columns;
            mesh.quads.push_back({a, a + 1, a + columns + 1, a + columns});
        }
    }
    return mesh;
}

// Walks over a closed, noisy height field at albedo 1: each should come back.
doc::Section RunFurnace(std::int64_t wanted, Monitor& monitor) {
    constexpr int kCells = 1024, kBounces = 2000;
    constexpr int kReceivers = 250;
    constexpr NetSampling kSampling{.replicates = 8, .points = 512};
    constexpr std::int64_t kBatch = kReceivers * 8 * 512;
    const Mesh mesh = NoisyField(kCells);
    const EmbreeCaster caster(mesh);
    std::int64_t paths = 0, lost = 0, rescued = 0, under_way = 0;
    for (std::uint64_t batch = 0; paths < wanted; ++batch) {
        std::vector<Receiver> receivers;
        for (std::uint64_t i = 0; i < kReceivers; ++i) {
            const std::uint64_t bits = RandomBits(10, i, batch, 0);
            receivers.push_back({.triangle = std::uint32_t(bits % (2 * mesh.quads.size()))});
        }
        NetSampling sampling = kSampling;
        sampling.seed = batch;
        const EscapeCounts walks = WalkToTheSky(
            caster, mesh, receivers,
            {.sampling = sampling, .bounces = kBounces, .sky = Sky::kAbove, .two_sided = false},
            monitor);
        paths += kBatch;
        lost += walks.lost.All();
        rescued += walks.lost.rescued;
        for (std::int64_t i = 0; i < walks.Receivers(); ++i) {
            for (int r = 0; r < walks.Replicates(); ++r) {
                under_way += walks.Row(i, r)[kBounces + 1];
            }
        }
    }
    using doc::Better;
    return {.id = "furnace",
            .title = "Furnace: a closed, noisy field at albedo 1",
            .sentences = {"Each path should come back: " + std::to_string(kCells) + " x " +
                          std::to_string(kCells) + " cells, up to " + std::to_string(kBounces) +
                          " bounces."},
            .facts = {{{.key = "paths", .title = "Paths"}, paths},
                      {{.key = "deficit",
                        .title = "Deficit, a path",
                        .digits = 2,
                        .better = Better::kLess},
                       double(lost) / double(paths)},
                      {{.key = "lost",
                        .title = "Lost",
                        .better = Better::kLess,
                        .meaning = "NaN, met from behind, or gone where no sky is."},
                       lost},
                      {{.key = "rescued",
                        .title = "Rescued",
                        .meaning = "Got behind a surface, noticed, and started again."},
                       rescued},
                      {{.key = "under_way",
                        .title = "Under way",
                        .meaning = "After the last bounce followed; not lost."},
                       under_way}}};
}

// Open directions among the first n independent ones, for each n of `rays`.
std::vector<double> IndependentV(const EmbreeCaster& caster, const Mesh& mesh,
                                 const Receiver& receiver, std::uint64_t seed,
                                 std::span<const std::int64_t> rays) {
    const Triangle triangle = TriangleOf(mesh, receiver.triangle);
    const Basis frame(receiver.Normal(triangle));
    const Ray start = LeaveSurface(triangle, receiver.b_1, receiver.b_2, frame.n);
    std::vector<Vec3f> directions;
    for (std::int64_t s = 0; s < rays.back(); ++s) {
        const Vec2 u(RandomUnit(seed, 0, std::uint64_t(s), 0),
                     RandomUnit(seed, 0, std::uint64_t(s), 1));
        directions.push_back(frame.ToWorld(SampleCosineHemisphere(u)).cast<float>());
    }
    std::vector<std::uint64_t> met(BitWords(directions.size()));
    caster.AnyFromPoint(start, directions, met);
    std::vector<double> V;
    std::int64_t open = 0, s = 0;
    for (const std::int64_t n : rays) {
        for (; s < n; ++s) open += !((met[std::size_t(s) / 64] >> (s % 64)) & 1);
        V.push_back(double(open) / double(n));
    }
    return V;
}

// Of log y over log x, by least squares.
double Slope(std::span<const double> x, std::span<const double> y) {
    const double n = double(x.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double a = std::log(x[i]), b = std::log(y[i]);
        sx += a;
        sy += b;
        sxx += a * a;
        sxy += a * b;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

// RMS error of V against a reference, by samples of a receiver.
doc::Section StudyTruthConvergence(const EmbreeCaster& caster, const Mesh& mesh,
                                   std::span<const Receiver> receivers,
                                   std::int64_t reference_rays, Monitor& monitor) {
    constexpr int kReplicates = 8;
    const std::vector<std::int64_t> rays = {16, 64, 256, 1024, 4096};
    using doc::Better, doc::Role;
    doc::Table table{
        .key = "convergence",
        .columns = {
            {.key = "rays", .title = "Rays", .role = Role::kName},
            {.key = "rms_nets", .title = "Owen nets", .better = Better::kLess},
            {.key = "rms_independent", .title = "Independent", .better = Better::kLess}}};
    // Other seeds than those below: the reference must not share their errors.
    const OpenCounts reference = CountOpenSky(
        caster, mesh, receivers,
        {.sampling = {.replicates = 8, .points = reference_rays / 8, .seed = 77}}, monitor);
    std::vector<double> squares(rays.size());
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const double V = reference.Of(std::int64_t(i)).value;
        for (std::uint64_t r = 0; r < kReplicates; ++r) {
            const std::vector<double> estimates =
                IndependentV(caster, mesh, receivers[i], Absorb(i, r), rays);
            for (std::size_t k = 0; k < rays.size(); ++k) {
                squares[k] += std::pow(estimates[k] - V, 2);
            }
        }
    }
    std::vector<double> n, nets, independent;
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const OpenCounts counts = CountOpenSky(
            caster, mesh, receivers,
            {.sampling = {.replicates = kReplicates, .points = rays[k], .seed = 5}}, monitor);
        double sum = 0;
        for (std::size_t i = 0; i < counts.open.size(); ++i) {
            const double V = reference.Of(std::int64_t(i) / kReplicates).value;
            sum += std::pow(double(counts.open[i]) / double(rays[k]) - V, 2);
        }
        const double estimates = double(counts.open.size());
        n.push_back(double(rays[k]));
        nets.push_back(std::sqrt(sum / estimates));
        independent.push_back(std::sqrt(squares[k] / estimates));
        table.Add({rays[k], nets.back(), independent.back()});
    }
    return {.id = "convergence",
            .title = "RMS error of V against rays",
            .sentences = {std::to_string(receivers.size()) + " pixels, against " +
                          std::to_string(reference_rays) + " rays each."},
            .facts = {{{.key = "slope_nets",
                        .title = "Slope, Owen nets",
                        .better = Better::kLess,
                        .meaning = "Of log error over log rays."},
                       Slope(n, nets)},
                      {{.key = "slope_independent",
                        .title = "Slope, independent samples",
                        .better = Better::kLess,
                        .meaning = "Of log error over log rays; -1/2 is expected."},
                       Slope(n, independent)}},
            .tables = {std::move(table)}};
}

doc::Section SpeedSection(SpeedBench& speed, const TruthBenchSettings& settings) {
    using doc::Better;
    doc::Table table{
        .key = "speed",
        .columns = {{.key = "threads", .title = "Threads", .role = doc::Role::kName},
                    TimeColumn("mrays_per_s", "V, all of it", "Mrays/s", Better::kMore,
                               "Samples, rays, counts."),
                    TimeColumn("bare_stream_mrays_per_s", "Bare stream", "Mrays/s",
                               Better::kMore, "rtcOccluded1M, as many rays at once."),
                    TimeColumn("bare_single_mrays_per_s", "Bare, single", "Mrays/s",
                               Better::kMore, "rtcOccluded1, one after the other."),
                    TimeColumn("share", "Share of the stream", "", Better::kMore,
                               "Of the bare stream's speed, round by round.")}};
    for (const int threads : settings.threads) {
        table.Add(speed.Run(threads, settings.rounds));
    }
    return {.id = "speed",
            .title = "V of a view beside nothing but Embree's own calls over the same rays",
            .tables = {std::move(table)}};
}

}  // namespace

doc::Document BenchTruth(const LoadedScene& loaded, const TruthBenchSettings& settings,
                         const RunContext& run) {
    const Scene& scene = loaded.scene;
    Camera camera = CameraNamed(scene, settings.camera);
    camera.width_px = settings.width_px;
    camera.height_px = settings.height_px;
    Validate(camera, scene.name + ": camera " + camera.name);
    const EmbreeCaster caster(scene);
    const PixelGeometry pixels = LookThrough(caster, scene, camera);
    std::vector<Receiver> receivers;
    const int rows = std::clamp(settings.pixel_rows, 1, camera.height_px);
    for (std::size_t i = 0; i < pixels.receivers.size(); ++i) {
        const std::int64_t row = pixels.pixel_of_receiver[i] / std::uint32_t(camera.width_px);
        // The rows at which k / rows steps to the next whole number.
        if (row * rows / camera.height_px != (row + 1) * rows / camera.height_px) {
            receivers.push_back(pixels.receivers[i]);
        }
    }
    if (receivers.empty()) throw Error(scene.name + ": no pixel shows a surface, must");

    doc::Document document{.kind = "bench_truth",
                           .title = "Speed and certainty of the path tracer: " + scene.name,
                           .subtitle = "view " + camera.name + ", " +
                                       std::to_string(camera.width_px) + " x " +
                                       std::to_string(camera.height_px) + " pixels, " +
                                       std::to_string(caster.Counts().triangles) +
                                       " triangles; V of " + std::to_string(receivers.size()) +
                                       " pixels, " + std::to_string(kRays) + " rays each",
                           .provenance = doc::ProvenanceOf(run)};
    document.provenance.inputs = {{scene.name, loaded.digest}};
    const int threads = ThreadCount();
    SpeedBench speed(caster, scene.mesh, receivers, run);
    document.sections = {SpeedSection(speed, settings)};
    document.sections[0].facts = BenchFacts(threads, settings.rounds);
    document.sections[0].facts.push_back(
        {{.key = "pixels", .title = "Pixels"}, std::int64_t(receivers.size())});
    document.sections[0].facts.push_back({{.key = "differing_rays",
                                           .title = "Rays that the two see differently",
                                           .better = doc::Better::kLess},
                                          speed.DifferingRays()});
    SetThreadCount(threads);
    if (settings.furnace_paths > 0) {
        document.sections.push_back(RunFurnace(settings.furnace_paths, run.monitor));
    }

    constexpr std::size_t kStudied = 96;
    std::vector<Receiver> studied;
    for (std::size_t k = 0; k < std::min(kStudied, receivers.size()); ++k) {
        studied.push_back(receivers[k * receivers.size() / kStudied]);
    }
    document.sections.push_back(StudyTruthConvergence(caster, scene.mesh, studied,
                                                      settings.reference_rays, run.monitor));
    return document;
}

}  // namespace plumb
