#include "io/geotiff.h"

#include <tiffio.h>

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>

#include "io/open_tiff.h"

namespace plumb {
namespace {

constexpr std::uint32_t kModelPixelScale = 33550, kModelTransformation = 34264,
                        kGeoKeyDirectory = 34735, kGdalNoData = 42113;
constexpr std::uint16_t kModelTypeKey = 1024, kLinearUnitsKey = 3076;
constexpr std::uint16_t kGeographic = 2, kMetre = 9001, kFoot = 9002, kUsSurveyFoot = 9003;

/// A tag that libtiff does not know: it hands out the count and the values.
template <class T>
std::span<const T> Tag(TIFF* file, std::uint32_t tag, TIFFDataType type) {
    const TIFFField* field = TIFFFindField(file, tag, TIFF_ANY);
    std::uint32_t count = 0;
    const T* values = nullptr;
    if (field == nullptr || TIFFFieldDataType(field) != type || !TIFFFieldPassCount(field) ||
        TIFFGetField(file, tag, &count, &values) != 1) {
        return {};
    }
    return {values, count};
}

/// A short value of the key directory: rows of (key, place, count, value) after one of numbers
/// about the directory itself; place 0 means that the value is in the row.
std::optional<std::uint16_t> GeoKey(TIFF* file, std::uint16_t key) {
    const auto keys = Tag<std::uint16_t>(file, kGeoKeyDirectory, TIFF_SHORT);
    for (std::size_t row = 4; row + 4 <= keys.size(); row += 4) {
        if (keys[row] == key && keys[row + 1] == 0) return keys[row + 3];
    }
    return std::nullopt;
}

/// Along x and y, in the unit of the model.
std::optional<Vec2> Scale(TIFF* file) {
    const auto scale = Tag<double>(file, kModelPixelScale, TIFF_DOUBLE);
    if (scale.size() >= 2) return Vec2(std::abs(scale[0]), std::abs(scale[1]));
    // A 4 x 4 matrix by rows: the image of a step of one texel is a column of it.
    const auto matrix = Tag<double>(file, kModelTransformation, TIFF_DOUBLE);
    if (matrix.size() >= 16) {
        return Vec2(std::hypot(matrix[0], matrix[4]), std::hypot(matrix[1], matrix[5]));
    }
    return std::nullopt;
}

std::optional<double> MetresPerUnit(TIFF* file) {
    switch (GeoKey(file, kLinearUnitsKey).value_or(kMetre)) {
        case kMetre:
            return 1;
        case kFoot:
            return 0.3048;
        case kUsSurveyFoot:
            return 1200. / 3937;
        default:
            return std::nullopt;
    }
}

std::optional<double> NoData(TIFF* file) {
    const auto text = Tag<char>(file, kGdalNoData, TIFF_ASCII);
    if (text.empty()) return std::nullopt;
    const std::string digits(text.data(), text.size());
    char* end = nullptr;
    const double value = std::strtod(digits.c_str(), &end);
    return end == digits.c_str() ? std::nullopt : std::optional(value);
}

}  // namespace

GeoTags ReadGeoTags(const std::filesystem::path& path) {
    const auto file = OpenTiff(path);
    GeoTags tags;
    tags.spacing_m = Scale(file.get());
    tags.no_data = NoData(file.get());
    if (!tags.spacing_m) return tags;
    const auto metres_per_unit = MetresPerUnit(file.get());
    if (GeoKey(file.get(), kModelTypeKey) == kGeographic) {
        tags.no_spacing_because = "its texels are measured in degrees";
    } else if (!metres_per_unit) {
        tags.no_spacing_because = "its unit of length is neither metre nor foot";
    } else if (!(tags.spacing_m->minCoeff() > 0) || !tags.spacing_m->allFinite()) {
        tags.no_spacing_because = "its pixel scale is not > 0";
    } else {
        *tags.spacing_m *= *metres_per_unit;
    }
    if (!tags.no_spacing_because.empty()) tags.spacing_m.reset();
    return tags;
}

}  // namespace plumb
