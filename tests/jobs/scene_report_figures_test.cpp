// Figures of a scene's report that are made again here: from pictures and truths by plain loops, from
// each other by their definitions.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "io/image_io.h"
#include "jobs/screen_space/render_scene.h"
#include "jobs/screen_space/sao_traffic.h"
#include "jobs/screen_space/score_technique.h"
#include "jobs/screen_space/signed_picture.h"
#include "rays/embree/embree_caster.h"
#include "score/ssim.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"
#include "tests/io/temp_folder.h"
#include "tests/jobs/made_scenes.h"
#include "tests/jobs/plain_scores.h"
#include "tests/jobs/read_results.h"

namespace plumb {
namespace {

constexpr double kRadiusM = 0.9;  // None of anybody's defaults.
const std::vector<std::string> kNames{"sao-supplement2012", "hbao", "gtao-paper", "alchemy"};

Scene TwoViews() {
    Scene scene = FloorAndWall(64, 48);
    Camera side = scene.cameras.front();
    side.name = "side";
    side.position_m = {-3, -1.5, 1};
    scene.cameras.push_back(side);
    return scene;
}

SceneReportJob Job() {
    SceneReportJob job;
    job.guard_px = 8;
    job.radius_m = kRadiusM;
    job.techniques = kNames;
    job.spp = 64;
    job.rounds = 2;
    job.sizes = {{48, 27, 8}};
    job.radii_size = {48, 27, 8};
    job.budget_stride_px = 24;
    job.flicker = {.frames = 2, .width_px = 48, .height_px = 27, .guard_px = 8, .spp = 16};
    job.precision = {
        .curves = {.distances = 2, .poses = 1, .points = 1}, .width_px = 32, .height_px = 18};
    return job;
}

// By a clock of which each interval is longer than the last.
const ReportResults& Report() {
    static const ReportResults results = [] {
        double now_s = 0, step_s = 0;
        return ResultsOf(
            ReportScene({TwoViews(), {}, "digest"}, Job(),
                        {.version = "test", .command = "plumb report", .clock = [&] {
                             step_s += 0.001;
                             return now_s += step_s;
                         }}));
    }();
    return results;
}

// One row of the scores.
std::size_t RowOf(const std::string& technique, const std::string& view,
                  const std::string& truth, const std::string& region) {
    const ResultTable& scores = Report().scores;
    for (std::size_t k = 0; k < scores.rows.size(); ++k) {
        if (TextAt(scores, k, "technique") == technique && TextAt(scores, k, "view") == view &&
            TextAt(scores, k, "truth") == truth && TextAt(scores, k, "region") == region) {
            return k;
        }
    }
    throw std::runtime_error("no row of " + technique + ", " + view + ", " + truth);
}

struct View {
    Scene scene = TwoViews();
    const Camera& camera;
    EmbreeCaster caster{scene};
    ViewTruth truth;
    GBuffer gbuffer;

    explicit View(std::size_t number)
        : camera(scene.cameras[number]),
          truth(MeasureViewTruth(
              caster, scene, camera,
              std::vector{Falloff::kHard, Falloff::kSao, Falloff::kQuadratic, Falloff::kFarEnd},
              {.radius_m = kRadiusM, .spp = number == 0 ? 64 : 16})),
          gbuffer(DrawGBuffer(scene, camera, SuitedTo(scene, camera, 8))) {}

