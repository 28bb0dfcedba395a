// The parts that a truth is made of: what a state keeps, what a pass says of its errors, what
// channels hold, and that a seed is heard. Each number made here in another way.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <numeric>
#include <sstream>

#include "core/camera.h"
#include "io/image_io.h"
#include "jobs/truth/facet_truth.h"
#include "jobs/truth/truth.h"
#include "jobs/truth/truth_passes.h"
#include "jobs/truth/truth_state.h"
#include "jobs/truth/view_truth.h"
#include "rays/embree/embree_caster.h"
#include "tests/io/temp_folder.h"
#include "tests/jobs/made_scenes.h"

namespace plumb {
namespace {

// A job with every quantity, and its counts after some passes.
struct Counted {
    Scene scene = FloorAndWall(12, 10);
    Camera camera = scene.cameras.front();
    EmbreeCaster caster{scene};
    PixelGeometry pixels = LookThrough(caster, scene, camera);
    TruthJob job;

    Counted() {
        scene.light.sky = {1, 4, 2};  // The worst colour is neither the first nor the last.
        job.reach_m = 1;
        job.bounces = 2;
        job.irradiance = job.beauty = true;
    }
    TruthCounts After(int passes) const {
        const TruthPasses next(caster, scene, camera, pixels, job, SilentMonitor());
        TruthCounts counts;
        for (int k = 0; k < passes; ++k) next.Next(counts);
        return counts;
    }
};

void ExpectSame(const Lost& a, const Lost& b, const char* what) {
    EXPECT_EQ(a.not_a_number, b.not_a_number) << what;
    EXPECT_EQ(a.from_behind, b.from_behind) << what;
    EXPECT_EQ(a.not_sky, b.not_sky) << what;
    EXPECT_EQ(a.rescued, b.rescued) << what;
}

void ExpectSame(const SampleSpread& a, const SampleSpread& b, const char* what) {
    EXPECT_EQ(a.squares, b.squares) << what;
    EXPECT_EQ(a.least, b.least) << what;
    EXPECT_EQ(a.most, b.most) << what;
}

void ExpectSame(const RgbSums& a, const RgbSums& b, const char* what) {
    EXPECT_EQ(a.sum, b.sum) << what;
    EXPECT_EQ(a.ceiling, b.ceiling) << what;
    EXPECT_EQ(a.points, b.points) << what;
    ASSERT_EQ(a.spread.size(), b.spread.size()) << what;
    for (std::size_t i = 0; i < a.spread.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) ExpectSame(a.spread[i][c], b.spread[i][c], what);
    }
}

// Walks lost for every reason in every quantity, no two numbers alike.
void LoseSome(TruthCounts& counts) {
    counts.alpha->lost = {1, 2, 3, 4};
    counts.walks->lost = {50, 60, 70, 80};
    counts.irradiance->lost = {900, 1000, 1100, 1200};
    counts.irradiance->cut = 13;
}

TEST(TruthState, KeepsEveryNumber) {
    const Counted counted;
    TruthCounts counts = counted.After(2);
    LoseSome(counts);
    const TruthSizes sizes{std::int64_t(counted.pixels.receivers.size()), 12 * 10};
    const std::optional<TruthCounts> kept =
        TruthFromBytes(ToBytes(counts, "key"), "key", sizes, counted.job);
    ASSERT_TRUE(kept);
    EXPECT_EQ(kept->points, 2 * kFirstPassPoints);
    EXPECT_EQ(kept->rms_errors, counts.rms_errors);
    EXPECT_EQ(kept->rms_errors.size(), 2u);
    EXPECT_EQ(kept->alpha->open, counts.alpha->open);
    ExpectSame(kept->alpha->lost, counts.alpha->lost, "alpha");
    EXPECT_FALSE(kept->V);  // The walks bring it.
    for (std::int64_t i = 0; i < sizes.receivers; ++i) {
        for (int r = 0; r < kTruthNets; ++r) {
            const auto a = std::as_const(*kept->walks).Row(i, r);
            const auto b = std::as_const(*counts.walks).Row(i, r);
            ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(), b.end()));
        }
        ExpectSame(kept->near->spread[std::size_t(i)], counts.near->spread[std::size_t(i)],
                   "near");
    }
    ExpectSame(kept->walks->lost, counts.walks->lost, "walks");
    EXPECT_EQ(kept->near->sum, counts.near->sum);
    ExpectSame(kept->irradiance->sums, counts.irradiance->sums, "irradiance");
    ExpectSame(kept->irradiance->lost, counts.irradiance->lost, "irradiance");
    EXPECT_EQ(kept->irradiance->cut, 13);
    ExpectSame(*kept->beauty, *counts.beauty, "beauty");
    EXPECT_FALSE(TruthFromBytes(ToBytes(counts, "key"), "yek", sizes, counted.job));
}

