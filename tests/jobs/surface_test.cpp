#include "jobs/light/surface.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"

namespace plumb {
namespace {

using testing::HasSubstr;

std::string MessageOf(const std::string& name, const SurfaceOptions& options = {}) {
    try {
        LoadSurface(name, options);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(LoadSurface, MakesAKindOfTheSizeAndSeedThatTheNameSays) {
    const Surface wall = LoadSurface("make:stone_wall:32:7");
    EXPECT_EQ(wall.field.Width(), 32);
    EXPECT_EQ(wall.field.Height(), 32);
    EXPECT_EQ(wall.source.boundary, "wrap");
    EXPECT_EQ(wall.source.source, "make:stone_wall:32:7");
    EXPECT_NE(wall.source.sha256, LoadSurface("make:stone_wall:32:8").source.sha256);
    EXPECT_EQ(wall.source.sha256, LoadSurface("make:stone_wall:32:7").source.sha256);
}

TEST(LoadSurface, RefusesANameThatItCannotRead) {
    EXPECT_THAT(MessageOf("make:stone_wal"), HasSubstr("stone_wall"));
    EXPECT_EQ(MessageOf("make:bricks:many"),
              "make:bricks:many: SIZE in texels = many, must be a whole number");
    EXPECT_EQ(MessageOf("make:bricks:32:1:2"),
              "make:bricks:32:1:2: must be make:KIND[:SIZE[:SEED]]");
    EXPECT_THAT(MessageOf("make:bricks:1"), HasSubstr("must be in [2, 16384]"));
    EXPECT_THAT(MessageOf("nowhere/missing.png"), HasSubstr("missing.png"));
}

// Expected: what the command line says replaces what the generator advises. 0.25 of a width of
// 32 x 0.5 m is 4 m; the samples reach lowest and highest exactly (procedural/tile.h).
TEST(LoadSurface, OptionsComeBeforeTheGeneratorsAdvice) {
    SurfaceOptions options;
    options.spacing_m = 0.5;
    options.amplitude_of_width = 0.25;
    options.boundary = Boundary::kOpen;
    const Surface wall = LoadSurface("make:stone_wall:32", options);
    EXPECT_DOUBLE_EQ(wall.field.SpacingXM(), 0.5);
    EXPECT_NEAR(wall.source.amplitude_m, 4, 1e-12);
    EXPECT_EQ(wall.source.boundary, "open");
}

// Expected: visibility has no unit. At 1e-20 m a texel the relief was once rounded away.
TEST(LoadSurface, MakesTheSameShapeAtAnySize) {
    SurfaceOptions options;
    const HeightField big = LoadSurface("make:bricks:16", options).field;
    options.spacing_m = 1e-20;
    const HeightField small = LoadSurface("make:bricks:16", options).field;
    const double big_m = big.HighestM() - big.LowestM(),
                 small_m = small.HighestM() - small.LowestM();
    EXPECT_NEAR(small_m / small.SpacingXM(), big_m / big.SpacingXM(), 1e-12);
    EXPECT_NEAR((small.At(3, 5) - small.LowestM()) / small_m,
                (big.At(3, 5) - big.LowestM()) / big_m, 1e-12);
}

TEST(LoadSurface, RefusesANegativeAmplitude) {
    SurfaceOptions options;
    options.amplitude_m = -1;
    EXPECT_THAT(MessageOf("make:bricks:32", options), HasSubstr("-1, must be finite and > 0"));
}

TEST(MiddleOf, KeepsTheTexelsAroundTheMiddle) {
    Image<double> heights(6, 4);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 6; ++i) heights(i, j) = 10 * i + j;
    }
    const HeightField middle = MiddleOf(HeightField(heights, 1, 2), 2);
    EXPECT_EQ(middle.Width(), 2);
    EXPECT_EQ(middle.Height(), 2);
    EXPECT_EQ(middle.At(0, 0), 21);  // Columns 2 and 3, rows 1 and 2.
    EXPECT_EQ(middle.At(1, 1), 32);
    EXPECT_EQ(middle.SpacingYM(), 2);
    EXPECT_EQ(middle.GetBoundary(), Boundary::kMirror);
}

TEST(BoundaryNamed, IsTheWayBackOfNameOf) {
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        EXPECT_EQ(BoundaryNamed(NameOf(boundary)), boundary);
    }
    EXPECT_THROW(BoundaryNamed("clamp"), Error);
}

}  // namespace
}  // namespace plumb
