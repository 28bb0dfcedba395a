#include "io/picture_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/srgb.h"
#include "io/image_format.h"
#include "io/whole_file.h"

namespace plumb {
namespace {

using std::string_view_literals::operator""sv;

struct Known {
    std::string_view mark;    // What the content begins with.
    std::string_view ending;  // That tells the decoder which format it is.
};

constexpr std::array kKnown{
    Known{"\x89PNG\r\n\x1a\n"sv, "png"},
    Known{"\xff\xd8\xff"sv, "jpg"},
    Known{"BM"sv, "bmp"},
    Known{"II*\0"sv, "tif"},
    Known{"MM\0*"sv, "tif"},
    Known{"\x76\x2f\x31\x01"sv, "exr"},
    Known{"#?"sv, "hdr"},
    Known{"GIF8"sv, "gif"},
};

std::string FormatOf(std::string_view bytes, const std::string& name) {
    for (const Known& known : kKnown) {
        if (bytes.starts_with(known.mark)) return std::string(known.ending);
    }
    std::string ending = std::filesystem::path(name).extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    if (ending == ".tga") return "tga";
    throw Error(name +
                ": is no picture of a known format (PNG, JPEG, TGA, BMP, TIFF, EXR, HDR, GIF)");
}

std::string FirstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

// Which channels are red, green, blue; and opacity, -1 if none is.
struct Channels {
    std::array<int, 3> colour;
    int opacity;
};

Channels ChannelsOf(const OIIO::ImageSpec& spec) {
    const int n = spec.nchannels;
    const int opacity =
        spec.alpha_channel >= 0 && spec.alpha_channel < n && n > 1 ? spec.alpha_channel : -1;
    const int colours = n - (opacity >= 0 ? 1 : 0);
    const auto named = [&](const char* name, int otherwise) {
        const int found = spec.channelindex(name);
        return found >= 0 ? found : otherwise;
    };
    if (colours < 3) {
        const int grey = named("Y", opacity == 0 ? 1 : 0);
        return {{grey, grey, grey}, opacity};
    }
    return {{named("R", 0), named("G", 1), named("B", 2)}, opacity};
}

Picture Decode(std::string_view bytes, const std::string& name, PictureOf of,
               std::int64_t max_numbers) {
    if (bytes.empty()) throw Error(name + ": is empty");
    const std::string format = FormatOf(bytes, name);
    if (format == "png") CheckPngIsWhole(name, bytes);
    OIIO::Filesystem::IOMemReader memory(const_cast<char*>(bytes.data()), bytes.size());
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;  // Stored colours, not colours times alpha.
    OIIO::Filesystem::IOProxy* source = &memory;
    wishes.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &source);
    const auto input = OIIO::ImageInput::open("picture." + format, &wishes);
    if (!input) throw Error(name + ": cannot be read: " + FirstLine(OIIO::geterror()));
    const OIIO::ImageSpec spec = input->spec();
    CheckImageSize(name, spec.width, spec.height, spec.nchannels, max_numbers);
    if (format == "png") CheckPngHoldsItsPixels(name, bytes);
    if (spec.deep || spec.depth > 1) {
        throw Error(name + ": is a deep image or a volume, must be flat");
    }
    const std::size_t n = std::size_t(spec.nchannels);
    std::vector<float> numbers(std::size_t(spec.width) * std::size_t(spec.height) * n);
    const bool read =
        input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, numbers.data());
    if (const std::string error = input->geterror(); !read || !error.empty()) {
        throw Error(name + ": is truncated or damaged: " + FirstLine(error));
    }
    const bool encoded = of == PictureOf::kColours &&
                         spec.format.basetype != OIIO::TypeDesc::HALF &&
                         spec.format.basetype != OIIO::TypeDesc::FLOAT &&
                         spec.format.basetype != OIIO::TypeDesc::DOUBLE;
    const Channels channels = ChannelsOf(spec);
    Picture picture;
    picture.linear = Image<Rgb>(spec.width, spec.height);
    if (channels.opacity >= 0) picture.opacity = Image<float>(spec.width, spec.height);
    for (std::size_t p = 0; p < picture.linear.Pixels().size(); ++p) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float stored = numbers[p * n + std::size_t(channels.colour[c])];
            const bool good = std::isfinite(stored) && stored >= 0;
            picture.had_bad_numbers = picture.had_bad_numbers || !good;
            const double value = good ? stored : 0;
            picture.linear.Pixels()[p][c] = float(encoded ? DecodeSrgb(value) : value);
        }
        if (channels.opacity >= 0) {
            const float stored = numbers[p * n + std::size_t(channels.opacity)];
            // In this order what is not a number becomes 0.
            picture.opacity.Pixels()[p] = std::min(1.0f, std::max(0.0f, stored));
        }
    }
    return picture;
}

}  // namespace

Picture DecodePicture(std::string_view bytes, const std::string& name, PictureOf of,
                      std::int64_t max_numbers) {
    try {
        return Decode(bytes, name, of, max_numbers);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw MachineError(name + ": out of memory");
    } catch (const std::exception& error) {  // Some decoders throw what they like.
        throw Error(name + ": is damaged: " + error.what());
    }
}

Picture ReadPictureFile(const std::filesystem::path& path, PictureOf of,
                        std::int64_t max_numbers) {
    return DecodePicture(ReadWholeFile(path), path.string(), of, max_numbers);
}

}  // namespace plumb
