#include "io/json_file.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
using testing::StartsWith;

TEST(ParseJson, NamesLineAndColumnOfASlip) {
    const auto message = [](const char* text) {
        return MessageOf<Error>([&] { ParseJson(text, "a.json"); });
    };
    // The stray brace is the 3rd character of line 3.
    EXPECT_THAT(message("{\n  \"a\": 1,\n  }\n"), StartsWith("a.json:3:3: no JSON: "));
    EXPECT_THAT(message("[1, 2"), StartsWith("a.json:1:6: no JSON: "));
    EXPECT_THAT(message(""), StartsWith("a.json:1:1: no JSON: "));
    EXPECT_EQ(message("{\"x\": 1e999}"), "a.json: a number is too large for a double");
}

TEST(ParseJson, RefusesAFieldThatIsGivenTwice) {
    EXPECT_EQ(MessageOf<Error>([] { ParseJson(R"({"a": {"b": 1, "b": 2}})", "a.json"); }),
              "a.json: field \"b\" is given twice");
    // The same name in two objects is no repetition.
    EXPECT_EQ(ParseJson(R"([{"b": 1}, {"b": 2}])", "a.json").size(), 2u);
}

using JsonFile = TempFolder;

TEST_F(JsonFile, KeepsOrderAndBits) {
    const Json json{{"z", 0.1}, {"a", 1. / 3}, {"list", {1, 2}}};
    WriteJsonFile(Path("a.json"), json);
    EXPECT_EQ(Get("a.json").substr(0, 13), "{\n  \"z\": 0.1,");
    EXPECT_EQ(Get("a.json").back(), '\n');
    EXPECT_EQ(ReadJsonFile(Path("a.json")), json);
    EXPECT_THROW(ReadJsonFile(Path("none.json")), Error);
}

TEST_F(JsonFile, ReplacesWhatIsNoUtf8) {
    WriteJsonFile(Path("a.json"), {{"name", "wall\xff"}});
    EXPECT_EQ(ReadJsonFile(Path("a.json"))["name"], "wall\xef\xbf\xbd");  // U+FFFD
}

TEST(JsonFields, ReadsFieldsThatAreThere) {
    const Json json = ParseJson(
        R"({"number": 2.5, "text": "t", "one": "b", "numbers": [1, 2], "count": 7})", "a.json");
    JsonFields fields(json, "a.json");
    EXPECT_EQ(fields.Number("number", kPositive), 2.5);
    EXPECT_EQ(fields.Text("text"), "t");
    EXPECT_EQ(fields.OneOf("one", {"a", "b"}), "b");
    EXPECT_EQ(fields.Numbers("numbers", kFinite), (std::vector<double>{1, 2}));
    EXPECT_EQ(fields.NeedCount("count"), 7);
    EXPECT_EQ(fields.Number("absent", kPositive), std::nullopt);
    EXPECT_EQ(fields.Text("absent"), std::nullopt);
    EXPECT_TRUE(fields.IsList("numbers"));
    EXPECT_FALSE(fields.IsList("number"));
    fields.Finish();
}

TEST(JsonFields, NamesFileFieldValueAndRule) {
    const Json json = ParseJson(
        R"({"number": -1, "text": 3, "one": "c", "numbers": [1, "x"], "count": 1.5})", "");
    JsonFields top(json, "a.json"), inner(json, "a.json", "bins[4]");
    const auto message = [](const auto& read) { return MessageOf<Error>(read); };
    EXPECT_EQ(message([&] { top.Number("number", kPositive); }),
              "a.json: number = -1, must be > 0");
    EXPECT_EQ(message([&] { inner.Number("number", kShare); }),
              "a.json: bins[4].number = -1, must be in [0, 1]");
    EXPECT_EQ(message([&] { top.Number("one", kPositive); }),
              "a.json: one = \"c\", must be a number, > 0");
    EXPECT_EQ(message([&] { top.Text("text"); }), "a.json: text = 3, must be a text \"...\"");
    EXPECT_EQ(message([&] {
                  top.OneOf("one", {"a", "b"});
              }),
              "a.json: one = \"c\", must be one of a, b");
    EXPECT_EQ(message([&] { top.Numbers("numbers", kFinite); }),
              "a.json: numbers[1] = \"x\", must be a number, finite");
    EXPECT_EQ(message([&] { top.Numbers("number", kFinite); }),
              "a.json: number = -1, must be a list [ ... ]");
    EXPECT_EQ(message([&] { top.NeedCount("count"); }),
              "a.json: count = 1.5, must be a whole number");
    EXPECT_EQ(message([&] { inner.NeedText("absent"); }), "a.json: bins[4].absent is missing");
    EXPECT_EQ(message([&] { JsonFields(json["text"], "a.json", "bins[0]"); }),
              "a.json: bins[0] = 3, must be an object { ... }");
}

TEST(JsonFields, RefusesWhatNobodyAskedFor) {
    const Json json = ParseJson(R"({"spacing_m": 1, "hight_m": 3})", "");
    JsonFields fields(json, "a.json");
    fields.Number("spacing_m", kPositive);
    fields.Number("high_m", kFinite);
    EXPECT_EQ(MessageOf<Error>([&] { fields.Finish(); }),
              "a.json: hight_m = 3: unknown field, must be one of spacing_m, high_m; "
              "did you mean high_m?");
}

TEST(JsonFields, CutsLongValues) {
    const Json json{{"text", Json::array({std::string(200, 'x')})}};
    JsonFields fields(json, "a.json");
    const std::string message = MessageOf<Error>([&] { fields.Text("text"); });
    EXPECT_LT(message.size(), 120u);
    EXPECT_THAT(message, testing::HasSubstr("..., must be"));
}

}  // namespace
}  // namespace plumb
