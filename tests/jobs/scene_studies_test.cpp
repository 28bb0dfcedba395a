// The studies of a scene's report, each against what it must show or against the same made by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/error.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/ao_sweep.h"
#include "jobs/screen_space/error_budget.h"
#include "jobs/screen_space/find_closest.h"
#include "jobs/screen_space/guard_study.h"
#include "jobs/screen_space/layered_obscurance.h"
#include "jobs/screen_space/pyramid_study.h"
#include "jobs/screen_space/score_technique.h"
#include "jobs/screen_space/temporal_study.h"
#include "rays/embree/embree_caster.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/jobs/made_scenes.h"
#include "tests/jobs/plain_scores.h"

namespace plumb {
namespace {

// A scene with its truth, all with a radius of 1 m.
struct Measured1m {
    Scene scene;
    EmbreeCaster caster;
    ViewTruth truth;
    Image<int> seen;

    explicit Measured1m(Scene made) : scene(std::move(made)), caster(scene) {
        const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao};
        truth = MeasureViewTruth(caster, scene, View(), falloffs,
                                 {.radius_m = 1, .spp = 64, .far = false});
        seen = SeenPixels(truth);
    }
    const Camera& View() const { return scene.cameras.front(); }
    const TruthImage& Near() const { return truth.near.at(Falloff::kHard); }
    const TruthImage& Weighted() const { return truth.near.at(Falloff::kSao); }
};

RunContext Ticked() {
    return {.clock = Ticking()};
}

double At(const doc::Table& table, std::size_t row, const char* key) {
    return doc::NumberOf(table.At(row, key));
}

std::string TextAt(const doc::Table& table, std::size_t row, const char* key) {
    return std::get<std::string>(table.At(row, key));
}

const Measured& MeasuredAt(const doc::Table& table, std::size_t row, const char* key) {
    return std::get<Measured>(table.At(row, key));
}

// Expected: the noise of a truth of 16 rays taken off, that of 4096 rays has no error against it but
// what noise leaves, for V and within r; a floor of .0026 under the variances would show.
TEST(ViewTruth, LeavesNoErrorOfItsNoise) {
    const Scene scene = FloorAndWall(96, 54);
    const EmbreeCaster caster(scene);
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao};
    const auto truth = [&](int spp, std::uint64_t seed) {
        return MeasureViewTruth(caster, scene, scene.cameras.front(), falloffs,
                                {.radius_m = 1, .spp = spp, .seed = seed});
    };
    const ViewTruth coarse = truth(16, 1), fine = truth(4096, 2);
    const Mask seen = RegionsOf(coarse).seen;
    const auto expect = [&](const TruthImage& candidate, const TruthImage& of) {
        const Measured mse = ScoreErrors(candidate.value, of.value, of.standard_error, seen,
                                         {.truth_dof = kTruthNets - 1.0})
                                 .mse;
        EXPECT_LT(mse.noise_error, 3e-4);
        EXPECT_LT(std::abs(mse.value), 4 * mse.noise_error);
    };
    expect(fine.V, coarse.V);
    for (const Falloff falloff : falloffs) {
        expect(fine.near.at(falloff), coarse.near.at(falloff));
    }
}

