// The documents of the benches, by a clock whose times are known: no number of theirs is left
// unchecked that a reader would take for a result.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/parallel.h"
#include "jobs/light/bench_light.h"
#include "jobs/light/convergence_study.h"
#include "jobs/memory_copy.h"
#include "jobs/screen_space/bench_ao.h"
#include "jobs/screen_space/bench_raster.h"
#include "jobs/screen_space/sao_traffic.h"
#include "jobs/truth/bench_truth.h"
#include "reports/render.h"
#include "scenes/simple.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"
#include "tests/jobs/stepping_clock.h"
#include "tests/reports/json_schema.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

void ExpectIs(const doc::Cell& cell, double value, double low, double high) {
    const auto* m = std::get_if<Measured>(&cell);
    ASSERT_NE(m, nullptr);
    EXPECT_DOUBLE_EQ(m->value, value);
    EXPECT_DOUBLE_EQ(m->interval.low, low);
    EXPECT_DOUBLE_EQ(m->interval.high, high);
}

void ExpectIsByItsSchema(const doc::Document& document) {
    EXPECT_THAT(SchemaErrors(PublishedSchema("document-1.json"),
                             nlohmann::json::parse(doc::ToJsonText(document))),
                IsEmpty());
}

Camera Sized(Camera camera, int width_px, int height_px) {
    camera.width_px = width_px;
    camera.height_px = height_px;
    return camera;
}

// Expected, by hand: 4 things, 3 rounds after one that warms up: thing t of round r is interval
// 4 r + t + 1. So depth and triangle take 5, 9 and 13 s, the copy 8, 12 and 16 s. Then the copy
// alone 18, 19, 20 s; then triangles of 100 pixels 23, 25, 27 s beside copies of 24, 26, 28 s.
TEST(BenchRaster, CountsWhatItTimes) {
    const Scene scene = BoxOnPlane();
    const int threads = ThreadCount();
    const doc::Document bench = BenchRaster(
        scene, {.width_px = 64, .height_px = 48, .rounds = 3, .legs_px = {100, 300}},
        {.clock = SteppingClock()});
    EXPECT_EQ(ThreadCount(), threads);
    ExpectIsByItsSchema(bench);
    EXPECT_THAT(bench.subtitle, HasSubstr("812 triangles"));  // docs/scenes.md
    const doc::Table& views = doc::TableOf(bench, "views");
    ASSERT_EQ(views.rows.size(), 1u);
    EXPECT_EQ(std::get<std::string>(views.At(0, "view")), "main");
    ExpectIs(views.At(0, "visibility_ms"), 9000, 5000, 13000);
    ExpectIs(views.At(0, "depth_ms"), 10000, 6000, 14000);
    ExpectIs(views.At(0, "gbuffer_ms"), 11000, 7000, 15000);
    ExpectIs(views.At(0, "of_copy"), 0.75, 5.0 / 8, 13.0 / 16);
    EXPECT_GT(doc::NumberOf(views.At(0, "covered")), 0.5);
    EXPECT_LT(doc::NumberOf(views.At(0, "covered")), 1);
    const double large = 1e-9 * double(kLargeCopyBytes);
    ExpectIs(doc::FactOf(bench, "copy_gb_per_s"), large / 19, large / 20, large / 18);
    EXPECT_EQ(doc::NumberOf(doc::FactOf(bench, "rounds")), 3);

    const doc::Table& triangles = doc::TableOf(bench, "triangles");
    ASSERT_EQ(triangles.rows.size(), 2u);
    EXPECT_EQ(doc::NumberOf(triangles.At(0, "triangles")), 20000);  // 1e8 pixels of 5000 each
    ExpectIs(triangles.At(0, "mtriangles_per_s"), 0.02 / 25, 0.02 / 27, 0.02 / 23);
    ExpectIs(triangles.At(0, "mpixels_per_s"), 100.0 / 25, 100.0 / 27, 100.0 / 23);
    // 4 bytes read and 4 written a pixel, beside all that the copy reads and writes.
    const double copies = double(kLargeCopyBytes) / 8e8;
    ExpectIs(triangles.At(0, "of_copy"), copies * 25 / 26, copies * 23 / 24, copies * 27 / 28);
    EXPECT_EQ(doc::NumberOf(triangles.At(1, "legs_px")), 300);
    EXPECT_EQ(doc::NumberOf(triangles.At(1, "triangles")), 2222);
}

