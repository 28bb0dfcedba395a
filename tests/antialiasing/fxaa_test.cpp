// FXAA against pictures worked by hand, and its laws.
#include "screen_space/antialiasing/fxaa.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "tests/antialiasing/made_pictures.h"

namespace plumb {
namespace {

using testing::ElementsAre;

FxaaOptions WithSteps(const char* preset, double subpix) {
    FxaaOptions options = FxaaPresetNamed(preset);
    options.subpix = subpix;
    return options;
}

// A bright floor under a dark sky, whose upper edge rises by one row at x = 10.
//   pixel (12, 5): M = 1, N = 0, the line lies between rows 4 and 5, luma 1/2, stop 1/4.
//   To the left luma is 1/2 at 11 (1 px), and halfway between 1/2 and 0 at 9.5 (2.5 px): an end.
//   To the right there is none before the last step: 1 + 1.5 + 2 + 4 + 12 = 20.5 px.
//   The end is darker than the edge, M brighter: offset = 1/2 - 2.5 / 23.
//   B = 8/12 - 1, so C = 1/3, F = (1/9)(3 - 2/3) = 7/27, H = 0.75 (7/27)^2 = 0.0504: less.
TEST(Fxaa, StairByHand) {
    const Image<Rgb> stair =
        GreyPicture(64, 12, [](int x, int y) { return y >= (x < 10 ? 6 : 5); });
    const Image<Rgb> out = FxaaFiltered(stair);
    EXPECT_NEAR(out(12, 5)[0], 1 - (0.5 - 2.5 / 23), 1e-6);
    // Preset 10: 1.5 px reads between 10 and 11, luma 1/2; 4.5 px finds the end.
    // 1.5 + 3 + 12 = 16.5 px to the right.
    EXPECT_NEAR(FxaaFiltered(stair, FxaaPresetNamed("10"))(12, 5)[0], 1 - (0.5 - 4.5 / 21),
                1e-6);
    // On the other side of the stair, pixel (12, 4): dark, the near end is dark too: no offset.
    // B = (2 (1) + 2) / 12 = 1/3 with W = E = 0: the same H.
    EXPECT_NEAR(out(12, 4)[0], 0.75 * 49 / 729, 1e-6);
    // Pixel (7, 5) left of the stair: dark above a bright row; near end 2.5 px to the right, where
    // luma is brighter than the edge's own 1/2 by 1/4 and M is darker; 7 - 20.5 to the left.
    EXPECT_NEAR(out(7, 5)[0], 0.5 - 2.5 / 23, 1e-6);
}

// The centre: both ends at 1 px, so the edge term is 1/2 - 1/2 = 0; B = -1, F = 1, H = s.
// The pixel above: its ends are dark as it is, so 0; B = 1/6, F = (1/36)(3 - 1/3) = 2/27.
TEST(Fxaa, LonePixelIsLeftToTheSubPixelTerm) {
    const Image<Rgb> dot = GreyPicture(9, 9, [](int x, int y) { return x == 4 && y == 4; });
    const Image<Rgb> out = FxaaFiltered(dot);
    EXPECT_NEAR(out(4, 4)[1], 0.25, 1e-6);
    EXPECT_NEAR(out(4, 3)[1], 0.75 * 4 / 729, 1e-7);
    EXPECT_EQ(FxaaFiltered(dot, WithSteps("12", 0)), dot);
    // Of equal steps up and down the upper one is taken: red, of which green luma knows nothing.
    Image<Rgb> red_above = dot;
    red_above(4, 3) = {1, 0, 0};
    red_above(4, 4) = {0, 1, 0};
    FxaaOptions green;
    green.luma = FxaaLuma::kGreen;
    EXPECT_NEAR(FxaaFiltered(red_above, green)(4, 4)[0], 0.75, 1e-6);
}

TEST(Fxaa, ThresholdsKeepWhatIsBelow) {
    // A step from 0.5 to 0.5 + d has the range d; max(0.0833, 0.166 max) decides.
    const auto step = [](double d) {
        return GreyPicture(8, 8,
                           [d](int x, int y) { return y < (x < 4 ? 4 : 3) ? 0.5 : 0.5 + d; });
    };
    EXPECT_EQ(FxaaFiltered(step(0.0990)), step(0.0990));  // 0.166 * 0.599 = 0.0994
    EXPECT_NE(FxaaFiltered(step(0.1)), step(0.1));        // 0.166 * 0.6 = 0.0996
    FxaaOptions floor;
    floor.edge_threshold = 0;
    floor.edge_threshold_min = 0.11;
    EXPECT_EQ(FxaaFiltered(step(0.1), floor), step(0.1));
    floor.edge_threshold_min = 0.09;
    EXPECT_NE(FxaaFiltered(step(0.1), floor), step(0.1));
}

TEST(Fxaa, ConstantStaysToTheBitWithEveryPreset) {
    for (FxaaPreset preset : FxaaPresets()) {
        preset.options.edge_threshold = preset.options.edge_threshold_min = 0;
        for (const float value : {0.f, 0.3f, 1.f}) {
            const Image<Rgb> flat(17, 5, Rgb{value, value / 3, value / 7});
            EXPECT_EQ(FxaaFiltered(flat, preset.options), flat) << preset.name;
        }
    }
}

// An offset never exceeds 3/4 of a pixel here, so a channel lies between the pixel's own and that
// of one of its four neighbours.
TEST(Fxaa, EveryChannelLiesBetweenThePixelAndANeighbour) {
    const Image<Rgb> noise = NoisePicture(40, 30, 1), out = FxaaFiltered(noise);
    int moved = 0;
    for (int y = 1; y < 29; ++y) {
        for (int x = 1; x < 39; ++x) {
            bool between = false;
            for (const auto& n :
                 {noise(x - 1, y), noise(x + 1, y), noise(x, y - 1), noise(x, y + 1)}) {
                bool all = true;
                for (std::size_t c = 0; c < 3; ++c) {
                    const float a = noise(x, y)[c], v = out(x, y)[c];
                    all = all && std::min(a, n[c]) <= v && v <= std::max(a, n[c]);
                }
                between = between || all;
            }
            EXPECT_TRUE(between) << x << " " << y;
            moved += out(x, y) != noise(x, y);
        }
    }
    EXPECT_GT(moved, 500);
}

// Rows and columns are treated alike where their second differences differ. (Where those of the
// outer rows have the sign opposite to the middle one's, the two sums are the same eight numbers:
// a tie, which is horizontal.) Sums are then added in another order: a few roundings of numbers up
// to 8.
TEST(Fxaa, TransposesWithThePictureButForTies) {
    const int W = 33, H = 21;
    const Image<Rgb> noise = NoisePicture(W, H, 2);
    const auto tie = [&](int x, int y) {
        const auto l = [&](int i, int j) {
            const Rgb& c = noise(std::clamp(x + i, 0, W - 1), std::clamp(y + j, 0, H - 1));
            return 0.299 * c[0] + 0.587 * c[1] + 0.114 * c[2];
        };
        double rows = 0, columns = 0;
        for (int k = -1; k <= 1; ++k) {
            const int weight = k == 0 ? 2 : 1;
            rows += weight * std::abs(l(k, -1) - 2 * l(k, 0) + l(k, 1));
            columns += weight * std::abs(l(-1, k) - 2 * l(0, k) + l(1, k));
        }
        return std::abs(rows - columns) < 1e-5;
    };
    const Image<Rgb> a = FxaaFiltered(noise), b = Transposed(FxaaFiltered(Transposed(noise)));
    int ties = 0;
    for (int y = 0; y < H; ++y) {
        for (int x = 0; x < W; ++x) {
            if (tie(x, y)) {
                ++ties;
                continue;
            }
            for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a(x, y)[c], b(x, y)[c], 1e-5);
        }
    }
    EXPECT_LT(ties, W * H / 5);
}

TEST(Fxaa, ReadsTheLumaThatItIsTold) {
    // A red stair: green sees nothing.
    Image<Rgb> red(32, 12);
    for (int y = 0; y < 12; ++y) {
        for (int x = 0; x < 32; ++x) red(x, y) = {y >= (x < 10 ? 6 : 5) ? 1.f : 0.f, 0.5f, 0};
    }
    FxaaOptions options;
    options.edge_threshold_min = 0;
    options.luma = FxaaLuma::kGreen;
    EXPECT_EQ(FxaaFiltered(red, options), red);
    options.luma = FxaaLuma::kRec601;
    EXPECT_NE(FxaaFiltered(red, options), red);
    // 0.01 of linear light on black is 0.1 to the eye: above 0.0833, while its sum is not.
    const Image<Rgb> dim =
        GreyPicture(32, 12, [](int x, int y) { return y >= (x < 10 ? 6 : 5) ? 0.01 : 0; });
    EXPECT_EQ(FxaaFiltered(dim), dim);
    options = {};
    options.luma = FxaaLuma::kRootOfLinear;
    EXPECT_NEAR(FxaaFiltered(dim, options)(12, 5)[0], 0.01 * (1 - (0.5 - 2.5 / 23)), 1e-7);
}

TEST(Fxaa, IsTheSameOnAnyNumberOfThreads) {
    const Image<Rgb> picture = BlobPicture(97, 61, 3);
    SetThreadCount(1);
    const Image<Rgb> one = FxaaFiltered(picture, FxaaPresetNamed("39"));
    SetThreadCount(4);
    EXPECT_EQ(FxaaFiltered(picture, FxaaPresetNamed("39")), one);
    SetThreadCount(0);
    EXPECT_NE(one, picture);
}

TEST(Fxaa, TakesPicturesOfAnySize) {
    EXPECT_TRUE(FxaaFiltered(Image<Rgb>()).Empty());
    const Image<Rgb> one(1, 1, Rgb{1, 0, 0.5f});
    EXPECT_EQ(FxaaFiltered(one), one);
    const Image<Rgb> row = GreyPicture(5, 1, [](int x, int) { return x == 2; });
    EXPECT_EQ(FxaaFiltered(row, WithSteps("39", 0)).Width(), 5);
}

TEST(FxaaPresets, AreThePublishedOnes) {
    EXPECT_EQ(FxaaPresets().size(), 17u);
    EXPECT_EQ(FxaaPresetNamed("12"), FxaaOptions{});
    EXPECT_THAT(FxaaPresetNamed("15").steps_px, ElementsAre(1, 1.5, 2, 2, 2, 2, 4, 12));
    EXPECT_THAT(FxaaPresetNamed("20").steps_px, ElementsAre(1.5, 2, 8));
    EXPECT_THAT(FxaaPresetNamed("24").steps_px, ElementsAre(1, 1.5, 2, 2, 2, 3, 8));
    EXPECT_THAT(FxaaPresetNamed("25").steps_px, ElementsAre(1, 1.5, 2, 2, 2, 2, 4, 8));
    EXPECT_THAT(FxaaPresetNamed("29").steps_px,
                ElementsAre(1, 1.5, 2, 2, 2, 2, 2, 2, 2, 2, 4, 8));
    EXPECT_THAT(FxaaPresetNamed("39").steps_px,
                ElementsAre(1, 1, 1, 1, 1, 1.5, 2, 2, 2, 2, 4, 8));
    EXPECT_THROW(FxaaPresetNamed("16"), Error);
}

std::string Complaint(const FxaaOptions& options) {
    try {
        Validate(options);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(FxaaOptions, AreChecked) {
    EXPECT_EQ(Complaint({}), "");
    EXPECT_EQ(Complaint({.subpix = 1.5, .steps_px = {1, 1}}),
              "FxaaOptions::subpix = 1.5, must be in [0, 1]");
    EXPECT_EQ(Complaint({.edge_threshold = std::nan(""), .steps_px = {1, 1}}),
              "FxaaOptions::edge_threshold = nan, must be finite and not negative");
    EXPECT_EQ(Complaint({.edge_threshold_min = std::numeric_limits<double>::infinity()}),
              "FxaaOptions::edge_threshold_min = inf, must be finite and not negative");
    EXPECT_EQ(Complaint({.steps_px = {1}}),
              "FxaaOptions::steps_px.size() = 1, must be at least 2");
    EXPECT_EQ(Complaint({.steps_px = {1, 0, 2}}),
              "FxaaOptions::steps_px = 0, must be in (0, 1024]");
}

}  // namespace
}  // namespace plumb