// Expected of every row: A made here by the same functions, scored by plain loops. 1e-6: sums of
// floats in another order; 3e-4: the pass in float against the one in double.
TEST(ErrorBudget, GoesFromTheIdealToTheShipped) {
    const Measured1m m(FloorAndWall(96, 54));
    const SaoOptions shipped = SaoWith("supplement2012", {.radius_m = 1});
    const doc::Section budget = MakeErrorBudget(
        "sao", shipped, m.scene, m.View(), m.caster, m.truth,
        {.many_taps = 64, .stride_px = 2, .guard_px = 16, .rounds = 1}, Ticked());
    const doc::Table &rows = budget.tables[0], &no_border = budget.tables[1];
    ASSERT_EQ(rows.key, "budget");
    ASSERT_EQ(no_border.key, "no_border");
    std::vector<std::string> steps;
    for (std::size_t k = 0; k < rows.rows.size(); ++k) {
        steps.push_back(TextAt(rows, k, "step"));
    }
    ASSERT_EQ(steps, (std::vector<std::string>{"ideal", "estimator", "one layer", "border",
                                               "normals", "taps", "pyramid", "quads", "packing",
                                               "filter_x", "filter_y"}));
    const Image<int> pixels = Strided(m.seen, 2);
    const auto drawn = [&](int guard_px) {
        return DrawGBuffer(m.scene, m.View(), {.guard_px = guard_px});
    };
    const GBuffer wide = drawn(16), none = drawn(0);  // A quarter of 54 px is less than 16.
    std::vector<Image<float>> pictures{m.Weighted().value};
    SaoOptions many = shipped;
    many.sampling.taps.samples = 64;
    many.sampling.taps.turns = 0;
    many.sampling.taps.phi = PhiArithmetic::kExact;
    many.sampling.taps.coarsest_level = 0;
    many.quad_filter = many.pack_rgb8 = many.blur_x = many.blur_y = false;
    SaoOptions face = many;
    face.sampling.normals = NormalSource::kFace;
    Image<float> layered =
        LayeredObscurance({wide, m.scene, m.View(), m.caster}, face, {.stride_px = 2});
    for (float& a : layered.Pixels()) a = std::isnan(a) ? 0.0f : a;  // None is counted.
    pictures.push_back(layered);
    const auto sao = [&](const GBuffer& gbuffer, const SaoOptions& options) {
        return Shown(SaoObscurance(gbuffer, options), gbuffer.view);
    };
    pictures.push_back(sao(wide, face));
    pictures.push_back(sao(wide, face));
    pictures.push_back(sao(wide, many));
    SaoOptions now = shipped;
    now.sampling.taps.coarsest_level = 0;
    now.quad_filter = now.pack_rgb8 = now.blur_x = now.blur_y = false;
    pictures.push_back(sao(wide, now));
    now.sampling.taps.coarsest_level = shipped.sampling.taps.coarsest_level;
    pictures.push_back(sao(wide, now));
    for (bool SaoOptions::*pass : {&SaoOptions::quad_filter, &SaoOptions::pack_rgb8,
                                   &SaoOptions::blur_x, &SaoOptions::blur_y}) {
        now.*pass = true;
        pictures.push_back(sao(wide, now));
    }
    ASSERT_EQ(pictures.size(), rows.rows.size());
    const double scored = PlainScore(pictures[0], m.Near(), pixels).pixels;
    for (std::size_t k = 0; k < rows.rows.size(); ++k) {
        const double tolerance = k >= 2 && k <= 5 ? 3e-4 : 1e-6;
        const TruthImage near{m.Near().value,
                              k == 0 ? Image<float>() : m.Near().standard_error};
        const PlainErrors plain = PlainScore(pictures[k], near, pixels);
        EXPECT_NEAR(At(rows, k, "mse"), plain.mse, tolerance) << steps[k];
        EXPECT_NEAR(At(rows, k, "bias"), plain.bias, tolerance) << steps[k];
        EXPECT_NEAR(At(rows, k, "own_mse"), PlainScore(pictures[k], m.Weighted(), pixels).mse,
                    tolerance)
            << steps[k];
        EXPECT_EQ(At(rows, k, "pixels"), scored);
        EXPECT_EQ(std::isfinite(At(rows, k, "ms")), k >= 5) << steps[k];
        if (k == 0) continue;
        EXPECT_NEAR(At(rows, k, "rms_change"), PlainRms(pictures[k], pictures[k - 1], pixels),
                    k <= 5 ? 1e-3 : 1e-6)
            << steps[k];
    }
    EXPECT_EQ(doc::NumberOf(budget.facts[1].value), scored);
    EXPECT_LT(At(rows, 8, "rms_change"),
              1.5 / 255);  // RGB8 rounds A by 1/2 of 1/255, z's bits moved
    SaoOptions aligned = shipped;
    aligned.sampling.taps.hash_shift_px = 16;
    const Image<float> borderless = sao(none, aligned);
    EXPECT_NEAR(At(no_border, 0, "mse"), PlainScore(borderless, m.Near(), pixels).mse, 1e-6);
    EXPECT_NEAR(At(no_border, 0, "rms_change"), PlainRms(borderless, pictures.back(), pixels),
                1e-6);
    EXPECT_NEAR(At(no_border, 0, "ms"), 1, 1e-9);
}