TEST(TruthState, LosesNothingThatWasLost) {
    TruthCounts counts = Counted().After(1);
    LoseSome(counts);
    counts.V = counts.alpha;
    counts.V->lost = {10000, 20000, 30000, 40000};
    ExpectSame(LostIn(counts), {10951, 21062, 31173, 41284}, "all");
    EXPECT_EQ(LostIn(counts).All(), 10951 + 21062 + 31173);
}

double RootMeanSquare(const std::vector<double>& values) {
    double sum = 0;
    for (const double x : values) sum += x * x;
    return std::sqrt(sum / double(values.size()));
}

// Expected: of V, else of the worst colour of irradiance, else of beauty, else of what there is: the
// root of the mean square of what single pixels say.
TEST(TruthPasses, KnowTheirErrors) {
    Counted counted;
    const auto n = std::int64_t(counted.pixels.receivers.size());
    const auto rms = [](std::int64_t count, const auto& error) {
        std::vector<double> errors;
        for (std::int64_t i = 0; i < count; ++i) errors.push_back(error(i).standard_error);
        return RootMeanSquare(errors);
    };
    const auto worst = [&](const RgbSums& sums, std::int64_t count) {
        std::vector<double> of_colours;
        for (std::size_t c = 0; c < 3; ++c) {
            of_colours.push_back(rms(count, [&](std::int64_t i) { return sums.Of(i, c); }));
        }
        EXPECT_GT(of_colours[1], 1.5 * of_colours[0]);
        EXPECT_GT(of_colours[1], 1.5 * of_colours[2]);
        return of_colours[1];
    };
    TruthCounts counts = counted.After(2);
    EXPECT_NEAR(counts.rms_errors[1],
                rms(n, [&](std::int64_t i) { return counts.walks->Bounce(i, 0); }), 1e-12);
    counted.job.bounces = 0;
    counts = counted.After(1);
    EXPECT_NEAR(counts.rms_errors[0], rms(n, [&](std::int64_t i) { return counts.V->Of(i); }),
                1e-12);
    counted.job.V = false;
    counts = counted.After(1);
    EXPECT_NEAR(counts.rms_errors[0], worst(counts.irradiance->sums, n), 1e-12);
    counted.job.irradiance = false;
    // Pixels see one surface each, so that colours of beauty err in proportion to the sky.
    counts = counted.After(1);
    EXPECT_NEAR(counts.rms_errors[0], worst(*counts.beauty, 12 * 10), 1e-12);
    counted.job.beauty = false;
    counts = counted.After(1);
    EXPECT_NEAR(counts.rms_errors[0],
                rms(n, [&](std::int64_t i) { return counts.alpha->Of(i); }), 1e-12);
    counted.job.alpha = false;
    counts = counted.After(1);
    EXPECT_NEAR(counts.rms_errors[0],
                rms(n, [&](std::int64_t i) { return counts.near->Of(i); }), 1e-12);
}

// Law: the passes of a run are the points of one net each, so that two passes have the counts of one
// of as many points.
TEST(TruthPasses, TakeEachPointOnce) {
    const Counted counted;
    const TruthCounts counts = counted.After(2);
    const auto& receivers = counted.pixels.receivers;
    const NetSampling all{
        .replicates = kTruthNets, .points = 2 * kFirstPassPoints, .seed = counted.job.seed};
    EXPECT_EQ(counts.alpha->open,
              CountOpenSky(counted.caster, counted.scene.mesh, receivers,
                           {.sampling = all, .weighting = HemisphereWeight::kUniform})
                  .open);
    const IrradianceSums whole = MeasureIrradiance(counted.caster, counted.scene, receivers,
                                                   {.sampling = all}, SilentMonitor());
    for (std::size_t i = 0; i < whole.sums.sum.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(counts.irradiance->sums.sum[i][c], whole.sums.sum[i][c], 1e-9);
        }
    }
}

class TruthFiles : public TempFolder {
  protected:
    TruthResult Measure(TruthJob job) const {
        const LoadedScene loaded{FloorAndWall(24, 20), {}, "digest"};
        job.use_cache = false;
        return MeasureTruth(loaded, job,
                            {.version = "1.2.3", .command = "plumb truth", .folder = folder_});
    }
    const Image<float>& Channel(const TruthResult& result, const std::string& name) const {
        for (const NamedChannel& channel : result.channels) {
            if (channel.name == name) return channel.pixels;
        }
        throw std::runtime_error("no channel " + name);
    }
};

