// What light.exr holds, pixel by pixel (docs/light.md).
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <string>

#include "core/total_name.h"
#include "io/image_io.h"
#include "jobs/write_results.h"

namespace plumb {
namespace {

std::map<std::string, Image<float>> MapsOf(const HeightField& field, const SurfaceLight& light,
                                           const std::vector<std::vector<float>>& bounces) {
    // Of this process alone: CTest runs each test as one, side by side.
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) /
                                         ("plumb_light_maps_" + std::to_string(::getpid()));
    WriteLightMaps(folder, {field, {}}, light, bounces);
    std::map<std::string, Image<float>> maps;
    for (NamedChannel& channel : ReadChannels(folder / "light.exr")) {
        maps.emplace(channel.name, std::move(channel.pixels));
    }
    std::filesystem::remove_all(folder);
    return maps;
}

// Light that is a number of the facet, so that every pixel of every channel is its own.
SurfaceLight MadeLight(const HeightField& field) {
    SurfaceLight light;
    light.albedos = {0.05, 0.5};
    light.total.resize(2);
    for (std::int64_t i = 0; i < field.Facets(); ++i) {
        light.alpha.push_back(double(i));
        light.V.push_back(1000 + double(i * i));
        light.total[0].push_back(float(2000 + i));
        light.total[1].push_back(float(3000 + i));
    }
    return light;
}

// Expected: on the plane z = 3 x + 5 y every point's height follows from where it stands, and the
// middle of cell (i, j) is ((i + 1) s_x, (j + 1) s_y): texel centres are half a texel off.
// Tolerance: a rounding to float.
TEST(LightMaps, HeightsStandWhereTheLightStands) {
    Image<double> heights(5, 4);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 5; ++i) heights(i, j) = 3 * (i + 0.5) * 0.5 + 5 * (j + 0.5) * 0.25;
    }
    const HeightField plane(heights, 0.5, 0.25, Boundary::kOpen);
    const auto maps = MapsOf(plane, MadeLight(plane), {});
    const Image<float>& height_m = maps.at("height_m");
    ASSERT_EQ(height_m.Width(), 4);
    ASSERT_EQ(height_m.Height(), 3);
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 4; ++i) {
            EXPECT_NEAR(height_m(i, j), 3 * (i + 1) * 0.5 + 5 * (j + 1) * 0.25, 1e-5);
        }
    }
}

// Expected: pixel c is the mean of facets 2c and 2c + 1; names without a dot.
TEST(LightMaps, EveryChannelIsTheMeanOfTheTwoFacets) {
    const HeightField field(Image<double>(3, 3), 1, 1, Boundary::kWrap);
    std::vector<float> first, second;
    for (std::int64_t i = 0; i < field.Facets(); ++i) {
        first.push_back(float(4000 + i));
        second.push_back(float(5000 + i));
    }
    const auto maps = MapsOf(field, MadeLight(field), {first, second});
    EXPECT_EQ(maps.size(), 7u);
    ASSERT_EQ(field.CellsX(), 3);
    for (std::size_t c = 0; c < 9; ++c) {
        const auto at = [&](const char* name) { return maps.at(name).Pixels()[c]; };
        const double a = 2.0 * double(c), b = a + 1;
        EXPECT_EQ(at("alpha"), float((a + b) / 2));
        EXPECT_EQ(at("V"), float(1000 + (a * a + b * b) / 2));
        EXPECT_EQ(at("E_rho0p05"), float(2000 + (a + b) / 2));
        EXPECT_EQ(at("E_rho0p5"), float(3000 + (a + b) / 2));
        EXPECT_EQ(at("E_0"), float(4000 + (a + b) / 2));
        EXPECT_EQ(at("E_1"), float(5000 + (a + b) / 2));
    }
    for (const auto& [name, pixels] : maps) EXPECT_EQ(name.find('.'), std::string::npos);
}

}  // namespace
}  // namespace plumb
