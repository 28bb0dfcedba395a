#include "truth/replicates.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <functional>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/warp.h"
#include "rays/embree/embree_caster.h"
#include "tests/truth/half_hidden_caster.h"
#include "truth/beauty.h"
#include "truth/escape_walk.h"
#include "truth/irradiance.h"
#include "truth/near_visibility.h"
#include "truth/open_sky.h"

namespace plumb {
namespace {

Vec3 Axis(double turn) {
    return {std::cos(2 * kPi * turn), std::sin(2 * kPi * turn), 0};
}

// Expected: an interval of confidence 0.95 holds the exact value in 93 to 97 % of the runs with
// different seeds. Of 4000 runs the share's own error is 0.35 %; with 32
// points, where the counts of the nets differ by one or two, it is 92.6 % in the worst case.
TEST(Replicates, IntervalsHoldTheTruthAsOftenAsTheySay) {
    constexpr int kSeeds = 4000;
    const Mesh ground = HalfHiddenCaster::Ground();
    for (const double c : {0.1, 0.45, 0.8}) {
        for (const std::int64_t points : {64, 256}) {
            int held = 0;
            for (int seed = 0; seed < kSeeds; ++seed) {
                const HalfHiddenCaster caster(Axis(RandomUnit(1, seed, 0, 0)), c);
                const Receiver receiver{.spread = false};
                const Measured V =
                    CountOpenSky(caster, ground, std::span(&receiver, 1),
                                 {.sampling = {.points = points, .seed = std::uint64_t(seed)}})
                        .Of(0);
                const double exact = HalfHiddenCaster::V(c);
                held += V.interval.low <= exact && exact <= V.interval.high;
            }
            EXPECT_GE(held, 0.93 * kSeeds) << c << " " << points;
            EXPECT_LE(held, 0.97 * kSeeds) << c << " " << points;
        }
    }
}

// Expected: with 0 of R n or all of them, Clopper and Pearson: 1 - (0.05 / 2)^(1 / (R n)).
TEST(Replicates, NoneOrAllStillLeaveDoubt) {
    const std::vector<std::uint32_t> none(8, 0), all(8, 64);
    const double doubt = 1 - std::pow(0.025, 1.0 / 512);
    EXPECT_EQ(FromCounts(none, 64).interval.low, 0);
    EXPECT_NEAR(FromCounts(none, 64).interval.high, doubt, 1e-12);
    EXPECT_NEAR(FromCounts(all, 64).interval.low, 1 - doubt, 1e-12);
    EXPECT_EQ(FromCounts(all, 64).interval.high, 1);
    EXPECT_GT(FromCounts(all, 64).standard_error, 0);
}

// Expected: by hand. Means 0.25, 0.5, 0.75: standard deviation 0.25, error 0.25 / sqrt(3), and
// t at 0.975 with 2 degrees of freedom is 4.302652729911275 (tables): half-width 0.62, cut off
// at 0 and 1.
TEST(Replicates, ErrorIsTheScatterOfTheNets) {
    // Yes and no, of 3 x 400 samples.
    const std::array<double, 3> sums{100, 200, 300};
    SampleSpread spread;
    spread.Add(0, 600);
    spread.Add(1, 600);
    const Measured measured = FromSums(sums, 400, spread);
    EXPECT_DOUBLE_EQ(measured.value, 0.5);
    EXPECT_DOUBLE_EQ(measured.standard_error, 0.25 / std::sqrt(3.0));
    EXPECT_EQ(measured.interval.low, 0);
    EXPECT_EQ(measured.interval.high, 1);
    const Measured narrow = FromSums(std::array<double, 3>{196, 200, 204}, 400, spread);
    EXPECT_NEAR(narrow.interval.high, 0.5 + 4.302652729911275 * 0.01 / std::sqrt(3.0), 1e-12);
}

// Expected: [Sobol67]'s nets err by n^(-3/4) on the indicator of a disk's segment, independent
// directions by n^(-1/2). Over 16 to 4096 points the fitted slopes must be at most -0.7 and
// within 0.05 of -0.5 (400 cases; the slope's own error is 0.01).
TEST(Replicates, NetsConvergeFasterThanIndependentSamples) {
    const Mesh ground = HalfHiddenCaster::Ground();
    const auto slope = [&](bool nets) {
        double sx = 0, sy = 0, sxx = 0, sxy = 0;
        int count = 0;
        for (std::int64_t points = 16; points <= 4096; points *= 4, ++count) {
            double squares = 0;
            for (int i = 0; i < 400; ++i) {
                const double c = 0.05 + 0.8 * RandomUnit(2, i, 0, 0);
                const Vec3 axis = Axis(RandomUnit(2, i, 0, 1));
                const HalfHiddenCaster caster(axis, c);
                double V = 0;
                if (nets) {
                    const Receiver receiver{.spread = false};
                    const OpenCounts counts = CountOpenSky(
                        caster, ground, std::span(&receiver, 1),
                        {.sampling = {
                             .replicates = 2, .points = points, .seed = std::uint64_t(i)}});
                    V = double(counts.open[0]) / double(points);
                } else {
                    for (std::int64_t s = 0; s < points; ++s) {
                        const Vec3 w = SampleCosineHemisphere(
                            {RandomUnit(3, i, s, 0), RandomUnit(3, i, s, 1)});
                        V += (w.dot(axis) <= c) / double(points);
                    }
                }
                squares += std::pow(V - HalfHiddenCaster::V(c), 2);
            }
            const double x = std::log(double(points)), y = std::log(squares / 400) / 2;
            sx += x;
            sy += y;
            sxx += x * x;
            sxy += x * y;
        }
        return (count * sxy - sx * sy) / (count * sxx - sx * sx);
    };
    const double of_nets = slope(true), of_independent = slope(false);
    RecordProperty("slope_nets", std::to_string(of_nets));
    EXPECT_LE(of_nets, -0.7);
    EXPECT_NEAR(of_independent, -0.5, 0.05);
}

Mesh Noise(int cells) {
    Mesh mesh;
    AddSheet(mesh, Steps(0, 1, cells), Steps(0, 1, cells), [&](double u, double v) {
        return Vec3(u, v,
                    0.05 * RandomUnit(4, std::lround(u * cells), std::lround(v * cells), 0));
    });
    return mesh;
}

// Expected: the same counts on any number of threads, and the same whether the points of each
// net are taken at once or in two calls: what progress and resuming rest on.
TEST(Replicates, CountsDoNotDependOnThreadsNorOnInterruptions) {
    const Mesh mesh = Noise(32);
    const EmbreeCaster caster(mesh);
    std::vector<Receiver> receivers;
    for (std::uint32_t i = 0; i < 100; ++i) receivers.push_back({.triangle = 7 * i});
    const auto rows = [&](const EscapeCounts& counts) {
        std::vector<std::uint32_t> all;
        for (std::int64_t i = 0; i < counts.Receivers(); ++i) {
            for (int r = 0; r < counts.Replicates(); ++r) {
                const auto row = counts.Row(i, r);
                all.insert(all.end(), row.begin(), row.end());
            }
        }
        return all;
    };
    const WalkOptions whole{.sampling = {.points = 32}};
    const OpenSkyOptions open_whole{.sampling = {.points = 32},
                                    .weighting = HemisphereWeight::kUniform};
    SetThreadCount(1);
    const EscapeCounts one = WalkToTheSky(caster, mesh, receivers, whole);
    const OpenCounts open_one = CountOpenSky(caster, mesh, receivers, open_whole);
    SetThreadCount(4);
    EXPECT_EQ(rows(WalkToTheSky(caster, mesh, receivers, whole)), rows(one));
    EXPECT_EQ(CountOpenSky(caster, mesh, receivers, open_whole).open, open_one.open);

    WalkOptions part = whole;
    part.sampling.points = 8;
    EscapeCounts merged = WalkToTheSky(caster, mesh, receivers, part);
    part.sampling.first = 8;
    part.sampling.points = 24;
    merged.Merge(WalkToTheSky(caster, mesh, receivers, part));
    EXPECT_EQ(rows(merged), rows(one));
    EXPECT_EQ(merged.Points(), 32);

    OpenSkyOptions open_part = open_whole;
    open_part.sampling.points = 16;
    OpenCounts open_merged = CountOpenSky(caster, mesh, receivers, open_part);
    open_part.sampling.first = 16;
    open_merged.Merge(CountOpenSky(caster, mesh, receivers, open_part));
    EXPECT_EQ(open_merged.open, open_one.open);
    SetThreadCount(0);
}

// Expected: alpha^2 <= V <= alpha (2 - alpha) for every point of any scene; p_0 of the walks is
// V by other rays. Tolerance: errors of both, combined.
TEST(Replicates, AlphaAndVKeepTheirLaw) {
    const Mesh mesh = Noise(32);
    const EmbreeCaster caster(mesh);
    std::vector<Receiver> receivers;
    for (std::uint32_t i = 0; i < 200; ++i) {
        receivers.push_back({.triangle = 9 * i, .spread = false});
    }
    const NetSampling sampling{.replicates = 32, .points = 128};
    const OpenCounts V = CountOpenSky(caster, mesh, receivers, {.sampling = sampling});
    const OpenCounts alpha =
        CountOpenSky(caster, mesh, receivers,
                     {.sampling = sampling, .weighting = HemisphereWeight::kUniform});
    for (std::int64_t i = 0; i < V.Receivers(); ++i) {
        const Measured v = V.Of(i), a = alpha.Of(i);
        // d/da of a^2 and a (2 - a) is at most 2.
        const double slack = 7 * std::hypot(v.standard_error, 2 * a.standard_error);
        EXPECT_GE(v.value, a.value * a.value - slack) << i;
        EXPECT_LE(v.value, a.value * (2 - a.value) + slack) << i;
    }
}

// Expected: worked by hand. Two nets of 4 walks, K = 1: net 0 ends {2, 1, 1 under way, 0 lost},
// net 1 {1, 2, 0, 1}. At rho = 1/2 the sums are 2.5 / 4 and 2 / 4; the rest is at most
// 1/4 of what is under way and all that is lost: 2.75 / 4 and 3 / 4.
TEST(EscapeCounts, TotalBracketsWhatIsNotKnown) {
    EscapeCounts counts(1, 2, 1, 4);
    const std::array<std::array<std::uint32_t, 4>, 2> rows{{{2, 1, 1, 0}, {1, 2, 0, 1}}};
    for (int r = 0; r < 2; ++r) {
        std::ranges::copy(rows[std::size_t(r)], counts.Row(0, r).begin());
    }
    EXPECT_DOUBLE_EQ(counts.Bounce(0, 0).value, 3.0 / 8);
    EXPECT_DOUBLE_EQ(counts.Bounce(0, 1).value, 3.0 / 8);
    EXPECT_DOUBLE_EQ(counts.UnderWay(0).value, 1.0 / 8);
    EXPECT_DOUBLE_EQ(counts.LostShare(0).value, 1.0 / 8);
    const Measured total = counts.Total(0, Albedo(0.5));
    const double low = (2.5 / 4 + 2.0 / 4) / 2, high = (2.75 / 4 + 3.0 / 4) / 2;
    EXPECT_DOUBLE_EQ(total.value, (low + high) / 2);
    EXPECT_LE(total.interval.low, low);
    EXPECT_GE(total.interval.high, high);
}

// Counts rays, and who asks it whether to stop is told so after `allowed` of them.
class Stopping final : public RayCaster, public Monitor {
  public:
    explicit Stopping(std::int64_t allowed) : allowed_(allowed) {}

