#include "io/side_file.h"

#include "core/error.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

class Side : public TempFolder {
  protected:
    SideFile Read(const std::string& json) const {
        Put("wall.json", json);
        return ReadSideFile(Path("wall.png"));
    }
    /// What is wrong, without the folder.
    std::string MessageOf(const std::string& json) const {
        const std::string message = plumb::MessageOf<Error>([&] { Read(json); });
        return message.substr(std::min(message.size(), folder_.string().size() + 1));
    }
};

TEST_F(Side, StandsBesideTheImage) {
    EXPECT_EQ(SideFilePath("a/wall.png"), "a/wall.json");
    const SideFile none = ReadSideFile(Path("wall.png"));
    EXPECT_FALSE(none.name || none.spacing_m || none.amplitude_m || none.low_m);
}

// The example of docs/height_maps.md.
TEST_F(Side, HasTheFieldsOfTheManual) {
    const SideFile side = Read(R"({
        "name": "Jacksboro fault", "spacing_m": [74, 93], "metres_per_unit": 0.1,
        "low_m": 236, "boundary": "open", "source": "SRTM", "licence": "public domain"})");
    EXPECT_EQ(side.name, "Jacksboro fault");
    EXPECT_EQ(side.spacing_m, Vec2(74, 93));
    EXPECT_EQ(side.metres_per_unit, 0.1);
    EXPECT_EQ(side.low_m, 236);
    EXPECT_EQ(side.boundary, "open");
    EXPECT_EQ(side.source, "SRTM");
    EXPECT_EQ(side.licence, "public domain");
    EXPECT_FALSE(side.amplitude_m || side.amplitude_of_width || side.high_m);
}

TEST_F(Side, HasTheOtherFieldsToo) {
    EXPECT_EQ(Read(R"({"spacing_m": 0.004})").spacing_m, Vec2(0.004, 0.004));
    EXPECT_EQ(Read(R"({"amplitude_m": 0.1})").amplitude_m, 0.1);
    EXPECT_EQ(Read(R"({"amplitude_of_width": 0})").amplitude_of_width, 0);
    EXPECT_EQ(Read(R"({"low_m": -5, "high_m": 5})").high_m, 5);
    EXPECT_EQ(Read(R"({"channel": "A"})").encoding.channel, "A");
    EXPECT_TRUE(Read(R"({"packing": "rgb24"})").encoding.rgb24);
}

TEST_F(Side, NamesFileFieldValueAndRule) {
    EXPECT_EQ(MessageOf(R"({"spacing_m": -1})"), "wall.json: spacing_m = -1, must be > 0");
    EXPECT_EQ(MessageOf(R"({"spacing_m": [1, 0]})"),
              "wall.json: spacing_m[1] = 0, must be > 0");
    EXPECT_EQ(MessageOf(R"({"spacing_m": [1, 2, 3]})"),
              "wall.json: spacing_m: length = 3, must be 2, for x and y");
    EXPECT_EQ(MessageOf(R"({"spacing_m": "1"})"),
              "wall.json: spacing_m = \"1\", must be a number, > 0");
    EXPECT_EQ(MessageOf(R"({"amplitude_m": -0.1})"),
              "wall.json: amplitude_m = -0.1, must be >= 0");
    EXPECT_EQ(MessageOf(R"({"metres_per_unit": 0})"),
              "wall.json: metres_per_unit = 0, must be > 0");
    EXPECT_EQ(MessageOf(R"({"boundary": "clamp"})"),
              "wall.json: boundary = \"clamp\", must be one of wrap, mirror, open");
    EXPECT_EQ(MessageOf(R"({"name": ""})"), "wall.json: name = \"\", must not be empty");
    EXPECT_EQ(MessageOf(R"({"packing": "rgb16"})"),
              "wall.json: packing = \"rgb16\", must be one of rgb24");
    EXPECT_EQ(MessageOf("[]"), "wall.json = [], must be an object { ... }");
}

TEST_F(Side, RefusesUnknownFields) {
    EXPECT_EQ(MessageOf(R"({"spacing": 1})"),
              "wall.json: spacing = 1: unknown field, must be one of name, spacing_m, "
              "amplitude_m, amplitude_of_width, metres_per_unit, low_m, high_m, boundary, "
              "channel, packing, source, licence; did you mean spacing_m?");
}

TEST_F(Side, RefusesTwoWaysToTheHeights) {
    EXPECT_EQ(MessageOf(R"({"amplitude_m": 1, "metres_per_unit": 1})"),
              "wall.json: at most one of amplitude_m, amplitude_of_width, metres_per_unit, "
              "high_m must be given");
    EXPECT_EQ(MessageOf(R"({"high_m": 1})"), "wall.json: high_m needs low_m");
    EXPECT_EQ(MessageOf(R"({"low_m": 2, "high_m": 1})"),
              "wall.json: high_m = 1, must be >= low_m");
}

}  // namespace
}  // namespace plumb
