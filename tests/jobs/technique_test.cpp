// Techniques called alike, and what jobs/ itself makes of rays: held against closed forms.
#include "jobs/screen_space/technique.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "jobs/pictures.h"
#include "jobs/screen_space/layered_obscurance.h"
#include "jobs/screen_space/render_scene.h"
#include "jobs/screen_space/score_technique.h"
#include "jobs/screen_space/signed_picture.h"
#include "jobs/screen_space/time_techniques.h"
#include "rays/embree/embree_caster.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "techniques/ray_traced_visibility.h"
#include "tests/jobs/made_scenes.h"

namespace plumb {
namespace {

double ZeroClock() {
    return 0;
}

struct Drawn {
    Scene scene;
    Camera camera;
    EmbreeCaster caster;
    GBuffer gbuffer;

    Drawn(Scene made, int guard_px)
        : scene(std::move(made)),
          camera(scene.cameras.front()),
          caster(scene),
          gbuffer(DrawGBuffer(scene, camera, {.guard_px = guard_px})) {}

    TechniqueInput In() const { return {gbuffer, scene, camera, caster}; }
};

// Expected: every technique gives numbers in [0, 1] on a floor and a wall (a slice's cosine
// weights may exceed 1, to pi/2), 1 for the sky, and the same bits on one thread and on two.
TEST(Techniques, GiveNumbersAndTheSameBitsOnAnyNumberOfThreads) {
    const Drawn drawn(FloorAndWall(96, 54), 16);
    for (const std::string& name : TechniqueNames()) {
        const Technique technique = TechniqueNamed(name, {.radius_m = 1});
        EXPECT_GT(technique.samples, 0) << name;
        SetThreadCount(1);
        const std::vector<Pass> one = technique.run(drawn.In(), ZeroClock);
        SetThreadCount(2);
        const std::vector<Pass> two = technique.run(drawn.In(), ZeroClock);
        SetThreadCount(0);
        const Image<float>&A = one.back().A, &B = two.back().A;
        ASSERT_EQ(A.Width(), drawn.gbuffer.view.DrawnWidth()) << name;
        EXPECT_EQ(A.Pixels(), B.Pixels()) << name;
        double least = 1, mean = 0;
        for (std::size_t p = 0; p < A.Pixels().size(); ++p) {
            const double a = A.Pixels()[p];
            ASSERT_TRUE(a >= 0 && a <= 1.5708) << name << " " << a;
            if (drawn.gbuffer.triangle.Pixels()[p] == GBuffer::kSky) {
                ASSERT_GT(a, 0.9999) << name;
            }
            least = std::min(least, a);
            mean += a / double(A.Pixels().size());
        }
        EXPECT_LT(least, 0.9) << name << " sees no corner";
        EXPECT_GT(mean, 0.5) << name;
    }
}

TEST(Techniques, AreRefusedByName) {
    EXPECT_THROW(TechniqueNamed("ssao"), Error);
    EXPECT_THROW(TechniqueNamed("gtao-paper", {.radius_m = 0}), Error);
    EXPECT_THROW(TechniqueNamed("gtao-paper", {.radius_m = -1}), Error);
    EXPECT_THROW(TechniqueNamed("gtao-paper", {.radius_m = std::nan("")}), Error);
    EXPECT_THROW(TechniqueNamed("gtao-paper", {.radius_m = 1, .samples = 5000}), Error);
}

// Expected: paper's table 3: 128 px at 720 rows, 192 px at 1080.
TEST(GuardPx, IsThePapersShare) {
    EXPECT_EQ(GuardPx(-1, 720), 128);
    EXPECT_EQ(GuardPx(-1, 1080), 192);
    EXPECT_EQ(GuardPx(7, 1080), 7);
    EXPECT_THROW(GuardPx(-2, 720), Error);
}

// Expected: the rays are the truth's own question, so their mean over the picture is the truth's
// mean. Tolerance: 4 standard errors of N rays over the picture, p (1 - p) <= 1/4.
TEST(RayTracedVisibility, HasTheMeanOfTheTruth) {
    const Drawn drawn(FloorAndWall(160, 90), 0);
    const std::vector<Falloff> hard{Falloff::kHard};
    const ViewTruth truth = MeasureViewTruth(drawn.caster, drawn.scene, drawn.camera, hard,
                                             {.radius_m = 0.7, .spp = 256, .far = false});
    const Image<float> A = RayTracedVisibility(drawn.caster, drawn.scene, drawn.camera,
                                               drawn.gbuffer, {.radius_m = 0.7, .rays = 4});
    const Mask seen = RegionsOf(truth).seen;
    double sum = 0, truth_sum = 0, n = 0;
    for (std::size_t p = 0; p < seen.Pixels().size(); ++p) {
        if (seen.Pixels()[p] == 0) continue;
        sum += A.Pixels()[p];
        truth_sum += truth.near.at(Falloff::kHard).value.Pixels()[p];
        ++n;
    }
    ASSERT_GT(n, 5000);
    EXPECT_LT(truth_sum / n, 0.99);
    EXPECT_NEAR(sum / n, truth_sum / n, 4 * 0.5 / std::sqrt(4 * n));
    // The same rays every time; other rays with another seed.
    EXPECT_EQ(A.Pixels(), RayTracedVisibility(drawn.caster, drawn.scene, drawn.camera,
                                              drawn.gbuffer, {.radius_m = 0.7, .rays = 4})
                              .Pixels());
    EXPECT_NE(A.Pixels(),
              RayTracedVisibility(drawn.caster, drawn.scene, drawn.camera, drawn.gbuffer,
                                  {.radius_m = 0.7, .rays = 4, .seed = 2})
                  .Pixels());
}

SaoOptions ManyTaps() {
    SaoOptions options = SaoWith("supplement2012", {.radius_m = 1, .samples = 256});
    options.sampling.taps.coarsest_level = 0;
    options.sampling.taps.phi = PhiArithmetic::kExact;
    options.sampling.taps.place = TapPlace::kTexel;
    options.sampling.normals = NormalSource::kFace;
    options.quad_filter = options.pack_rgb8 = options.blur_x = options.blur_y = false;
    return options;
}

// Expected: where every surface is seen, one layer is all layers: the estimator on full
// geometry is that on the depth buffer. Tolerance: a tap rounds to a pixel, 1 px of a disc of
// h px, so single pixels differ by the order of 1 / r'; their mean by less.
TEST(LayeredObscurance, IsTheDepthBuffersWhereNothingIsHidden) {
    const Drawn drawn(FloorAndWall(160, 90), 32);
    const SaoOptions options = ManyTaps();
    const Image<float> all = LayeredObscurance(drawn.In(), options, {.stride_px = 2});
    const Image<float> one = Shown(SaoObscurance(drawn.gbuffer, options), drawn.gbuffer.view);
    double difference = 0, depth = 0, n = 0;
    for (int j = 0; j < all.Height(); j += 2) {
        for (int i = 0; i < all.Width(); i += 2) {
            ASSERT_FALSE(std::isnan(all(i, j)));
            difference += std::abs(all(i, j) - one(i, j));
            depth += 1 - one(i, j);
            ++n;
        }
    }
    EXPECT_TRUE(std::isnan(all(1, 0)));
    EXPECT_GT(depth / n, 0.01);
    EXPECT_LT(difference / n, 0.1 * depth / n);
}

// Expected: the floor beside the post is shaded by it, which only all layers show: what the depth
// buffer has there is the screen, farther from the floor than the radius.
TEST(LayeredObscurance, SeesWhatTheDepthBufferHides) {
    const Drawn drawn(FloorWithHiddenPost(160, 90), 32);
    const SaoOptions options = ManyTaps();
    const Image<float> all = LayeredObscurance(drawn.In(), options, {.stride_px = 1});
    const Image<float> one = Shown(SaoObscurance(drawn.gbuffer, options), drawn.gbuffer.view);
    int darker = 0, lighter = 0;
    for (std::size_t p = 0; p < all.Pixels().size(); ++p) {
        darker += all.Pixels()[p] < one.Pixels()[p] - 0.05F;
        lighter += all.Pixels()[p] > one.Pixels()[p] + 0.05F;
    }
    EXPECT_GT(darker, 100);
    EXPECT_LT(lighter, darker / 10);
}

TEST(SignedPicture, IsBlueWhiteRedAndGrey) {
    Image<float> A(4, 1), t(4, 1, 0.5F);
    A.Pixels() = {0.25F, 0.5F, 0.75F, 0.9F};
    Mask seen(4, 1, 1);
    seen(3, 0) = 0;
    const Image<Rgb> picture = SignedPicture(A, t, seen);
    EXPECT_LT(picture(0, 0)[0], picture(0, 0)[2]);
    EXPECT_EQ(picture(1, 0), (Rgb{1, 1, 1}));
    EXPECT_GT(picture(2, 0)[0], picture(2, 0)[2]);
    EXPECT_EQ(picture(3, 0)[0], picture(3, 0)[2]);
}

// Expected: means of 2 x 2 by hand; the fifth column and third row fill no block.
TEST(Smaller, IsTheMeanOfWholeBlocks) {
    Image<float> image(5, 3);
    for (std::size_t p = 0; p < 15; ++p) image.Pixels()[p] = float(p);
    const Image<float> smaller = Smaller(image, 3);
    EXPECT_EQ(smaller.Width(), 2);
    EXPECT_EQ(smaller.Height(), 1);
    EXPECT_EQ(smaller.Pixels(), (std::vector<float>{3, 5}));
    EXPECT_EQ(Smaller(image, 5).Pixels(), image.Pixels());
}

// Expected: each of 2 x 1 pixels as a block of 2 x 2, the last block cut at the odd width.
TEST(Doubled, ShowsEachPixelFourTimes) {
    Image<float> half(2, 1);
    half.Pixels() = {1, 5};
    EXPECT_EQ(Doubled(half, 3, 2).Pixels(), (std::vector<float>{1, 1, 5, 1, 1, 5}));
}

// Expected: a clock that adds 1, 2, 3 ... seconds a call: medians by hand, the first run left out;
// two techniques take turns.
TEST(TimeTechniques, TakesTheMedianOfTheRoundsAfterOneThatWarmsUp) {
    const Drawn drawn(FloorAndWall(16, 9), 0);
    double now = 0, step = 0;
    const Technique technique{
        .name = "t",
        .falloff = Falloff::kHard,
        .samples = 1,
        .run = [&](const TechniqueInput& in, const Clock& clock) {
            const double begin = clock();
            return std::vector<Pass>{{"p", Image<float>(in.gbuffer.z_m), clock() - begin}};
        }};
    const TechniqueInput in = drawn.In();
    const TechniqueTurn turns[] = {{&technique, &in}, {&technique, &in}};
    const std::vector<TimedTechnique> timed = TimeTechniques(turns, 3, [&] {
        step += 1;
        return now += step;
    });
    ASSERT_EQ(timed.size(), 2u);
    ASSERT_EQ(timed[0].passes.size(), 1u);
    EXPECT_EQ(timed[0].passes[0].name, "p");
    // Runs last 2, 4 to warm up, then 6 and 8, 10 and 12, 14 and 16.
    EXPECT_EQ(timed[0].passes[0].seconds.value, 10);
    EXPECT_EQ(timed[1].seconds.value, 12);
    EXPECT_EQ(timed[1].seconds.interval.low, 8);
    EXPECT_EQ(timed[1].seconds.interval.high, 16);
    EXPECT_EQ(timed[0].A.Width(), 16);
}

}  // namespace
}  // namespace plumb