// Expected: on every pixel the steps lead to the very score of the technique, whole numbers of bits.
TEST(ErrorBudget, EndsAtTheTechniquesOwnScore) {
    const Measured1m m(FloorAndWall(48, 27));
    const SaoOptions shipped = SaoWith("supplement2012", {.radius_m = 1});
    const doc::Table rows =
        MakeErrorBudget("sao", shipped, m.scene, m.View(), m.caster, m.truth,
                        {.many_taps = 8, .stride_px = 1, .guard_px = 16, .rounds = 1}, Ticked())
            .tables[0];
    const std::size_t last = rows.rows.size() - 1;
    const GBuffer gbuffer = DrawGBuffer(m.scene, m.View(), {.guard_px = 16});
    const Technique technique = TechniqueNamed("sao-supplement2012", {.radius_m = 1});
    const Image<float> A =
        Shown(technique.run({gbuffer, m.scene, m.View(), m.caster}, Ticking()).back().A,
              gbuffer.view);
    const std::vector<ScoreAgainst> scores =
        ScoreAll(A, m.truth, RegionsOf(m.truth), technique.falloff);
    const ScoreAgainst& near = Against(scores, kTruthNear, "whole");
    EXPECT_EQ(At(rows, last, "rmse"), near.error.rmse.value);
    EXPECT_EQ(At(rows, last, "recalibrated_rmse"), near.recalibrated_rmse.value);
    EXPECT_EQ(At(rows, last, "own_rmse"),
              Against(scores, kTruthWeighted, "whole").error.rmse.value);
    EXPECT_EQ(At(rows, last, "pixels"), double(near.error.pixels));
}

// Expected: five widths more than none, each by whole texels of the pyramid's coarsest level (32 px)
// or, without one, whole quads, near a twentieth of the height.
TEST(StudyGuardBand, WidensByWholeTexels) {
    SaoOptions sao = SaoWith("supplement2012", {.radius_m = 1});
    EXPECT_EQ(GuardWidths(540, sao), (std::vector<int>{0, 32, 64, 96, 128, 160}));
    EXPECT_EQ(GuardWidths(1600, sao), (std::vector<int>{0, 96, 192, 288, 384, 480}));
    EXPECT_EQ(GuardWidths(54, sao), (std::vector<int>{0, 32, 64, 96, 128, 160}));
    sao.sampling.taps.coarsest_level = 0;
    EXPECT_EQ(GuardWidths(540, sao), (std::vector<int>{0, 28, 56, 84, 112, 140}));
    EXPECT_EQ(GuardWidths(20, sao), (std::vector<int>{0, 2, 4, 6, 8, 10}));
}

// Expected: a floor with its wall that lies whole within the frame, with sky around it, so
// that no tap meets anything beyond the frame: the border changes nothing. A is kept in 255 steps on
// the way, and rounding moves a tap of a hundred: less than 0.004 / sqrt(10).
TEST(StudyGuardBand, ChangesNothingWhereNothingIsBeyondTheFrame) {
    Scene scene = FloorAndWall(192, 108);
    scene.cameras.front().position_m = {0.5, -8.5, 5};
    scene.cameras.front().target_m = {0, 0, 0};
    const Camera& camera = scene.cameras.front();
    const EmbreeCaster caster(scene);
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao};
    const ViewTruth truth = MeasureViewTruth(caster, scene, camera, falloffs,
                                             {.radius_m = 1, .spp = 16, .far = false});
    const SaoOptions sao = SaoWith("supplement2012", {.radius_m = 1});
    const doc::Table rows = StudyGuardBand(scene, camera, truth, sao, 1, Ticked()).tables[0];
    ASSERT_EQ(rows.rows.size(), 6u);
    EXPECT_GT(At(rows, 0, "max"), 0.02);  // There is something to change.
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_GT(At(rows, k, "pixels"), 300);
        EXPECT_LT(At(rows, k, "rms_to_widest"), 0.0013) << k;
        EXPECT_EQ(At(rows, k, "share_of_height"), At(rows, k, "guard_px") / 108.0);
    }
}

