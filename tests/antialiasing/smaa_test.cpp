// SMAA: edges and pictures worked by hand, and its laws.
#include "screen_space/antialiasing/smaa.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/smaa_edges.h"
#include "tests/antialiasing/made_pictures.h"

namespace plumb {
namespace {

SmaaOptions ByFormula() {
    SmaaOptions options;
    options.areas = SmaaAreaSource::kFormula;
    return options;
}

bool LeftEdgeAt2(std::vector<float> row, const SmaaOptions& options) {
    const Image<Rgb> picture =
        GreyPicture(int(row.size()), 1, [&](int x, int) { return row[std::size_t(x)]; });
    return FindSmaaEdges(picture, options).Left(2, 0);
}

TEST(SmaaEdges, ThresholdAndLocalContrast) {
    SmaaOptions o;
    EXPECT_TRUE(LeftEdgeAt2({0.5f, 0.5f, 0.625f, 0.625f}, o));
    EXPECT_FALSE(LeftEdgeAt2({0.5f, 0.5f, 0.5625f, 0.5625f}, o));
    o.threshold = 0.0625;  // Inclusive: exactly this step.
    EXPECT_TRUE(LeftEdgeAt2({0.5f, 0.5f, 0.5625f, 0.5625f}, o));
    o = {};
    // Beside a step of 0.8, one of 0.2 is none: 2 * 0.2 < 0.8.
    EXPECT_FALSE(LeftEdgeAt2({0, 0, 0.2f, 1}, o));
    o.local_contrast_factor = 5;
    EXPECT_TRUE(LeftEdgeAt2({0, 0, 0.2f, 1}, o));
    // The pair to the left counts too: 0.5 against 2 * 0.15.
    EXPECT_FALSE(LeftEdgeAt2({0, 0.5f, 0.65f, 0.65f}, {}));
}

TEST(SmaaEdges, ColoursFarPairIsMeasuredAsNamed) {
    SmaaOptions o;
    o.edges = SmaaEdgeKind::kColour;  // |C_left - C_leftleft| = 0.3 <= 2 * 0.2
    EXPECT_TRUE(LeftEdgeAt2({0.3f, 0.6f, 0.8f, 0.8f}, o));
    o.edges = SmaaEdgeKind::kColourAsPublished;  // |C - C_leftleft| = 0.5
    EXPECT_FALSE(LeftEdgeAt2({0.3f, 0.6f, 0.8f, 0.8f}, o));
}

TEST(SmaaEdges, ColourSeesWhatLumaDoesNot) {
    // 0.2126 r = 0.7152 g: no step of luma.
    Image<Rgb> picture(8, 8, Rgb{0.8f, 0, 0});
    for (int y = 0; y < 8; ++y) {
        for (int x = 4; x < 8; ++x) picture(x, y) = {0, 0.8f * 0.2126f / 0.7152f, 0};
    }
    SmaaOptions o;
    EXPECT_FALSE(FindSmaaEdges(picture, o).Left(4, 4));
    o.edges = SmaaEdgeKind::kColour;
    EXPECT_TRUE(FindSmaaEdges(picture, o).Left(4, 4));
    EXPECT_FALSE(FindSmaaEdges(picture, o).Left(5, 4));
    EXPECT_FALSE(FindSmaaEdges(picture, o).Top(4, 4));
}

// A bright floor under a dark sky, whose upper edge rises by one row at x = 10; beyond the picture
// it goes on.
//   (12, 5): two pixels to the left to the stair, below the line (code 3); to the right the limit,
//   32. d = 35, a line from 1/2 below at 0 to the middle: share 1/2 - 2.5/35 of its own.
//   (7, 6): two to the right to the stair, above it; to the left the limit, 31. d = 34, from the
//   middle to 1/2 above: the pixel above has the share 1/2 - 2.5/34 of it.
TEST(Smaa, StairByHand) {
    const Image<Rgb> stair =
        GreyPicture(64, 12, [](int x, int y) { return y >= (x < 10 ? 6 : 5); });
    const Image<Rgb> out = SmaaFiltered(stair, ByFormula());
    EXPECT_NEAR(out(12, 5)[0], 1 - (0.5 - 2.5 / 35), 1e-6);
    EXPECT_NEAR(out(7, 5)[0], 0.5 - 2.5 / 34, 1e-6);
    EXPECT_EQ(out(12, 4)[0], 0);
    EXPECT_EQ(out(7, 6)[0], 1);
    // Bytes and square roots: within what the table's test allows.
    EXPECT_NEAR(SmaaFiltered(stair)(12, 5)[0], 1 - (0.5 - 2.5 / 35), 0.02);
}

// The corner of a bright quadrant: (12, 10) is two pixels from it. Without rounding its share is
// that of the stair; the crossing edge goes on in the row below, so rounding keeps a quarter.
TEST(Smaa, CornersAreKeptAsFarAsTold) {
    const Image<Rgb> quadrant =
        GreyPicture(60, 60, [](int x, int y) { return x >= 10 && y >= 10; });
    SmaaOptions options = ByFormula();
    EXPECT_NEAR(SmaaFiltered(quadrant, options)(12, 10)[0], 1 - (0.5 - 2.5 / 35) / 4, 1e-6);
    options.corner_rounding = 100;
    EXPECT_NEAR(SmaaFiltered(quadrant, options)(12, 10)[0], 1 - (0.5 - 2.5 / 35), 1e-6);
    // A square of 5 pixels: its middle is as far from both corners, each takes half of 3/4. U
    // shape, d = 5: the middle pixel is [2, 3] of 5, the halves meet in it at 2.5: each a triangle
    // (slope 0.2, base 1/2) of 0.025, smoothed by 1 - 5/32 towards sqrt(0.05)/2.
    const Image<Rgb> square = GreyPicture(
        60, 60, [](int x, int y) { return x >= 10 && x < 15 && y >= 10 && y < 15; });
    const double b = std::sqrt(0.05) / 2, half = b + (0.025 - b) * 5 / 32;
    EXPECT_NEAR(SmaaFiltered(square, options)(12, 10)[0], 1 - 2 * half, 1e-6);
    options.corner_rounding = 25;
    EXPECT_NEAR(SmaaFiltered(square, options)(12, 10)[0], 1 - 2 * half * 0.25, 1e-6);
}

// A bar of one pixel: its rows above and below blend into it from both sides.
//   Bar row 6, x < 10 moved down to row 7 for x >= 10. Pixel (12, 7): its top edge's run begins at
//   the stair (2 px): the left edge at (10, 7) is on its own side, that at (10, 6) above: code 4.
//   Its lower edge, the top edges of row 8, likewise ends at x = 10: crossing at (10, 7) above
//   and none below: code 1.
//   Top: pattern 1 + 4 = 5: no line. Bottom: pattern 4, second share 1/2 - 2.5/35. Rounding keeps a
//   quarter of it: the crossing edge at (10, 6) goes on two rows above row 8.
TEST(Smaa, BlendsFromBothSides) {
    const Image<Rgb> bar =
        GreyPicture(64, 14, [](int x, int y) { return y == (x < 10 ? 6 : 7); });
    SmaaOptions options = ByFormula();
    EXPECT_NEAR(SmaaFiltered(bar, options)(12, 7)[0], 1 - (0.5 - 2.5 / 35) / 4, 1e-6);
    options.corner_rounding = 100;
    EXPECT_NEAR(SmaaFiltered(bar, options)(12, 7)[0], 1 - (0.5 - 2.5 / 35), 1e-6);
}

TEST(Smaa, ConstantAndStraightEdgesStayToTheBit) {
    for (const SmaaPreset& preset : SmaaPresets()) {
        const Image<Rgb> flat(17, 9, Rgb{0.3f, 0.1f, 0.7f});
        EXPECT_EQ(SmaaFiltered(flat, preset.options), flat) << preset.name;
        SmaaOptions everywhere = preset.options;
        everywhere.threshold = 0;
        EXPECT_EQ(SmaaFiltered(flat, everywhere), flat) << preset.name;
        const Image<Rgb> half = GreyPicture(40, 30, [](int x, int) { return x >= 17; });
        EXPECT_EQ(SmaaFiltered(half, preset.options), half) << preset.name;
        EXPECT_EQ(SmaaFiltered(Transposed(half), preset.options), Transposed(half));
    }
}

// Edges of the encoded picture, colours of the linear one.
TEST(Smaa, BlendsAnotherPictureByItsEdges) {
    const auto floor = [](int x, int y) { return y >= (x < 10 ? 6 : 5); };
    const Image<Rgb> stair = GreyPicture(64, 12, floor);
    const Image<Rgb> dim =
        GreyPicture(64, 12, [&](int x, int y) { return floor(x, y) ? 0.03 : 0.01; });
    EXPECT_EQ(SmaaFiltered(dim), dim);
    const Image<Rgb> out = SmaaFiltered(stair, dim, ByFormula());
    EXPECT_NEAR(out(12, 5)[0], 0.03 - 0.02 * (0.5 - 2.5 / 35), 1e-8);
    EXPECT_THROW(SmaaFiltered(stair, Image<Rgb>(64, 11), {}), Error);
}

TEST(Smaa, IsTheSameOnAnyNumberOfThreads) {
    const Image<Rgb> picture = BlobPicture(97, 61, 3);
    SetThreadCount(1);
    const Image<Rgb> one = SmaaFiltered(picture, SmaaPresetNamed("ultra"));
    SetThreadCount(4);
    EXPECT_EQ(SmaaFiltered(picture, SmaaPresetNamed("ultra")), one);
    SetThreadCount(0);
    EXPECT_NE(one, picture);
}

TEST(Smaa, TakesPicturesOfAnySize) {
    EXPECT_TRUE(SmaaFiltered(Image<Rgb>()).Empty());
    const Image<Rgb> one(1, 1, Rgb{1, 0, 0.5f});
    EXPECT_EQ(SmaaFiltered(one), one);
    EXPECT_EQ(SmaaFiltered(NoisePicture(2, 1, 1)).Width(), 2);
    EXPECT_EQ(SmaaFiltered(NoisePicture(1, 7, 1)).Height(), 7);
}

TEST(SmaaPresets, AreThePublishedOnes) {
    EXPECT_EQ(SmaaPresets().size(), 4u);
    EXPECT_EQ(SmaaPresetNamed("high"), SmaaOptions{});
    const SmaaOptions low = SmaaPresetNamed("low"), ultra = SmaaPresetNamed("ultra");
    EXPECT_EQ(low.threshold, 0.15);
    EXPECT_EQ(low.search_steps, 4);
    EXPECT_EQ(low.diagonal_steps, 0);
    EXPECT_EQ(low.corner_rounding, 100);
    EXPECT_EQ(SmaaPresetNamed("medium").search_steps, 8);
    EXPECT_EQ(ultra.threshold, 0.05);
    EXPECT_EQ(ultra.search_steps, 32);
    EXPECT_EQ(ultra.diagonal_steps, 16);
    EXPECT_EQ(ultra.corner_rounding, 25);
    EXPECT_THROW(SmaaPresetNamed("extreme"), Error);
}

std::string Complaint(const SmaaOptions& options) {
    try {
        Validate(options);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(SmaaOptions, AreChecked) {
    EXPECT_EQ(Complaint({}), "");
    EXPECT_EQ(Complaint({.threshold = std::nan("")}),
              "SmaaOptions::threshold = nan, must be in [0, 0.5]");
    EXPECT_EQ(Complaint({.search_steps = 113}),
              "SmaaOptions::search_steps = 113, must be in [0, 112]");
    EXPECT_EQ(Complaint({.diagonal_steps = 20}),
              "SmaaOptions::diagonal_steps = 20, must be in [0, 19]");
    EXPECT_EQ(Complaint({.corner_rounding = -1}),
              "SmaaOptions::corner_rounding = -1, must be in [0, 100]");
    EXPECT_EQ(Complaint({.local_contrast_factor = -1}),
              "SmaaOptions::local_contrast_factor = -1, must be finite and not negative");
}

}  // namespace
}  // namespace plumb
