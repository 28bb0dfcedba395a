#include "io/read_heights.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/error.h"
#include "core/names.h"
#include "io/geotiff.h"

namespace plumb {
namespace {

std::vector<std::string> ChannelNames(const StoredImage& image) {
    std::vector<std::string> names;
    for (const StoredImage::Channel& channel : image.channels) names.push_back(channel.name);
    return names;
}

const StoredImage::Channel* Find(const StoredImage& image, const std::string& name) {
    for (const StoredImage::Channel& channel : image.channels) {
        if (channel.name == name) return &channel;
    }
    return nullptr;
}

const StoredImage::Channel& ChannelNamed(const StoredImage& image, const std::string& name,
                                         const std::string& file) {
    const StoredImage::Channel* channel = Find(image, name);
    if (channel == nullptr) {
        throw Error(file + ": channel = " + name + ", " +
                    MustBeOneOf(name, ChannelNames(image)));
    }
    return *channel;
}

/// The only one; or the red one of a grey picture that was saved in colour, whatever its alpha.
const StoredImage::Channel& OnlyChannel(const StoredImage& image, const std::string& file) {
    if (image.channels.size() == 1) return image.channels.front();
    const auto *r = Find(image, "R"), *g = Find(image, "G"), *b = Find(image, "B");
    if (r != nullptr && g != nullptr && b != nullptr && r->stored == g->stored &&
        g->stored == b->stored) {
        return *r;
    }
    const auto* grey = Find(image, "Y");
    if (grey != nullptr && image.channels.size() == 2 && Find(image, "A") != nullptr) {
        return *grey;
    }
    throw Error(file + ": has the channels " + Joined(ChannelNames(image)) +
                " and they differ, must be one or alike; name one in the side file's field "
                "\"channel\" (or \"packing\": \"rgb24\")");
}

Image<double> Unpack24(const StoredImage& image, const std::string& file) {
    if (image.is_float || image.bits != 8 || image.is_signed) {
        throw Error(MustBe(file + ": bits of packing rgb24", image.bits, "8, unsigned"));
    }
    Image<double> packed(image.Width(), image.Height());
    for (const char* name : {"R", "G", "B"}) {
        const Image<double>& stored = ChannelNamed(image, name, file).stored;
        for (std::size_t k = 0; k < packed.Pixels().size(); ++k) {
            packed.Pixels()[k] = 256 * packed.Pixels()[k] + stored.Pixels()[k];
        }
    }
    return packed;
}

/// The "no data" number as the pixels hold it: a tag in decimal digits has others than a float.
/// -3.40282346638529e+38 (15 digits, as GDAL writes) is no float, its nearest one is.
std::optional<double> AsStored(std::optional<double> number, const StoredImage& image) {
    if (!number || !image.is_float || image.bits == 64) return number;
    if (image.bits == 16) return double(Eigen::half(float(*number)));
    return double(float(*number));
}

/// Every pixel must be a measured, finite number.
void CheckPixels(const Image<double>& stored, std::optional<double> no_data,
                 const std::string& file) {
    for (int j = 0; j < stored.Height(); ++j) {
        for (int i = 0; i < stored.Width(); ++i) {
            const double value = stored(i, j);
            const bool missing = no_data && value == *no_data;
            if (std::isfinite(value) && !missing) continue;
            throw Error(MustBe(
                file + ": pixel (" + std::to_string(i) + ", " + std::to_string(j) + ")", value,
                missing ? "measured, is the file's \"no data\" value" : "finite"));
        }
    }
}

bool IsTiff(const std::filesystem::path& path) {
    const std::string ending = path.extension().string();
    return ending.size() > 1 && std::tolower(ending[1]) == 't';
}

}  // namespace

RawHeights ReadHeights(const std::filesystem::path& path, const HeightEncoding& encoding,
                       std::int64_t max_numbers) {
    const std::string file = path.string();
    StoredImage image = ReadStoredImage(path, max_numbers);
    const GeoTags tags = IsTiff(path) ? ReadGeoTags(path) : GeoTags{};
    RawHeights heights{.values = {},
                       .is_float = image.is_float,
                       .bits = image.bits,
                       .full_scale = image.full_scale,
                       .channel = {},
                       .spacing_m = tags.spacing_m,
                       .no_spacing_because = tags.no_spacing_because};
    if (encoding.rgb24) {
        heights.values = Unpack24(image, file);
        heights.bits = 24;
        heights.full_scale = (1 << 24) - 1;
        heights.channel = "RGB";
    } else {
        const StoredImage::Channel& channel = encoding.channel.empty()
                                                  ? OnlyChannel(image, file)
                                                  : ChannelNamed(image, encoding.channel, file);
        heights.channel = channel.name;
        // Not a copy: of 2^28 texels it is 2 GB.
        heights.values =
            std::move(image.channels[std::size_t(&channel - image.channels.data())].stored);
    }
    CheckPixels(heights.values, AsStored(tags.no_data, image), file);
    for (double& value : heights.values.Pixels()) value /= heights.full_scale;
    return heights;
}

}  // namespace plumb