// Each section on the threads that it says: the clock looks who is at work.
TEST(BenchRaster, TimesOneThreadWithOne) {
    SetThreadCount(2);
    std::vector<int> threads;
    double now_s = 0;
    BenchRaster(BoxOnPlane(), {.width_px = 64, .height_px = 48, .rounds = 1, .legs_px = {100}},
                {.clock = [&] {
                    threads.push_back(ThreadCount());
                    return now_s += 1;
                }});
    SetThreadCount(0);
    // Twice each, the warm-up too: 4 things of a view and a copy; triangles with a copy, and a copy.
    std::vector<int> expected(2 * 2 * 5, 2);
    expected.insert(expected.end(), 2 * 2 * 3, 1);
    EXPECT_EQ(threads, expected);
}

// Expected: triangles of legs l that do not overlap cover l^2 / 2 pixels each. Tolerance: the long side,
// which may pass through the centres of l pixels that then all are in or all out: l / 2, and one.
TEST(BenchRaster, DrawsTrianglesOfTheSizeThatItSays) {
    const Camera camera{
        .position_m = {0, 0, 0}, .target_m = {0, 1, 0}, .width_px = 1000, .height_px = 1000};
    for (const double legs_px : {7.3, 40.0, 100.0, 300.0}) {
        const std::int64_t side = std::int64_t(996 / legs_px);
        Scene scene;
        scene.materials.push_back({});
        scene.mesh = TrianglesOfSize(legs_px, side * side, camera);
        scene.material_of_face.assign(scene.mesh.quads.size(), 0);
        const GBuffer g = DrawGBuffer(scene, camera, {});
        const auto sky = std::ranges::count(g.triangle.Pixels(), GBuffer::kSky);
        EXPECT_NEAR((1e6 - double(sky)) / double(side * side), legs_px * legs_px / 2,
                    legs_px / 2 + 1)
            << legs_px;
    }
}

// Expected, by hand: 7 things, 1 round after one that warms up: they take 8, 9, ... 14 s. Titles
// name the radius that was asked for.
TEST(BenchAo, HasTheTimesAndTheRadiusThatItSays) {
    const Scene scene = BoxOnPlane();
    const doc::Document bench = BenchAo(scene, scene.cameras.front(),
                                        {.radius_m = 0.7, .rounds = 1, .sizes = {{64, 48, 8}}},
                                        {.clock = SteppingClock()});
    ExpectIsByItsSchema(bench);
    const doc::Table& passes = doc::TableOf(bench, "passes");
    EXPECT_EQ(std::get<std::string>(passes.At(0, "size_px")), "64 x 48 + 8");
    ExpectIs(passes.At(0, "sao_ms"), 8000, 8000, 8000);
    ExpectIs(passes.At(0, "alchemy_ms"), 9000, 9000, 9000);
    ExpectIs(passes.At(0, "alchemy_over_sao"), 9.0 / 8, 9.0 / 8, 9.0 / 8);
    ExpectIs(passes.At(0, "of_copy"), 8.0 / 14, 8.0 / 14, 8.0 / 14);
    // 64 x 48 px within 8 px: drawn are 80 x 64.
    const GBuffer gbuffer = DrawGBuffer(scene, Sized(scene.cameras.front(), 64, 48),
                                        SuitedTo(scene, scene.cameras.front(), 8));
    const double bytes =
        TotalBytes(SaoTraffic(gbuffer, SaoWith("supplement2012", {.radius_m = 0.7})));
    EXPECT_DOUBLE_EQ(doc::NumberOf(passes.At(0, "bytes_per_pixel")), bytes / (80 * 64));
    const doc::Table& sampling = doc::TableOf(bench, "sampling");
    EXPECT_EQ(doc::NumberOf(sampling.At(0, "near_ms")), 10000);
    EXPECT_EQ(doc::NumberOf(sampling.At(0, "far_ms")), 11000);
    EXPECT_EQ(doc::NumberOf(sampling.At(0, "far_no_pyramid_ms")), 12000);
    EXPECT_EQ(doc::NumberOf(sampling.At(0, "alchemy_ms")), 13000);
    const doc::Table& ratios = doc::TableOf(bench, "ratios");
    EXPECT_DOUBLE_EQ(doc::NumberOf(ratios.At(0, "far_over_near")), 1.1);
    EXPECT_DOUBLE_EQ(doc::NumberOf(ratios.At(0, "no_pyramid_over_pyramid")), 12.0 / 11);
    EXPECT_EQ(doc::NumberOf(doc::FactOf(bench, "radius_m")), 0.7);
    EXPECT_THAT(doc::ToTerminal(bench), HasSubstr("0.700 m"));
    EXPECT_THAT(doc::ToTerminal(bench), Not(HasSubstr("1.5")));  // The default, once printed.
}

