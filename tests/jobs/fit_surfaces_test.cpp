#include "jobs/light/fit_surfaces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "io/image_io.h"
#include "jobs/write_results.h"

namespace plumb {
namespace {

std::vector<std::string> NamesOf(const std::vector<std::string>& maps) {
    std::vector<std::string> names;
    for (const Surface& surface : LoadSurfaces(maps)) names.push_back(surface.source.name);
    return names;
}

// Two maps of one name would be one row, one picture and one choice: the second would win.
TEST(LoadSurfaces, GivesEveryMapANameOfItsOwn) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "plumb_fit_surfaces";
    for (const char* name : {"m1/wall.png", "m2/wall.png", "m2/other.png"}) {
        std::filesystem::create_directories((folder / name).parent_path());
        WriteGreyPng(folder / name, Image<double>(4, 4, 0.5), 8);
    }
    const auto at = [&](const char* name) { return (folder / name).string(); };
    EXPECT_THAT(NamesOf({at("m1/wall.png"), at("m2/wall.png"), at("m2/other.png")}),
                testing::ElementsAre("m1/wall", "m2/wall", "other"));
    EXPECT_THAT(NamesOf({at("m1/wall.png"), at("m1/wall.png")}),
                testing::ElementsAre("m1/wall", "m1/wall 2"));
    EXPECT_THAT(NamesOf({"make:bricks:8", "make:bricks:16", at("m1/wall.png")}),
                testing::ElementsAre("bricks", "bricks 2", "wall"));
    // "bricks 2" is also what the generator calls its second seed.
    EXPECT_THAT(NamesOf({"make:bricks:8", "make:bricks:8:2", "make:bricks:16"}),
                testing::ElementsAre("bricks", "bricks 2", "bricks 3"));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace plumb