// Expected: the points where lines of sight meet z = 0 or the wall at y = 1.5, by hand; in the camera's
// frame (truth/pixels.h).
TEST_F(TruthFiles, GeometryIsThatOfTheScene) {
    TruthJob job;
    job.max_spp = 64;
    const TruthResult result = Measure(job);
    const Camera camera = FloorAndWall(24, 20).cameras.front();
    const Vec3 eye = camera.position_m;
    const Vec3 forward = (camera.target_m - eye).normalized();
    const Vec3 right = forward.cross(camera.up).normalized(), up = right.cross(forward);
    const double tan = std::tan(camera.fov_rad / 2);
    int floor = 0, wall = 0;
    for (int j = 0; j < 20; ++j) {
        for (int i = 0; i < 24; ++i) {
            const Vec3 w =
                forward + tan * ((i + 0.5 - 12) / 10 * right - (j + 0.5 - 10) / 10 * up);
            const double to_wall = (1.5 - eye.y()) / w.y(), to_floor = -eye.z() / w.z();
            const Vec3 on_wall = eye + to_wall * w;
            const bool is_wall = to_wall > 0 && std::abs(on_wall.x()) < 3 && on_wall.z() > 0 &&
                                 on_wall.z() < 0.8;
            const Vec3 p = is_wall ? on_wall : Vec3(eye + to_floor * w);
            const bool is_sky = !is_wall && !(to_floor > 0 && p.cwiseAbs().maxCoeff() < 4);
            const float depth = Channel(result, "depth_m")(i, j);
            EXPECT_EQ(std::isfinite(depth), !is_sky) << i << " " << j;
            if (is_sky) continue;
            EXPECT_NEAR(depth, (p - eye).dot(forward), 1e-4);
            const Vec3 n = is_wall ? Vec3(0, -1, 0) : Vec3(0, 0, 1);
            const Vec3 axes[] = {right, up, -forward};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::string part = std::string(".") + "xyz"[axis];
                EXPECT_NEAR(Channel(result, "position_m" + part)(i, j),
                            (p - eye).dot(axes[axis]), 1e-4)
                    << part;
                EXPECT_NEAR(Channel(result, "normal" + part)(i, j), n.dot(axes[axis]), 1e-5)
                    << part;
            }
            const auto bits =
                std::bit_cast<std::uint32_t>(Channel(result, "triangle_bits")(i, j));
            EXPECT_EQ(bits / 2, is_wall ? 1u : 0u);
            ++(is_wall ? wall : floor);
        }
    }
    EXPECT_GT(floor, 100);
    EXPECT_GT(wall, 30);
}

// Expected: what an EXR header is by its format: name, type, length, value.
TEST_F(TruthFiles, ExrSaysWhatItIsOf) {
    TruthJob job;
    job.max_spp = 128;
    job.seed = 5;
    Measure(job);
    const std::string exr = Get("truth.exr");
    const auto has = [&](const std::string& name, const std::string& value) {
        const std::uint32_t length = std::uint32_t(value.size());
        std::string bytes = name + '\0' + "string" + '\0';
        for (int k = 0; k < 4; ++k) bytes += char(length >> (8 * k));
        EXPECT_NE(exr.find(bytes + value), std::string::npos) << name << " = " << value;
    };
    has("plumb:version", "1.2.3");
    has("plumb:command", "plumb truth");
    has("plumb:scene", "floor and wall");
    has("plumb:scene_sha256", "digest");
    has("plumb:camera", "front");
    has("plumb:seed", "5");
    has("plumb:spp", "128");
    has("plumb:stopped_by", "samples");
}

// Expected: stops at the first pass whose error, as the report has it, is below the target.
TEST_F(TruthFiles, StopAtTheFirstPassThatIsGoodEnough) {
    TruthJob job;
    const auto error = [&](int spp) {
        job.max_spp = spp;
        return Measure(job).report.quantities.at(0).rms_error;
    };
    const double after_64 = error(64), after_128 = error(128), after_256 = error(256);
    ASSERT_GT(after_64, after_128);
    ASSERT_GT(after_128, after_256);
    job.max_spp = 4096;
    for (const auto& [target, spp] : {std::pair{1.01 * after_64, 64},
                                      {0.99 * after_64, 128},
                                      {1.01 * after_128, 128},
                                      {0.99 * after_128, 256}}) {
        job.target_error = target;
        const TruthResult result = Measure(job);
        EXPECT_EQ(result.report.spp, spp) << target;
        EXPECT_EQ(result.report.stopped_by, "target error");
    }
}

