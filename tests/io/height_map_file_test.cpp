#include "io/height_map_file.h"

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "io/content_hash.h"
#include "tests/io/temp_folder.h"
#include "tests/io/write_geotiff.h"
#include "tests/io/write_images.h"
#include "tests/io/write_png.h"

namespace plumb {
namespace {

class HeightMap : public TempFolder {
  protected:
    /// 4 x 1 texels of 16 bits: the values 0, 0.2, 0.4 and 1.
    HeightMap() {
        WriteStored<std::uint16_t>(Path("wall.png"), 4, 1, {"Y"}, {0, 13107, 26214, 65535});
    }
    HeightMapFile Read(const std::string& side_file,
                       const HeightMapOverrides& overrides = {}) const {
        Put("wall.json", side_file);
        return ReadHeightMap(Path("wall.png"), overrides);
    }
};

void ExpectHeights(const HeightMapFile& map, const std::vector<double>& expected_m) {
    ASSERT_EQ(map.heights_m.Pixels().size(), expected_m.size());
    for (std::size_t k = 0; k < expected_m.size(); ++k) {
        // Tolerance: a division, a product and a sum, each rounded.
        EXPECT_NEAR(map.heights_m.Pixels()[k], expected_m[k],
                    1e-15 * (1 + std::abs(expected_m[k])));
    }
}

// The defaults of the manual: 1 m wide, a tenth of that high, repeating.
TEST_F(HeightMap, ABareIntegerImageIsOneMetreWideAndATenthHigh) {
    const HeightMapFile map = ReadHeightMap(Path("wall.png"));
    EXPECT_EQ(map.name, "wall");
    EXPECT_EQ(map.spacing_x_m, 0.25);
    EXPECT_EQ(map.spacing_y_m, 0.25);
    ExpectHeights(map, {0, 0.02, 0.04, 0.1});
    EXPECT_EQ(map.boundary, "wrap");
    EXPECT_EQ(map.bits, 16);
    EXPECT_DOUBLE_EQ(map.step_m, 0.1 / 65535);
    EXPECT_EQ(map.sha256, Sha256Hex(Get("wall.png")));
    EXPECT_EQ(map.source + map.licence, "");
}

TEST_F(HeightMap, ABareFloatImageHoldsMetres) {
    WriteStored<float>(Path("dem.exr"), 2, 1, {"Y"}, {-3.5f, 1000});
    const HeightMapFile map = ReadHeightMap(Path("dem.exr"));
    ExpectHeights(map, {-3.5, 1000});
    EXPECT_EQ(map.spacing_x_m, 0.5);
    EXPECT_EQ(map.step_m, 0);
}

TEST_F(HeightMap, TheSideFileSaysHowValuesBecomeMetres) {
    ExpectHeights(Read(R"({"amplitude_m": 2})"), {0, 0.4, 0.8, 2});
    ExpectHeights(Read(R"({"amplitude_m": 2, "low_m": 10})"), {10, 10.4, 10.8, 12});
    ExpectHeights(Read(R"({"amplitude_m": 0})"), {0, 0, 0, 0});
    // The width is 4 texels of 0.5 m.
    ExpectHeights(Read(R"({"amplitude_of_width": 0.25, "spacing_m": 0.5})"),
                  {0, 0.1, 0.2, 0.5});
    ExpectHeights(Read(R"({"metres_per_unit": 0.1, "low_m": 236})"),
                  {236, 1546.7, 2857.4, 6789.5});
    ExpectHeights(Read(R"({"low_m": -1, "high_m": 4})"), {-1, 0, 1, 4});
    EXPECT_DOUBLE_EQ(Read(R"({"metres_per_unit": 0.1})").step_m, 0.1);
}

// Steps of 0.1 m are steps of 0.1 m in any number of bits: 1 in one bit and 1 in 16 are the same
// height, and a map as high as its bits allow is (2^bits - 1) steps high.
TEST_F(HeightMap, MetresPerUnitDoNotDependOnTheBits) {
    Put("few.json", R"({"metres_per_unit": 0.1, "low_m": 3})");
    for (const int bits : {1, 2, 4, 8}) {
        const int greatest = (1 << bits) - 1;
        Put("few.png", GreyPngRow(bits, {0, 1, greatest}));
        const HeightMapFile map = ReadHeightMap(Path("few.png"));
        ExpectHeights(map, {3, 3.1, 3 + 0.1 * greatest});
        EXPECT_DOUBLE_EQ(map.step_m, 0.1);
        EXPECT_EQ(map.bits, bits);
    }
    WriteStored<std::uint16_t>(Path("few.png"), 3, 1, {"Y"}, {0, 1, 65535});
    ExpectHeights(ReadHeightMap(Path("few.png")), {3, 3.1, 6556.5});
    // An amplitude is between the values 0 and 1, whatever the bits.
    for (const int bits : {1, 2, 4, 8}) {
        Put("few.json", R"({"amplitude_m": 2})");
        Put("few.png", GreyPngRow(bits, {0, (1 << bits) - 1}));
        ExpectHeights(ReadHeightMap(Path("few.png")), {0, 2});
    }
}

TEST_F(HeightMap, TheSideFileSaysTheRest) {
    const HeightMapFile map = Read(R"({"name": "Wall", "spacing_m": [1, 2], "boundary": "open",
                                       "source": "us", "licence": "free"})");
    EXPECT_EQ(map.name, "Wall");
    EXPECT_EQ(map.spacing_x_m, 1);
    EXPECT_EQ(map.spacing_y_m, 2);
    EXPECT_EQ(map.boundary, "open");
    EXPECT_EQ(map.source, "us");
    EXPECT_EQ(map.licence, "free");
}

TEST_F(HeightMap, TheCommandLineComesFirst) {
    const std::string side = R"({"spacing_m": 3, "metres_per_unit": 7, "low_m": 5,
                                 "boundary": "open"})";
    const HeightMapFile map =
        Read(side, {.spacing_m = Vec2(0.5, 0.5), .amplitude_m = 1, .boundary = "mirror"});
    EXPECT_EQ(map.spacing_x_m, 0.5);
    EXPECT_EQ(map.boundary, "mirror");
    ExpectHeights(map, {5, 5.2, 5.4, 6});
    ExpectHeights(Read(side, {.spacing_m = Vec2(0.5, 0.5), .amplitude_of_width = 0.25}),
                  {5, 5.1, 5.2, 5.5});
}