// Expected: each row's picture made here, against the widest and against the truth by plain loops;
// the widest is itself.
TEST(StudyGuardBand, IsThePictureOfEachBorder) {
    const Measured1m m(FloorAndWall(96, 80));
    const SaoOptions sao = SaoWith("supplement2012", {.radius_m = 1});
    const doc::Table rows =
        StudyGuardBand(m.scene, m.View(), m.truth, sao, 3, Ticked()).tables[0];
    ASSERT_EQ(rows.rows.size(), 6u);
    const Image<int> border = SeenAtBorder(m.truth);
    const auto picture = [&](int guard_px) {
        const GBuffer gbuffer = DrawGBuffer(m.scene, m.View(), {.guard_px = guard_px});
        SaoOptions shifted = sao;
        shifted.sampling.taps.hash_shift_px = 160 - guard_px;
        return Shown(SaoObscurance(gbuffer, shifted), gbuffer.view);
    };
    const Image<float> widest = picture(160);
    for (std::size_t k = 0; k < 6; ++k) {
        ASSERT_EQ(At(rows, k, "guard_px"), 32 * double(k));
        const Image<float> A = picture(32 * int(k));
        EXPECT_NEAR(At(rows, k, "rms_to_widest"), PlainRms(A, widest, border), 1e-6);
        const PlainErrors plain = PlainScore(A, m.Weighted(), border);
        EXPECT_NEAR(At(rows, k, "mse"), plain.mse, 1e-6);
        EXPECT_EQ(At(rows, k, "pixels"), plain.pixels);
        EXPECT_NEAR(At(rows, k, "draw_ms"), 1, 1e-9);
        EXPECT_NEAR(At(rows, k, "sao_ms"), 1, 1e-9);
    }
    EXPECT_EQ(At(rows, 5, "rms_to_widest"), 0);
    EXPECT_GT(At(rows, 0, "rms_to_widest"), 0.005);
}

// Expected: each row's picture made here; the first is itself without a pyramid. Of nearest and
// farthest depth the nearest occludes more, so that A is smaller.
TEST(StudyPyramid, IsThePictureOfEachFilter) {
    const Measured1m m(FloorAndWall(96, 54));
    SaoOptions sao = SaoWith("supplement2012", {.radius_m = 1});
    const GBuffer gbuffer = DrawGBuffer(m.scene, m.View(), {.guard_px = 8});
    const doc::Table rows =
        StudyPyramid({gbuffer, m.scene, m.View(), m.caster}, m.truth, sao).tables[0];
    ASSERT_EQ(rows.rows.size(), 7u);
    const std::vector<std::pair<std::string, ZFilter>> filters{
        {"rotated_grid", ZFilter::kRotatedGrid},
        {"rotated_grid_g3d10", ZFilter::kRotatedGridG3d10},
        {"mean", ZFilter::kMean},
        {"harmonic_mean", ZFilter::kHarmonicMean},
        {"min", ZFilter::kMin},
        {"max", ZFilter::kMax}};
    sao.quad_filter = sao.pack_rgb8 = sao.blur_x = sao.blur_y = false;
    SaoOptions without = sao;
    without.sampling.taps.coarsest_level = 0;
    const Image<float> none = Shown(SaoObscurance(gbuffer, without), gbuffer.view);
    for (std::size_t k = 0; k < 7; ++k) {
        if (k > 0) sao.sampling.taps.filter = filters[k - 1].second;
        const Image<float> A = k == 0 ? none : Shown(SaoObscurance(gbuffer, sao), gbuffer.view);
        EXPECT_EQ(TextAt(rows, k, "filter"), k == 0 ? "none" : filters[k - 1].first);
        EXPECT_NEAR(At(rows, k, "rms_to_none"), PlainRms(A, none, m.seen), 1e-6);
        EXPECT_NEAR(At(rows, k, "bias_to_none"), PlainScore(A, {none, {}}, m.seen).bias, 1e-6);
        EXPECT_NEAR(At(rows, k, "mse"), PlainScore(A, m.Weighted(), m.seen).mse, 1e-6);
    }
    EXPECT_EQ(At(rows, 0, "rms_to_none"), 0);
    EXPECT_LT(At(rows, 6, "bias_to_none"), At(rows, 5, "bias_to_none"));
}

