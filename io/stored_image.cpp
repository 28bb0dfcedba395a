#include "io/stored_image.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstdint>
#include <memory>

#include "core/error.h"
#include "io/image_format.h"
#include "io/pfm.h"
#include "io/tiff_image.h"
#include "io/whole_file.h"

namespace plumb {
namespace {

using OIIO::TypeDesc;

/// One channel in the type T that the file stores, as double: exact up to 53 bits.
template <class T>
Image<double> ReadChannel(OIIO::ImageInput& input, int channel, TypeDesc type) {
    const OIIO::ImageSpec& spec = input.spec();
    std::vector<T> numbers(std::size_t(spec.width) * std::size_t(spec.height));
    // A failure shows in the error text; not every reader returns false.
    input.read_image(0, 0, channel, channel + 1, type, numbers.data());
    Image<double> image(spec.width, spec.height);
    std::copy(numbers.begin(), numbers.end(), image.Pixels().begin());
    return image;
}

Image<double> ReadChannel(OIIO::ImageInput& input, int channel, TypeDesc type) {
    switch (type.basetype) {
        case TypeDesc::UINT8:
            return ReadChannel<std::uint8_t>(input, channel, type);
        case TypeDesc::UINT16:
            return ReadChannel<std::uint16_t>(input, channel, type);
        case TypeDesc::UINT32:
            return ReadChannel<std::uint32_t>(input, channel, type);
        default:
            return ReadChannel<float>(input, channel, TypeDesc::FLOAT);
    }
}

bool IsFloat(TypeDesc type) {
    return type.basetype == TypeDesc::HALF || type.basetype == TypeDesc::FLOAT ||
           type.basetype == TypeDesc::DOUBLE;
}

std::string FirstLine(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

std::unique_ptr<OIIO::ImageInput> Open(const std::filesystem::path& path) {
    OIIO::ImageSpec wishes;
    wishes["oiio:UnassociatedAlpha"] = 1;  // stored colours, not colours times alpha
    auto input = OIIO::ImageInput::open(path.string(), &wishes);
    if (!input) {
        throw Error(path.string() + ": cannot be read: " + FirstLine(OIIO::geterror()));
    }
    return input;
}

StoredImage Read(const std::filesystem::path& path, std::string_view bytes, ImageFormat format,
                 std::int64_t max_numbers) {
    const auto input = Open(path);
    const OIIO::ImageSpec& spec = input->spec();
    CheckImageSize(path.string(), spec.width, spec.height, spec.nchannels, max_numbers);
    if (spec.get_int_attribute("oiio:subimages", 1) > 1) {
        throw Error(path.string() + ": holds several images (parts), must hold one");
    }
    if (format == ImageFormat::kPng) CheckPngHoldsItsPixels(path.string(), bytes);
    if (spec.deep || spec.depth > 1) {
        throw Error(path.string() + ": is a deep image or a volume, must be flat");
    }
    StoredImage image;
    image.is_float = IsFloat(spec.format);
    image.is_signed = spec.format.is_signed();
    image.bits = 8 * int(spec.format.basesize());
    image.full_scale = image.is_float ? 1 : GreatestInteger(image.bits, image.is_signed);
    for (int c = 0; c < spec.nchannels; ++c) {
        image.channels.push_back({spec.channel_name(c), ReadChannel(*input, c, spec.format)});
        const std::string error = input->geterror();
        if (!error.empty()) {
            throw Error(path.string() + ": is truncated or damaged: " + FirstLine(error));
        }
    }
    for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
        if (attribute.type() == TypeDesc::STRING) {
            image.metadata.emplace_back(attribute.name().string(), attribute.get_string());
        }
    }
    return image;
}

/// Bits of a number of a whole PNG, from its header ([PNG] 11.2.2); 8 for a palette, whose colours
/// have 8 bits.
int PngBits(std::string_view bytes) {
    constexpr std::size_t kBitDepth = 24, kColourType = 25;
    constexpr char kPalette = 3;
    return bytes[kColourType] == kPalette ? 8 : bytes[kBitDepth];
}

/// The decoder spreads numbers of 1, 2 and 4 bits over 0 ... 255: 255 / (2^bits - 1) to a step.
void UndoScalingToEightBits(StoredImage& image, int bits) {
    if (bits >= 8) return;
    const double step = image.full_scale / GreatestInteger(bits, false);
    for (StoredImage::Channel& channel : image.channels) {
        for (double& number : channel.stored.Pixels()) number /= step;
    }
    image.bits = bits;
    image.full_scale = GreatestInteger(bits, false);
}

}  // namespace

StoredImage ReadStoredImage(const std::filesystem::path& path, std::int64_t max_numbers) {
    const std::string bytes = ReadWholeFile(path);
    const ImageFormat format = CheckImageFormat(path, bytes);
    if (format == ImageFormat::kPfm) return ParsePfm(bytes, path.string(), max_numbers);
    if (format == ImageFormat::kTiff) return ReadTiffImage(path, max_numbers);
    if (format == ImageFormat::kPng) CheckPngIsWhole(path, bytes);
    StoredImage image = Read(path, bytes, format, max_numbers);
    if (format == ImageFormat::kPng) UndoScalingToEightBits(image, PngBits(bytes));
    return image;
}

}  // namespace plumb