// Expected: both ways cast the same rays, so they meet the same number of things; independent
// samples err by n^(-1/2), nets by less. The slope of 96 x 8 estimates over a factor of 256
// is known to about 0.02. By hand: 3 things, 1 round after one that warms up: 4, 5 and 6 s with one
// thread, 10, 11 and 12 s with two.
TEST(BenchTruth, ComparesTheSameRaysAndFindsTheSlopes) {
    TruthBenchSettings settings;
    settings.width_px = 96;
    settings.height_px = 64;
    settings.pixel_rows = 8;
    settings.rounds = 1;
    settings.furnace_paths = 0;
    settings.reference_rays = 65536;
    const doc::Document bench =
        BenchTruth(LoadScene("cornell_box"), settings, {.clock = SteppingClock()});
    ExpectIsByItsSchema(bench);
    EXPECT_EQ(doc::NumberOf(doc::FactOf(bench, "differing_rays")), 0);
    const doc::Table& speed = doc::TableOf(bench, "speed");
    ASSERT_EQ(speed.rows.size(), 2u);
    const double receivers = doc::NumberOf(doc::FactOf(bench, "pixels"));
    EXPECT_GT(receivers, 4 * 96);
    EXPECT_LE(receivers, 8 * 96);
    const double mrays = 1e-6 * 64 * receivers;
    EXPECT_DOUBLE_EQ(doc::NumberOf(speed.At(0, "mrays_per_s")), mrays / 4);
    EXPECT_DOUBLE_EQ(doc::NumberOf(speed.At(0, "bare_stream_mrays_per_s")), mrays / 5);
    EXPECT_DOUBLE_EQ(doc::NumberOf(speed.At(0, "bare_single_mrays_per_s")), mrays / 6);
    EXPECT_DOUBLE_EQ(doc::NumberOf(speed.At(0, "share")), 5.0 / 4);
    EXPECT_DOUBLE_EQ(doc::NumberOf(speed.At(1, "share")), 11.0 / 10);
    EXPECT_EQ(doc::NumberOf(speed.At(1, "threads")), 2);
    EXPECT_NEAR(doc::NumberOf(doc::FactOf(bench, "slope_independent")), -0.5, 0.06);
    EXPECT_LT(doc::NumberOf(doc::FactOf(bench, "slope_nets")), -0.65);
    const doc::Table& errors = doc::TableOf(bench, "convergence");
    ASSERT_EQ(errors.rows.size(), 5u);
    EXPECT_EQ(doc::NumberOf(errors.At(4, "rays")), 4096);
    EXPECT_LT(doc::NumberOf(errors.At(4, "rms_nets")),
              doc::NumberOf(errors.At(4, "rms_independent")));
}

// Law: of n independent samples V errs by sqrt(V (1 - V) / n), 1 / (2 sqrt n) at most; a quarter of
// that at least, since V is seldom near 0 or 1 in a box. Tolerance: an RMS of 96 x 8 estimates is
// known to 1 in sqrt(2 * 768), 3 %.
TEST(BenchTruth, ErrorsOfIndependentSamplesAreBinomial) {
    TruthBenchSettings settings;
    settings.width_px = 96;
    settings.height_px = 64;
    settings.pixel_rows = 8;
    settings.rounds = 1;
    settings.threads = {1};
    settings.furnace_paths = 1;
    settings.reference_rays = 65536;
    const doc::Document bench =
        BenchTruth(LoadScene("cornell_box"), settings, {.clock = SteppingClock()});
    const doc::Table& errors = doc::TableOf(bench, "convergence");
    for (std::size_t k = 0; k < errors.rows.size(); ++k) {
        const double most = 0.5 / std::sqrt(doc::NumberOf(errors.At(k, "rays")));
        EXPECT_LT(doc::NumberOf(errors.At(k, "rms_independent")), 1.1 * most);
        EXPECT_GT(doc::NumberOf(errors.At(k, "rms_independent")), most / 4);
        EXPECT_LT(doc::NumberOf(errors.At(k, "rms_nets")), 1.1 * most);
    }
    // One batch: 250 receivers, 8 nets of 512 walks. Every walk comes back.
    EXPECT_EQ(doc::NumberOf(doc::FactOf(bench, "paths")), 250 * 8 * 512);
    EXPECT_EQ(doc::NumberOf(doc::FactOf(bench, "lost")), 0);
    EXPECT_EQ(doc::NumberOf(doc::FactOf(bench, "deficit")), 0);
}