    Image<float> Of(const Technique& technique) const {
        return Shown(technique.run({gbuffer, scene, camera, caster}, Ticking()).back().A,
                     gbuffer.view);
    }
};

double Rms(const Image<float>& errors, const Image<int>& pixels) {
    return PlainRms(errors, Image<float>(errors.Width(), errors.Height(), 0), pixels);
}

TEST(SceneReportFigures, TellHowWellTheTruthIsKnown) {
    const ResultTable& views = Report().views;
    ASSERT_EQ(views.rows.size(), 2u);
    for (std::size_t v = 0; v < 2; ++v) {
        const View view(v);
        const Image<int> seen = SeenPixels(view.truth);
        const double of_V = Rms(view.truth.V.standard_error, seen);
        const double near = Rms(view.truth.near.at(Falloff::kHard).standard_error, seen);
        EXPECT_NEAR(NumberAt(views, v, "rms_standard_error_v"), of_V, 1e-9);
        EXPECT_NEAR(NumberAt(views, v, "rms_standard_error_near"), near, 1e-9);
        EXPECT_GT(std::abs(of_V - near), 1e-4);
    }
}

// Expected: SSIM against each truth by itself, and what the truth's noise does to the MSE by the
// equation of score/errors.h, of 8 nets: nu = 7.
TEST(SceneReportFigures, AreAgainstTheTruthOfTheirRow) {
    for (std::size_t v = 0; v < 2; ++v) {
        const View view(v);
        const Image<int> seen = SeenPixels(view.truth);
        const Mask mask = RegionsOf(view.truth).seen;
        for (const std::string& name : kNames) {
            const Technique technique = TechniqueNamed(name, {.radius_m = kRadiusM});
            const Image<float> A = view.Of(technique);
            const std::pair<std::string, const TruthImage*> truths[] = {
                {kTruthV, &view.truth.V},
                {kTruthNear, &view.truth.near.at(Falloff::kHard)},
                {kTruthWeighted, &view.truth.near.at(technique.falloff)}};
            for (const auto& [truth_name, truth] : truths) {
                const std::size_t row = RowOf(name, view.camera.name, truth_name, "whole");
                const Measured ssim =
                    ScoreSsim(SsimMap(A, truth->value, truth->standard_error, mask), mask);
                EXPECT_NEAR(NumberAt(Report().scores, row, "ssim"), ssim.value, 1e-12)
                    << name << truth_name;
                const double nu = 7;
                double sum = 0, n = 0;
                for (std::size_t p = 0; p < seen.Pixels().size(); ++p) {
                    if (seen.Pixels()[p] == 0) continue;
                    const double d = double(A.Pixels()[p]) - truth->value.Pixels()[p];
                    const double s2 = std::pow(truth->standard_error.Pixels()[p], 2);
                    sum +=
                        4 * d * d * s2 - 4 * s2 * s2 + (2 + 10 / nu) * s2 * s2 * nu / (nu + 2);
                    ++n;
                }
                const Measured& mse = MeasuredAt(Report().scores, row, "mse");
                EXPECT_NEAR(mse.noise_error, std::sqrt(sum) / n, 1e-9 + 1e-6 * mse.noise_error)
                    << name << truth_name;
            }
        }
    }
}

// Expected: of all views the root of the mean square of each view's; closest in shape is the technique
// that has least of it, closest the one of the least mean square.
TEST(SceneReportFigures, OfAllViewsAreMeanSquares) {
    std::map<double, std::string> shape, plain;
    for (const std::string& name : kNames) {
        double squares = 0, mse = 0;
        for (const char* view : {"front", "side"}) {
            const std::size_t row = RowOf(name, view, kTruthNear, "whole");
            squares += std::pow(NumberAt(Report().scores, row, "recalibrated_rmse"), 2) / 2;
            mse += NumberAt(Report().scores, row, "mse") / 2;
        }
        const std::size_t all = RowOf(name, "all views", kTruthNear, "whole");
        EXPECT_NEAR(NumberAt(Report().scores, all, "recalibrated_rmse"), std::sqrt(squares),
                    1e-9);
        EXPECT_NEAR(NumberAt(Report().scores, all, "mse"), mse, 1e-9);
        shape[squares] = plain[mse] = name;
    }
    EXPECT_EQ(Report().closest, plain.begin()->second);
    EXPECT_EQ(Report().closest_recalibrated, shape.begin()->second);
    EXPECT_NE(Report().closest, Report().closest_recalibrated);  // Else it would say little.
}

// Expected: with a clock of which each interval is longer than the last, two rounds are told apart in
// every time: one that heard of one round only would have its least for its greatest.
TEST(SceneReportFigures, OfTimeAreOfTheRoundsAskedFor) {
    EXPECT_GT(Report().times.size(), 60u);
    for (const auto& [name, time] : Report().times) {
        EXPECT_LT(time.interval.low, time.interval.high) << name;
        EXPECT_GT(time.value, time.interval.low) << name;
        EXPECT_LT(time.value, time.interval.high) << name;
    }
}

// Expected: what the passes of each preset touch with the radius that was asked for.
TEST(SceneReportFigures, OfTrafficAreWithTheRadiusAskedFor) {
    const Scene scene = TwoViews();
    Camera camera = scene.cameras.front();
    camera.width_px = 48;
    camera.height_px = 27;
    const GBuffer gbuffer = DrawGBuffer(scene, camera, SuitedTo(scene, camera, 8));
    const ResultTable& traffic = Report().traffic;
    std::size_t row = 0;
    for (const char* preset : {"supplement2012", "alchemy"}) {
        for (const PassBytes& pass :
             SaoTraffic(gbuffer, SaoWith(preset, {.radius_m = kRadiusM}))) {
            EXPECT_EQ(TextAt(traffic, row, "pass"), pass.name);
            EXPECT_EQ(NumberAt(traffic, row, "bytes_read"), pass.read) << preset;
            EXPECT_EQ(NumberAt(traffic, row, "bytes_written"), pass.written) << preset;
            ++row;
        }
        // Else a default radius would do.
        EXPECT_NE(SaoTraffic(gbuffer, SaoWith(preset, {.radius_m = kRadiusM}))[1].read,
                  SaoTraffic(gbuffer, SaoWith(preset, {.radius_m = 1.5}))[1].read);
    }
    EXPECT_EQ(traffic.rows.size(), row);
}

// Expected: the study by itself, with the report's radius and seed.
TEST(SceneReportFigures, OfFlickerAreWithTheRadiusAskedFor) {
    const Scene scene = TwoViews();
    const EmbreeCaster caster(scene);
    std::vector<ChosenTechnique> chosen;
    for (const std::string& name : kNames) chosen.push_back({name, {.radius_m = kRadiusM}});
    TemporalOptions options = Job().flicker;
    options.radius_m = kRadiusM;
    options.seed = 1;
    const ResultTable alone =
        FlickerTable(scene, scene.cameras.front(), caster, chosen, options, Ticking());
    ASSERT_EQ(alone.rows.size(), Report().flicker.rows.size());
    for (std::size_t t = 0; t < kNames.size(); ++t) {
        for (const char* key : {"candidate", "truth", "flicker"}) {
            EXPECT_EQ(NumberAt(Report().flicker, t, key), NumberAt(alone, t, key)) << key;
        }
    }
}

std::string With95(const Measured& m) {
    return Digits(m.value) + " (" + Digits(m.interval.low) + " to " + Digits(m.interval.high) +
           ")";
}

// Expected: time and error after recalibration in the line of their technique.
TEST(SceneReportWords, OfTheTerminalStandBesideTheirTechnique) {
    for (const std::string& name : kNames) {
        std::istringstream lines(Report().terminal);
        std::string line;
        while (std::getline(lines, line) && !line.starts_with(name)) {
        }
        const std::size_t row = RowOf(name, "all views", kTruthNear, "whole");
        for (const char* key : {"ms", "recalibrated_rmse", "rmse"}) {
            EXPECT_NE(line.find(" " + Digits(NumberAt(Report().scores, row, key))),
                      std::string::npos)
                << key << " of " << name << " in: " << line;
        }
    }
}

// Expected of the findings: the winners with their own errors, of the truth's error that of V within r,
// of the sweep its 5.0 %; of what intervals are the degrees of freedom between two views.
TEST(SceneReportWords, OfThePageAreOfTheirFigures) {
    const std::string& page = Report().page;
    const std::size_t begin = page.find("id=\"findings\"");
    const std::string findings = page.substr(begin, page.find("id=\"truth\"", begin) - begin);
    const auto expect = [&](const std::string& text) {
        EXPECT_NE(findings.find(text), std::string::npos) << text << "\n" << findings;
    };
    const auto of = [&](const std::string& name, const char* key) {
        return With95(
            MeasuredAt(Report().scores, RowOf(name, "all views", kTruthNear, "whole"), key));
    };
    expect(Report().closest);
    expect(of(Report().closest, "rmse"));
    expect(Report().closest_recalibrated);
    expect(of(Report().closest_recalibrated, "recalibrated_rmse"));
    EXPECT_NE(of(Report().closest_recalibrated, "recalibrated_rmse"),
              of(Report().closest_recalibrated, "rmse"));
    expect("The truth is known to " +
           Digits(NumberAt(Report().views, 0, "rms_standard_error_near"), 2) + " a pixel");
    expect("within 5.0 % of the least error");
    EXPECT_NE(Report().terminal.find("within 5.0 % of the least error"), std::string::npos);
    EXPECT_NE(page.find("t of 1 degrees of freedom"), std::string::npos);
}

class SceneReportPictures : public TempFolder {};

// Expected: the picture of a technique and that of its error against V within r, written here.
TEST_F(SceneReportPictures, AreAgainstVWithinR) {
    SceneReportJob job = Job();
    job.studies = false;
    job.techniques = {"hbao"};
    job.pictures = Path("pictures");
    const ReportResults report = ResultsOf(
        ReportScene({TwoViews(), {}, "digest"}, job, {.version = "test", .clock = Ticking()}));
    const View view(0);
    const Image<float> A = view.Of(TechniqueNamed("hbao", {.radius_m = kRadiusM}));
    const Mask seen = RegionsOf(view.truth).seen;
    const auto same = [&](const std::string& name, const auto& image) {
        WritePreview(Path("own.png"), image);
        EXPECT_NE(Get("own.png"), "");
        EXPECT_EQ(Get("pictures/" + name + ".png"), Get("own.png")) << name;
    };
    const Image<float>& near = view.truth.near.at(Falloff::kHard).value;
    same("hbao", A);
    same("hbao_error", SignedPicture(A, near, seen));
    same("truth_v", view.truth.V.value);
    same("truth_near", near);
    // The pictures are of the first view, and so is what stands below them.
    std::map<std::string, std::string> rmse;
    for (std::size_t k = 0; k < report.scores.rows.size(); ++k) {
        if (TextAt(report.scores, k, "truth") != kTruthNear) continue;
        if (TextAt(report.scores, k, "region") != "whole") continue;
        rmse[TextAt(report.scores, k, "view")] = Digits(NumberAt(report.scores, k, "rmse"));
    }
    EXPECT_NE(rmse.at("front"), rmse.at("side"));
    EXPECT_NE(report.page.find("error, RMSE " + rmse.at("front")), std::string::npos);
}

class RenderedScene : public TempFolder {};

// Expected: of the pixels that show a surface, by plain loops; depths along the axis as rays find them.
TEST_F(RenderedScene, HasTheMeanAndTheDepthsOfItsSurfaces) {
    RenderJob job;
    job.technique = "hbao";
    job.values = {{"radius_m", kRadiusM}};
    job.guard_px = 8;
    const RenderResult result =
        RenderScene({TwoViews(), {}, "digest"}, job, {.version = "test", .folder = folder_});
    const View view(0);
    const Image<float> A = view.Of(TechniqueNamed("hbao", {.radius_m = kRadiusM}));
    const Image<std::uint32_t> triangle = Shown(view.gbuffer.triangle, view.gbuffer.view);
    double sum = 0, n = 0;
    std::map<std::string, Image<float>> channels;
    for (NamedChannel& channel : ReadChannels(result.exr)) {
        channels.emplace(channel.name, std::move(channel.pixels));
    }
    for (std::size_t p = 0; p < A.Pixels().size(); ++p) {
        const float depth = channels.at("depth_m").Pixels()[p];
        if (triangle.Pixels()[p] == GBuffer::kSky) {
            EXPECT_EQ(depth, std::numeric_limits<float>::infinity());
            continue;
        }
        sum += A.Pixels()[p];
        ++n;
        const float by_rays = view.truth.pixels.depth_m.Pixels()[p];
        if (std::isfinite(by_rays)) {
            EXPECT_NEAR(depth, by_rays, 0.02 * by_rays) << p;
        }
    }
    EXPECT_GT(n, 1000);
    EXPECT_LT(n, 64 * 48 - 100);
    EXPECT_NEAR(result.mean, sum / n, 1e-6);
    EXPECT_EQ(channels.at("A.blur_y").Pixels(), A.Pixels());
}

}  // namespace
}  // namespace plumb