// Expected: points with the settings they name, made here; the front and the cheapest by comparing
// each with each.
TEST(SweepTechniques, ScoresTheSettingsThatItNames) {
    const Measured1m m(FloorAndWall(64, 36));
    const GBuffer gbuffer = DrawGBuffer(m.scene, m.View(), {.guard_px = 8});
    const TechniqueInput in{gbuffer, m.scene, m.View(), m.caster};
    const std::vector<ChosenTechnique> chosen{{"sao-g3d10", {.radius_m = 0.8}},
                                              {"rays-8", {.radius_m = 1}}};
    const Sweep sweep = SweepTechniques(in, m.truth, chosen, 2, 0.05, Ticked());
    const doc::Table& points = sweep.section.sections[1].tables[0];
    ASSERT_EQ(points.key, "sweep");
    ASSERT_EQ(points.rows.size(), 18u);
    const auto place = [&](const std::string& technique, const std::string& setting) {
        for (std::size_t k = 0; k < points.rows.size(); ++k) {
            if (TextAt(points, k, "technique") == technique &&
                TextAt(points, k, "setting") == setting) {
                return k;
            }
        }
        throw std::runtime_error(technique + " " + setting);
    };
    const auto rmse_of = [&](const std::string& technique, const std::string& setting) {
        return At(points, place(technique, setting), "rmse");
    };
    const auto mse = [&](const Technique& technique, const TechniqueInput& on) {
        Image<float> A = Shown(technique.run(on, Ticking()).back().A, on.gbuffer.view);
        if (on.gbuffer.view.width_px == 32) A = Doubled(A, 64, 36);
        return PlainScore(A, m.Near(), m.seen).mse;
    };
    const auto expect = [&](const std::string& name, const std::string& setting,
                            const TechniqueSettings& settings) {
        const double rmse = rmse_of(name, setting);
        EXPECT_NEAR(rmse * rmse, mse(TechniqueNamed(name, settings), in), 1e-6) << setting;
    };
    expect("sao-g3d10", "as shipped", {.radius_m = 0.8});
    expect("sao-g3d10", "half the radius", {.radius_m = 0.4});
    expect("sao-g3d10", "twice the radius", {.radius_m = 1.6});
    expect("sao-g3d10", "no filter", {.radius_m = 0.8, .filter = false});
    expect("sao-g3d10", "16 lookups", {.radius_m = 0.8, .samples = 16});
    expect("rays-8", "twice the radius", {.radius_m = 2});
    const auto sao_mse = [&](const SaoOptions& with) {
        return PlainScore(Shown(SaoObscurance(gbuffer, with), gbuffer.view), m.Near(), m.seen)
            .mse;
    };
    SaoOptions options = SaoWith("g3d10", {.radius_m = 0.8});
    options.sampling.taps.coarsest_level = 0;
    const double no_pyramid = rmse_of("sao-g3d10", "no pyramid");
    EXPECT_NEAR(no_pyramid * no_pyramid, sao_mse(options), 1e-6);
    options = SaoWith("g3d10", {.radius_m = 0.8});
    options.quad_filter = true;
    const double with_quads = rmse_of("sao-g3d10", "with quads");
    EXPECT_NEAR(with_quads * with_quads, sao_mse(options), 1e-6);
    Camera half = m.View();
    half.width_px = 32;
    half.height_px = 18;
    const GBuffer small = DrawGBuffer(m.scene, half, {.guard_px = 4});
    const double halved = rmse_of("rays-8", "half resolution");
    EXPECT_NEAR(
        halved * halved,
        mse(TechniqueNamed("rays-8", {.radius_m = 1}), {small, m.scene, half, m.caster}), 1e-6);

    double least = 1;
    for (std::size_t k = 0; k < 18; ++k) least = std::min(least, At(points, k, "rmse"));
    std::string cheapest;
    double cheapest_ms = 1e9, cheapest_rmse = 1;
    std::set<std::string> front;
    for (std::size_t k = 0; k < 18; ++k) {
        const double ms = At(points, k, "ms"), rmse = At(points, k, "rmse");
        bool beaten = false;
        for (std::size_t q = 0; q < 18; ++q) {
            beaten |= At(points, q, "ms") < ms && At(points, q, "rmse") < rmse;
        }
        const std::string name =
            TextAt(points, k, "technique") + ", " + TextAt(points, k, "setting");
        const bool on_front = TextAt(points, k, "pareto") == "yes";
        EXPECT_FALSE(beaten && on_front) << name;
        if (on_front) front.insert(name);
        EXPECT_LE(MeasuredAt(points, k, "rmse").interval.low, rmse);
        EXPECT_GE(MeasuredAt(points, k, "rmse").interval.high, rmse);
        EXPECT_TRUE(std::isfinite(MeasuredAt(points, k, "rmse").interval.high));
        EXPECT_TRUE(std::isfinite(MeasuredAt(points, k, "recalibrated_rmse").interval.high));
        if (rmse > 1.05 * least) continue;
        if (ms > cheapest_ms + 1e-6) continue;
        if (ms > cheapest_ms - 1e-6 && rmse >= cheapest_rmse) continue;
        cheapest_ms = ms;
        cheapest_rmse = rmse;
        cheapest = name;
    }
    EXPECT_EQ(sweep.cheapest.name, cheapest);
    EXPECT_FALSE(front.empty());

    // The front's own table and the plot hold these rows and numbers, the fastest first.
    const doc::Table& shown = sweep.section.sections[0].tables[0];
    ASSERT_EQ(shown.key, "pareto_front");
    ASSERT_EQ(shown.rows.size(), front.size());
    const Plot& plot = sweep.section.plots[0].plots[0];
    ASSERT_EQ(plot.views.size(), 2u);
    ASSERT_EQ(plot.views[0].series.size(), 3u);
    ASSERT_EQ(plot.views[1].series.size(), 2u);
    const PlotSeries& line = plot.views[0].series[2];
    EXPECT_EQ(line.label, "Pareto front");
    for (std::size_t k = 0; k < shown.rows.size(); ++k) {
        const std::string technique = TextAt(shown, k, "technique"),
                          setting = TextAt(shown, k, "setting");
        EXPECT_TRUE(front.contains(technique + ", " + setting));
        const std::size_t same = place(technique, setting);
        EXPECT_EQ(At(shown, k, "rmse"), At(points, same, "rmse"));
        EXPECT_EQ(At(shown, k, "ms"), At(points, same, "ms"));
        if (k > 0) {
            EXPECT_GE(At(shown, k, "ms"), At(shown, k - 1, "ms"));
        }
        EXPECT_EQ(line.x.Values()[k], At(shown, k, "ms"));
        EXPECT_EQ(line.y.Values()[k], At(shown, k, "rmse"));
    }
    std::size_t row = 0;
    for (std::size_t t = 0; t < 2; ++t) {
        const PlotSeries &plain = plot.views[0].series[t], &after = plot.views[1].series[t];
        EXPECT_EQ(plain.label, chosen[t].name);
        EXPECT_EQ(after.label, chosen[t].name);
        for (std::size_t k = 0; k < plain.x.Values().size(); ++k, ++row) {
            EXPECT_EQ(TextAt(points, row, "technique"), chosen[t].name);
            EXPECT_EQ(plain.x.Values()[k], At(points, row, "ms"));
            EXPECT_EQ(plain.y.Values()[k], At(points, row, "rmse"));
            EXPECT_EQ(after.y.Values()[k], At(points, row, "recalibrated_rmse"));
        }
    }
    EXPECT_EQ(row, 18u);
}

