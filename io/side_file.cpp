#include "io/side_file.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/error.h"
#include "core/names.h"
#include "io/json_file.h"
#include "io/regular_file.h"

namespace plumb {
namespace {

const std::vector<std::string> kBoundaries{"wrap", "mirror", "open"};

/// One number for both axes, or one each.
std::optional<Vec2> ReadSpacing(JsonFields& fields) {
    if (!fields.IsList("spacing_m")) {
        const auto spacing = fields.Number("spacing_m", kPositive);
        return spacing ? std::optional(Vec2(*spacing, *spacing)) : std::nullopt;
    }
    const std::vector<double> spacing = fields.NeedNumbers("spacing_m", kPositive);
    if (spacing.size() != 2) {
        throw Error(MustBe(fields.NameOf("spacing_m") + ": length", double(spacing.size()),
                           "2, for x and y"));
    }
    return Vec2(spacing[0], spacing[1]);
}

void CheckHeightFields(const SideFile& side, const std::string& file) {
    const std::array given{side.amplitude_m.has_value(), side.amplitude_of_width.has_value(),
                           side.metres_per_unit.has_value(), side.high_m.has_value()};
    if (std::count(given.begin(), given.end(), true) > 1) {
        throw Error(file +
                    ": at most one of amplitude_m, amplitude_of_width, metres_per_unit, "
                    "high_m must be given");
    }
    if (side.high_m && !side.low_m) throw Error(file + ": high_m needs low_m");
    if (side.high_m && !(*side.high_m >= *side.low_m)) {
        throw Error(MustBe(file + ": high_m", *side.high_m, ">= low_m"));
    }
}

}  // namespace

std::filesystem::path SideFilePath(const std::filesystem::path& image) {
    return std::filesystem::path(image).replace_extension(".json");
}

SideFile ReadSideFile(const std::filesystem::path& image) {
    const std::filesystem::path path = SideFilePath(image);
    SideFile side;
    if (!IsThere(path)) return side;
    const nlohmann::ordered_json json = ReadJsonFile(path);
    JsonFields fields(json, path.string());
    side.name = fields.Text("name");
    if (side.name && side.name->empty()) {
        throw Error(fields.NameOf("name") + " = \"\", must not be empty");
    }
    side.spacing_m = ReadSpacing(fields);
    side.amplitude_m = fields.Number("amplitude_m", kNotNegative);
    side.amplitude_of_width = fields.Number("amplitude_of_width", kNotNegative);
    side.metres_per_unit = fields.Number("metres_per_unit", kPositive);
    side.low_m = fields.Number("low_m", kFinite);
    side.high_m = fields.Number("high_m", kFinite);
    side.boundary = fields.OneOf("boundary", kBoundaries);
    side.encoding.channel = fields.Text("channel").value_or("");
    side.encoding.rgb24 = fields.OneOf("packing", {"rgb24"}).has_value();
    side.source = fields.Text("source").value_or("");
    side.licence = fields.Text("licence").value_or("");
    fields.Finish();
    CheckHeightFields(side, path.string());
    return side;
}

void CheckBoundary(const std::string& where, const std::string& boundary) {
    PlaceOf(boundary, kBoundaries, where + " = " + boundary);
}

}  // namespace plumb