// Another seed, other nets: no picture alike, the means alike within their errors.
TEST(ViewTruthSeed, IsHeard) {
    const Scene scene = FloorAndWall(24, 20);
    const EmbreeCaster caster(scene);
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kLinear, Falloff::kQuadratic};
    const auto truth = [&](std::uint64_t seed) {
        return MeasureViewTruth(caster, scene, scene.cameras.front(), falloffs,
                                {.radius_m = 1, .spp = 64, .seed = seed});
    };
    const ViewTruth one = truth(1), same = truth(1), two = truth(2);
    EXPECT_EQ(one.V.value.Pixels(), same.V.value.Pixels());
    EXPECT_NE(one.V.value.Pixels(), two.V.value.Pixels());
    for (const Falloff falloff : falloffs) {
        EXPECT_NE(one.near.at(falloff).value.Pixels(), two.near.at(falloff).value.Pixels());
    }
    // Of the same rays: what is met at the distance d counts 1, 1 - d^2 / r^2, 1 - d / r.
    for (std::size_t p = 0; p < 24 * 20; ++p) {
        const auto at = [&](Falloff f) { return one.near.at(f).value.Pixels()[p]; };
        ASSERT_LE(at(Falloff::kHard), at(Falloff::kQuadratic) + 1e-6);
        ASSERT_LE(at(Falloff::kQuadratic), at(Falloff::kLinear) + 1e-6);
    }
    EXPECT_NE(one.near.at(Falloff::kHard).value.Pixels(),
              one.near.at(Falloff::kQuadratic).value.Pixels());
    EXPECT_NE(one.near.at(Falloff::kQuadratic).value.Pixels(),
              one.near.at(Falloff::kLinear).value.Pixels());
}

// The rows of facets.csv as numbers, without the line of heads.
std::vector<std::vector<double>> NumbersOf(const std::filesystem::path& csv,
                                           std::vector<std::string>& heads) {
    std::ifstream file(csv);
    std::vector<std::vector<double>> rows;
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        if (!heads.empty()) rows.emplace_back();
        const bool is_head = rows.empty();
        for (std::string field; std::getline(fields, field, ',');) {
            if (is_head) {
                heads.push_back(field);
            } else {
                rows.back().push_back(std::stod(field));
            }
        }
    }
    return rows;
}

// Solid angle of a rectangle a x b seen from the height d over one of its corners: the textbook's
// atan(a b / (d sqrt(a^2 + b^2 + d^2))).
double CornerSolidAngle(double a, double b, double d) {
    return std::atan(a * b / (d * std::sqrt(a * a + b * b + d * d)));
}

// Expected: alpha of a square 1 below another, averaged over it: 1 - mean solid angle / 2 pi, by
// quadrature over 200 x 200 points (its error is far below the noise). Tolerance: 4 standard errors of
// the mean of four triangles.
TEST(FacetTruthAlpha, IsUniformInSolidAngle) {
    Scene scene;
    scene.materials.push_back({});
    AddFace(scene, {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0)});
    AddFace(scene, {Vec3f(0, 0, 1), Vec3f(0, 1, 1), Vec3f(1, 1, 1), Vec3f(1, 0, 1)});
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "plumb_facet_alpha";
    const auto measured = [&](std::uint64_t seed, const std::string& column) {
        const FacetTruthResult result = MeasureFacetTruth(
            {scene, {}, ""}, {.spp = 4096, .bounces = 0, .seed = seed}, folder);
        std::vector<std::string> heads;
        const auto rows = NumbersOf(result.csv, heads);
        EXPECT_EQ(rows.size(), 4u);
        const auto at = std::size_t(std::ranges::find(heads, column) - heads.begin());
        std::vector<double> values;
        for (const auto& row : rows) values.push_back(row.at(at));
        return values;
    };
    const int n = 200;
    double solid_angle = 0;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const double x = (i + 0.5) / n, y = (j + 0.5) / n;
            for (const double a : {x, 1 - x}) {
                for (const double b : {y, 1 - y}) {
                    solid_angle += CornerSolidAngle(a, b, 1) / n / n;
                }
            }
        }
    }
    const std::vector<double> alpha = measured(1, "alpha"), error = measured(1, "alpha_error");
    const double mean = std::accumulate(alpha.begin(), alpha.end(), 0.0) / 4;
    EXPECT_NEAR(mean, 1 - solid_angle / (2 * std::acos(-1.0)), 4 * RootMeanSquare(error) / 2);
    EXPECT_LT(RootMeanSquare(error), 0.005);
    EXPECT_NE(measured(2, "alpha"), alpha);  // The seed is heard.
    EXPECT_NE(measured(2, "V"), measured(1, "V"));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace plumb