std::vector<ChosenTechnique> With1m(const std::vector<std::string>& names) {
    std::vector<ChosenTechnique> chosen;
    for (const std::string& name : names) chosen.push_back({name, {.radius_m = 1}});
    return chosen;
}

// Expected: rays drawn anew in every frame err by their noise, whose variance falls as 1 / rays;
// nets fall faster. What the truth does is the same for every technique.
TEST(StudyFlicker, SeesNoiseThatChangesFromFrameToFrame) {
    const Scene scene = FloorAndWall(64, 36);
    const EmbreeCaster caster(scene);
    const TemporalOptions options{
        .frames = 6, .width_px = 64, .height_px = 36, .guard_px = 8, .spp = 64, .radius_m = 1};
    const doc::Table rows = StudyFlicker(scene, scene.cameras.front(), caster,
                                         With1m({"rays-1", "rays-8"}), options, Ticked())
                                .tables[0];
    ASSERT_EQ(rows.rows.size(), 2u);
    EXPECT_EQ(TextAt(rows, 0, "technique"), "rays-1");
    EXPECT_EQ(At(rows, 0, "truth"), At(rows, 1, "truth"));
    EXPECT_GT(At(rows, 0, "flicker"), 4 * At(rows, 1, "flicker"));
    EXPECT_GT(At(rows, 0, "candidate"), At(rows, 1, "candidate"));
    EXPECT_THROW(StudyFlicker(scene, scene.cameras.front(), caster, With1m({"rays-1"}),
                              {.frames = 1}, Ticked()),
                 Error);
}

