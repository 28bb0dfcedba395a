#include "jobs/truth/bench_truth.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/sobol.h"
#include "core/warp.h"
#include "truth/embree_caster.h"
#include "truth/escape_walk.h"
#include "truth/leave_surface.h"
#include "truth/open_sky.h"
#include "truth/pixels.h"

namespace plumb {
namespace {

constexpr NetSampling kSpeedSampling{.replicates = 8, .points = 8};
constexpr int kRays = 64;  // Of both counts above.
constexpr std::int64_t kReceiversPerChunk = 16;

double Median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

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
               std::span<const Receiver> receivers, const Clock& clock)
        : caster_(caster),
          mesh_(mesh),
          receivers_(receivers),
          clock_(clock),
          bare_(caster, RaysOfV(mesh, receivers)) {}

    TruthSpeed Run(int threads, int rounds, Monitor& monitor) {
        SetThreadCount(threads);
        std::vector<double> ours_s, stream_s, single_s, share;
        for (int round = 0; round <= rounds; ++round) {
            const double ours = Seconds([&] { open_ = Measure(monitor); });
            bare_.Refill();
            const double stream = Seconds([&] {
                met_ = Loop([&](std::size_t begin, std::size_t end) {
                    return bare_.AnyStream(begin, end, kRays);
                });
            });
            const double single = Seconds([&] {
                Loop([&](std::size_t begin, std::size_t end) { return bare_.Any(begin, end); });
            });
            if (round == 0) continue;
            ours_s.push_back(ours);
            stream_s.push_back(stream);
            single_s.push_back(single);
            share.push_back(stream / ours);
        }
        const double n = double(receivers_.size()) * kRays;
        return {.threads = threads,
                .rays_per_second = n / Median(ours_s),
                .bare_stream_per_second = n / Median(stream_s),
                .bare_single_per_second = n / Median(single_s),
                .share = Median(share),
                .share_low = *std::ranges::min_element(share),
                .share_high = *std::ranges::max_element(share)};
    }

    std::int64_t DifferingRays() const {
        return std::abs(std::int64_t(receivers_.size()) * kRays - open_ - met_);
    }

  private:
    template <class F>
    double Seconds(const F& work) const {
        const double begin_s = clock_();
        work();
        return clock_() - begin_s;
    }

    std::int64_t Measure(Monitor& monitor) const {
        const OpenCounts counts =
            CountOpenSky(caster_, mesh_, receivers_, {.sampling = kSpeedSampling}, monitor);
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
    const Clock& clock_;
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

TruthFurnace RunFurnace(std::int64_t paths, const Clock& clock, Monitor& monitor) {
    constexpr int kCells = 1024, kBounces = 2000;
    constexpr int kReceivers = 250;
    constexpr NetSampling kSampling{.replicates = 8, .points = 512};
    constexpr std::int64_t kBatch = kReceivers * 8 * 512;
    const Mesh mesh = NoisyField(kCells);
    const EmbreeCaster caster(mesh);
    TruthFurnace furnace{.cells = kCells, .bounces = kBounces};
    const double begin_s = clock();
    for (std::uint64_t batch = 0; furnace.paths < paths; ++batch) {
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
        furnace.paths += kBatch;
        furnace.lost += walks.lost.All();
        furnace.rescued += walks.lost.rescued;
        for (std::int64_t i = 0; i < walks.Receivers(); ++i) {
            for (int r = 0; r < walks.Replicates(); ++r) {
                furnace.under_way += walks.Row(i, r)[kBounces + 1];
            }
        }
    }
    furnace.seconds = clock() - begin_s;
    return furnace;
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

TruthConvergence StudyTruthConvergence(const EmbreeCaster& caster, const Mesh& mesh,
                                       std::span<const Receiver> receivers,
                                       std::int64_t reference_rays, Monitor& monitor) {
    constexpr int kReplicates = 8;
    const std::vector<std::int64_t> rays = {16, 64, 256, 1024, 4096};
    TruthConvergence study{.receivers = std::int64_t(receivers.size()),
                           .reference_rays = reference_rays,
                           .points = {}};
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
        study.points.push_back({rays[k], nets.back(), independent.back()});
    }
    study.slope_nets = Slope(n, nets);
    study.slope_independent = Slope(n, independent);
    return study;
}

}  // namespace

TruthBench BenchTruth(const LoadedScene& loaded, const TruthBenchSettings& settings,
                      const Clock& clock, Monitor& monitor) {
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

    TruthBench bench{.scene = scene.name,
                     .camera = camera.name,
                     .width_px = camera.width_px,
                     .height_px = camera.height_px,
                     .rays_per_pixel = kRays,
                     .rounds = settings.rounds,
                     .triangles = caster.Counts().triangles,
                     .receivers = std::int64_t(receivers.size()),
                     .speeds = {},
                     .furnace = {},
                     .convergence = {}};
    const int threads = ThreadCount();
    SpeedBench speed(caster, scene.mesh, receivers, clock);
    for (const int count : settings.threads) {
        bench.speeds.push_back(speed.Run(count, settings.rounds, monitor));
    }
    bench.differing_rays = speed.DifferingRays();
    SetThreadCount(threads);
    if (settings.furnace_paths > 0) {
        bench.furnace = RunFurnace(settings.furnace_paths, clock, monitor);
    }

    constexpr std::size_t kStudied = 96;
    std::vector<Receiver> studied;
    for (std::size_t k = 0; k < std::min(kStudied, receivers.size()); ++k) {
        studied.push_back(receivers[k * receivers.size() / kStudied]);
    }
    bench.convergence =
        StudyTruthConvergence(caster, scene.mesh, studied, settings.reference_rays, monitor);
    return bench;
}

}  // namespace plumb