    void Closest(std::span<const Ray> rays, std::span<Hit> hits) const override {
        cast += std::int64_t(rays.size());
        inner_.Closest(rays, hits);
    }
    void Any(std::span<const Ray> rays, std::span<std::uint64_t> met) const override {
        cast += std::int64_t(rays.size());
        inner_.Any(rays, met);
    }
    void AnyFromPoint(const Ray& ray, std::span<const Vec3f> directions,
                      std::span<std::uint64_t> met) const override {
        cast += std::int64_t(directions.size());
        inner_.AnyFromPoint(ray, directions, met);
    }
    GeometryCounts Counts() const override { return {}; }
    void Progress(std::string_view, double) override {}
    bool Cancelled() const override { return cast >= allowed_; }

    mutable std::atomic<std::int64_t> cast = 0;

  private:
    HalfHiddenCaster inner_{Vec3(1, 0, 0), 0.2};
    std::int64_t allowed_;
};

// Expected: however many points a receiver has, a stop is heard before 16 receivers have had
// another 256 points of each of 8 nets, on every thread: not after 2^20 rays of each receiver, which
// take seconds.
TEST(InParts, AStopIsHeardWithinAPart) {
    constexpr std::int64_t kPart = 16 * 256 * 8, kAllowed = 3 * kPart;
    const Mesh ground = HalfHiddenCaster::Ground();
    const std::vector<Receiver> receivers(16, Receiver{.spread = false});
    const NetSampling many{.points = 1 << 17};
    Scene scene;
    scene.mesh = ground;
    scene.material_of_face = {0};
    scene.materials = {{}};
    const Camera camera{.position_m = {0, 0, 1},
                        .target_m = {0, 0, 0},
                        .up = {0, 1, 0},
                        .width_px = 4,
                        .height_px = 4};
    const std::vector<std::function<void(Stopping&)>> kernels{
        [&](Stopping& s) { CountOpenSky(s, ground, receivers, {.sampling = many}, s); },
        [&](Stopping& s) { WalkToTheSky(s, ground, receivers, {.sampling = many}, s); },
        [&](Stopping& s) { MeasureNear(s, ground, receivers, {.sampling = many}, s); },
        [&](Stopping& s) { MeasureIrradiance(s, scene, receivers, {.sampling = many}, s); },
        [&](Stopping& s) { MeasureBeauty(s, scene, camera, many, s); }};
    SetThreadCount(1);
    for (std::size_t k = 0; k < kernels.size(); ++k) {
        Stopping stopping(kAllowed);
        EXPECT_THROW(kernels[k](stopping), Interrupted) << k;
        EXPECT_LE(stopping.cast, kAllowed + 2 * kPart) << k;
    }
    SetThreadCount(0);
}

// Expected: parts are the whole: in order, without a gap.
TEST(InParts, AreTheWhole) {
    std::int64_t next = 5;
    InParts({.first = 5, .points = 1000}, SilentMonitor(), [&](const NetSampling& part) {
        EXPECT_EQ(part.first, next);
        EXPECT_LE(part.points, 256);
        next += part.points;
    });
    EXPECT_EQ(next, 1005);
}

TEST(NetSampling, RefusesWhatItCannotDo) {
    const auto message = [](const NetSampling& sampling) {
        try {
            Validate(sampling);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(message({.replicates = 1}), "NetSampling::replicates = 1, must be in [2, 1024]");
    EXPECT_EQ(message({.first = -1}), "NetSampling::first = -1, must be >= 0");
    EXPECT_EQ(message({.points = 0}),
              "NetSampling::points = 0, must be >= 1, up to 2^32 in all");
    EXPECT_EQ(message({}), "no error");
}

// By hand: where counts happen to be equal, one sample more or less in each net would not show;
// rounding to whole samples hides 1 / (n sqrt 12) a net, 1 / (n sqrt(12 R)) of their mean, and
// so much times the value where values are not counts.
TEST(Replicates, EqualMeansAreNotTakenAsCertain) {
    const std::array<double, 3> equal{5, 5, 5};
    SampleSpread half;
    half.Add(0, 15);
    half.Add(1, 15);
    EXPECT_DOUBLE_EQ(FromSums(equal, 10, half).standard_error, 1 / (10 * std::sqrt(36.0)));
    const std::array<double, 3> bright{400, 400, 400};
    SampleSpread lit;
    lit.Add(40, 30);
    const Measured measured = FromUnboundedSums(bright, 10, lit, 50);
    EXPECT_DOUBLE_EQ(measured.standard_error, 40 / (10 * std::sqrt(36.0)));
    // All the same: what 30 samples may have missed is a share of the way to 0 and to 50.
    const double share = 1 - std::pow(0.025, 1.0 / 30);
    EXPECT_NEAR(measured.interval.low, 40 - 40 * share, 1e-12);
    EXPECT_NEAR(measured.interval.high, 40 + 10 * share, 1e-12);
    SampleSpread dark;
    dark.Add(0, 30);
    EXPECT_EQ(FromUnboundedSums(std::array<double, 3>{0, 0, 0}, 10, dark, 0).standard_error, 0);
}

}  // namespace
}  // namespace plumb