// Expected: a floor alone is open whatever the camera does: no variance of anything; and its
// edges, where floor turns to sky, are no pixels that count.
TEST(StudyFlicker, IsNothingWhereNothingOccludes) {
    Scene scene;
    scene.materials.push_back({});
    AddFace(scene, {Vec3f(-4, -4, 0), Vec3f(4, -4, 0), Vec3f(4, 4, 0), Vec3f(-4, 4, 0)});
    scene.cameras = FloorAndWall(64, 36).cameras;
    const EmbreeCaster caster(scene);
    const doc::Table rows = StudyFlicker(scene, scene.cameras.front(), caster,
                                         With1m({"sao-supplement2012", "rays-2"}),
                                         {.frames = 3,
                                          .width_px = 64,
                                          .height_px = 36,
                                          .guard_px = 8,
                                          .spp = 16,
                                          .radius_m = 1},
                                         Ticked())
                                .tables[0];
    for (std::size_t k = 0; k < 2; ++k) {  // In millionths: 1e-10, what bytes round.
        EXPECT_LT(At(rows, k, "candidate"), 1e-4) << k;
        EXPECT_EQ(At(rows, k, "truth"), 0);
        EXPECT_LT(At(rows, k, "flicker"), 1e-4);
    }
}

// Pictures with errors of +-0.1, +-0.1 and +-0.3 at random. Of one view: the two alike are a tie, the
// third is not. Of three views, each twice as dark as the last: the same, because shares are compared.
TEST(FindClosest, NamesTheWinnerAndItsTies) {
    const int n = 64;
    const Mask all(n, n, 1);
    TruthImage truth{Image<float>(n, n, 0.5f), Image<float>(n, n, 0.0f)};
    std::uint32_t state = 1;
    const auto noisy = [&](float size) {
        Image<float> picture(n, n);
        for (float& p : picture.Pixels()) {
            state = state * 1664525u + 1013904223u;
            p = 0.5f + size * (float(state >> 8) / float(1 << 23) - 1);
        }
        return picture;
    };
    for (const int views : {1, 3}) {
        std::vector<Contestant> contestants{{"worst", {}}, {"a", {}}, {"b", {}}};
        std::vector<ComparedView> compared;
        for (int v = 0; v < views; ++v) {
            const float size = 0.05f * float(1 << v);
            contestants[0].pictures.push_back(noisy(3 * size));
            contestants[1].pictures.push_back(noisy(size));
            // Now better, now worse: neither of the two is ahead everywhere.
            contestants[2].pictures.push_back(noisy(views == 1 ? size
                                                    : v == 1   ? 0.9f * size
                                                               : 1.1f * size));
            compared.push_back({&truth, &all});
        }
        const Closest closest = FindClosest(contestants, compared);
        EXPECT_NE(closest.name, "worst") << views;
        EXPECT_EQ(closest.ties, std::vector<std::string>{closest.name == "a" ? "b" : "a"})
            << views;
        EXPECT_EQ(TiesOf(0, contestants, compared), std::vector<std::string>{}) << views;
    }
}

}  // namespace
}  // namespace plumb
