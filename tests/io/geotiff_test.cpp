#include "io/geotiff.h"

#include "core/error.h"
#include "tests/io/temp_folder.h"
#include "tests/io/write_geotiff.h"

namespace plumb {
namespace {

// Rows of the key directory ([GeoTIFF]): key, 0 for "value in place", count 1, value.
const std::vector<std::uint16_t> kProjected{1024, 0, 1, 1}, kGeographic{1024, 0, 1, 2},
    kProjectedInUsFeet{1024, 0, 1, 1, 3076, 0, 1, 9003},
    kProjectedInFathoms{1024, 0, 1, 1, 3076, 0, 1, 9014};

class GeoTiff : public TempFolder {
  protected:
    GeoTags TagsOf(const GeoTiffOptions& options) const {
        WriteGeoTiff(Path("a.tif"), 2, {1, 2, 3, 4}, options);
        return ReadGeoTags(Path("a.tif"));
    }
};

TEST_F(GeoTiff, SpacingIsThePixelScale) {
    const GeoTags tags = TagsOf({.pixel_scale = {74, 93, 0}, .geo_keys = kProjected});
    EXPECT_EQ(tags.spacing_m, Vec2(74, 93));
    EXPECT_EQ(tags.no_spacing_because, "");
    EXPECT_EQ(tags.no_data, std::nullopt);
}

// By definition 1 US survey foot = 1200/3937 m.
TEST_F(GeoTiff, FeetBecomeMetres) {
    const GeoTags tags = TagsOf({.pixel_scale = {10, 10, 0}, .geo_keys = kProjectedInUsFeet});
    ASSERT_TRUE(tags.spacing_m);
    EXPECT_DOUBLE_EQ(tags.spacing_m->x(), 12000. / 3937);
}

// A grid turned by 30 degrees with steps of 2 m along a row and 3 m along a column.
TEST_F(GeoTiff, SpacingOfATurnedGridIsTheLengthOfItsSteps) {
    const double c = std::sqrt(0.75), s = 0.5;
    const GeoTags tags = TagsOf({.transformation = {2 * c, 3 * s, 0, 500000,    //
                                                    2 * s, -3 * c, 0, 4000000,  //
                                                    0, 0, 0, 0, 0, 0, 0, 1},
                                 .geo_keys = kProjected});
    ASSERT_TRUE(tags.spacing_m);
    EXPECT_NEAR(tags.spacing_m->x(), 2, 1e-15);
    EXPECT_NEAR(tags.spacing_m->y(), 3, 1e-15);
}

TEST_F(GeoTiff, DegreesAreNoSpacing) {
    const GeoTags tags =
        TagsOf({.pixel_scale = {0.000833, 0.000833, 0}, .geo_keys = kGeographic});
    EXPECT_FALSE(tags.spacing_m);
    EXPECT_EQ(tags.no_spacing_because, "its texels are measured in degrees");
}

TEST_F(GeoTiff, UnknownUnitsAndScalesAreNoSpacing) {
    EXPECT_EQ(
        TagsOf({.pixel_scale = {1, 1, 0}, .geo_keys = kProjectedInFathoms}).no_spacing_because,
        "its unit of length is neither metre nor foot");
    EXPECT_EQ(TagsOf({.pixel_scale = {0, 1, 0}}).no_spacing_because,
              "its pixel scale is not > 0");
}

TEST_F(GeoTiff, NoDataIsANumber) {
    EXPECT_EQ(TagsOf({.no_data = "-32768"}).no_data, -32768);
    EXPECT_EQ(TagsOf({.no_data = "none"}).no_data, std::nullopt);
}

TEST_F(GeoTiff, APlainTiffSaysNothing) {
    const GeoTags tags = TagsOf({});
    EXPECT_FALSE(tags.spacing_m);
    EXPECT_EQ(tags.no_spacing_because, "");
}

TEST_F(GeoTiff, WhatIsNoTiffIsAnError) {
    EXPECT_EQ(
        MessageOf<Error>([&] { ReadGeoTags(Put("a.tif", "II*")); }),
        Path("a.tif").string() + ": cannot be read, its TIFF directory is missing or damaged");
}

}  // namespace
}  // namespace plumb