TEST_F(HeightMap, AnAmplitudeMultipliesFloats) {
    WriteStored<float>(Path("displacement.exr"), 2, 1, {"Y"}, {-0.5f, 1});
    ExpectHeights(ReadHeightMap(Path("displacement.exr"), {.amplitude_m = 4}), {-2, 4});
}

TEST_F(HeightMap, BadOverridesAreNamed) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto message = [&](const HeightMapOverrides& overrides) {
        return MessageOf<Error>([&] { ReadHeightMap(Path("wall.png"), overrides); });
    };
    EXPECT_EQ(message({.spacing_m = Vec2(1, 0)}), "--spacing-m = 0, must be > 0");
    EXPECT_EQ(message({.amplitude_m = -1}), "--amplitude-m = -1, must be >= 0");
    EXPECT_EQ(message({.amplitude_m = nan}), "--amplitude-m = nan, must be >= 0");
    EXPECT_EQ(message({.amplitude_of_width = -0.1}),
              "--amplitude-of-width = -0.1, must be >= 0");
    EXPECT_EQ(message({.amplitude_m = 1, .amplitude_of_width = 1}),
              "--amplitude-m and --amplitude-of-width: at most one must be given");
    EXPECT_EQ(message({.boundary = "clamp"}),
              "--boundary = clamp, must be one of wrap, mirror, open");
}

TEST_F(HeightMap, AGeoTiffIsAnOpenSurveyInMetres) {
    WriteGeoTiff(Path("dem.tif"), 2, {236, 1076, 500, 600}, {.pixel_scale = {74, 93, 0}});
    Put("dem.json", R"({"metres_per_unit": 1})");
    const HeightMapFile map = ReadHeightMap(Path("dem.tif"));
    EXPECT_EQ(map.spacing_x_m, 74);
    EXPECT_EQ(map.spacing_y_m, 93);
    EXPECT_EQ(map.boundary, "open");
    // Tolerance of ExpectHeights: stored / 32767 * 32767 rounds twice.
    ExpectHeights(map, {236, 1076, 500, 600});
}

TEST_F(HeightMap, AGeoTiffInDegreesNeedsASpacing) {
    WriteGeoTiff(Path("dem.tif"), 2, {1, 2, 3, 4},
                 {.pixel_scale = {0.001, 0.001, 0}, .geo_keys = {1024, 0, 1, 2}});
    EXPECT_EQ(MessageOf<Error>([&] { ReadHeightMap(Path("dem.tif")); }),
              Path("dem.tif").string() +
                  ": has no spacing in metres, its texels are measured in degrees; spacing_m "
                  "must be given in the side file or by --spacing-m");
    EXPECT_EQ(ReadHeightMap(Path("dem.tif"), {.spacing_m = Vec2(90, 90)}).spacing_y_m, 90);
}

// The maps of the repository. Expected: data/heightmaps/README.md, which gives texels and the
// range of heights.
TEST(HeightMapData, MapsOfTheRepositoryAreAsTheirReadmeSays) {
    struct Expected {
        const char* file;
        int width, height;
        double low_m, high_m;
        const char* boundary;
    };
    for (const Expected& e : {Expected{"jacksboro", 403, 344, 236, 1076, "mirror"},
                              Expected{"finland", 400, 400, 180, 530.6, "mirror"},
                              Expected{"stone_wall", 256, 256, 0, 0.1, "wrap"},
                              Expected{"bricks", 256, 256, 0, 0.1, "wrap"},
                              Expected{"cobbles", 256, 256, 0, 0.1, "wrap"}}) {
        const HeightMapFile map =
            ReadHeightMap(std::filesystem::path(PLUMB_SOURCE_DIR) / "data/heightmaps" /
                          (std::string(e.file) + ".png"));
        EXPECT_EQ(map.heights_m.Width(), e.width) << e.file;
        EXPECT_EQ(map.heights_m.Height(), e.height) << e.file;
        EXPECT_EQ(map.boundary, e.boundary) << e.file;
        const auto [low, high] =
            std::minmax_element(map.heights_m.Pixels().begin(), map.heights_m.Pixels().end());
        // Tolerance: 530.6 is printed to a tenth; the others are exact to rounding.
        EXPECT_NEAR(*low, e.low_m, 1e-12) << e.file;
        EXPECT_NEAR(*high, e.high_m, e.high_m == 530.6 ? 0.05 : 1e-9) << e.file;
        EXPECT_FALSE(map.source.empty() || map.licence.empty()) << e.file;
    }
}

}  // namespace
}  // namespace plumb