// Expected: with a clock that goes on by 1 s at each look, a stage or a turn takes 1 s, so that a
// rate is the count itself. Errors and links are those of the study and of the simulation run by
// themselves.
TEST(BenchLight, HasTheCountsOfWhatItRan) {
    const Surface surface = LoadSurface("make:bricks:24");
    const HeightField& field = surface.field;
    const LightBenchSettings settings{
        .slices = 8, .rays = 16, .bounces = 2, .casting_rays = 4, .rounds = 2};
    double now_s = 0;
    const doc::Document bench =
        BenchLight(surface, settings, [] { return 3.0 * 1024 * 1024 * 1024; },
                   {.clock = [&] { return now_s += 1; }});
    ExpectIsByItsSchema(bench);
    const doc::Table& whole = doc::TableOf(bench, "simulations");
    ASSERT_EQ(whole.rows.size(), 2u);
    const double facets = double(field.Facets());
    ExpectIs(whole.At(0, "links_s"), 1, 1, 1);
    ExpectIs(whole.At(0, "bounces_s"), 1, 1, 1);
    EXPECT_DOUBLE_EQ(doc::NumberOf(whole.At(0, "m_per_s")), 1e-6 * facets * 8);
    EXPECT_DOUBLE_EQ(doc::NumberOf(whole.At(1, "m_per_s")), 1e-6 * facets * 16);
    EXPECT_EQ(std::get<std::string>(whole.At(1, "method")), "rays");
    EXPECT_EQ(doc::NumberOf(whole.At(1, "per_facet")), 16);
    EXPECT_EQ(doc::NumberOf(whole.At(0, "peak_gib")), 3);
    SimulateSettings by_slices;
    by_slices.slices.slices = 8;
    const Links links = MakeLinksOf(field, FacetPieces(field, by_slices.cut), by_slices);
    EXPECT_EQ(doc::NumberOf(whole.At(0, "links")), double(links.Count()));
    EXPECT_DOUBLE_EQ(doc::NumberOf(whole.At(0, "bytes_per_link")),
                     double(links.MemoryBytes()) / double(links.Count()));

    const double rays = facets * 4;
    EXPECT_EQ(doc::NumberOf(doc::FactOf(bench, "casting_rays")), rays);
    EXPECT_GT(doc::NumberOf(doc::FactOf(bench, "agreement")), 0.99);
    const doc::Table& casting = doc::TableOf(bench, "casting");
    EXPECT_DOUBLE_EQ(doc::NumberOf(casting.At(0, "mrays_per_s")), 1e-6 * rays);
    ExpectIs(casting.At(0, "of_embree"), 1, 1, 1);
    const doc::Table& streams = doc::TableOf(bench, "streams");
    EXPECT_DOUBLE_EQ(doc::NumberOf(streams.At(0, "gb_per_s")),
                     1e-9 * double(links.MemoryBytes()));

    const doc::Table& errors = doc::TableOf(bench, "convergence");
    const Convergence study = StudyConvergence(surface.source.name, MiddleOf(field, 64),
                                               {.rounds = 1}, [] { return 0.0; });
    ASSERT_EQ(errors.rows.size(), study.points.size());
    for (std::size_t k = 0; k < study.points.size(); ++k) {
        EXPECT_EQ(doc::NumberOf(errors.At(k, "rms_v")), study.points[k].rms_V);
        EXPECT_EQ(doc::NumberOf(errors.At(k, "rms_e_half")), study.points[k].rms_E_half);
    }
    // The errors of slices fall with their number: 4, 8, 16, 32.
    for (std::size_t k = 1; k < 4; ++k) {
        EXPECT_LT(doc::NumberOf(errors.At(k, "rms_v")),
                  doc::NumberOf(errors.At(k - 1, "rms_v")));
    }
}

// Expected: with a clock of which each interval is longer than the last, bounces, which come later,
// take longer than links, and all of it longer than both.
TEST(BenchLight, HasEachStageInItsColumn) {
    const Surface surface = LoadSurface("make:bricks:16");
    double now_s = 0, step_s = 0;
    const doc::Document bench =
        BenchLight(surface,
                   {.slices = 4,
                    .rays = 8,
                    .bounces = 1,
                    .casting_rays = 1,
                    .rounds = 1,
                    .study_convergence = false},
                   [] { return 0.0; }, {.clock = [&] { return now_s += step_s += 1; }});
    const doc::Table& whole = doc::TableOf(bench, "simulations");
    for (std::size_t k = 0; k < 2; ++k) {
        const double links_s = doc::NumberOf(whole.At(k, "links_s"));
        const double bounces_s = doc::NumberOf(whole.At(k, "bounces_s"));
        EXPECT_GT(links_s, 0);
        EXPECT_GT(bounces_s, links_s);
        EXPECT_GT(doc::NumberOf(whole.At(k, "total_s")), links_s + bounces_s);
    }
}

}  // namespace
}  // namespace plumb
