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

StoredImage Read(const std::filesystem::path& path, std::int64_t max_numbers) {
    const auto input = Open(path);
    const OIIO::ImageSpec& spec = input->spec();
    CheckImageSize(path.string(), spec.width, spec.height, spec.nchannels, max_numbers);
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

}  // namespace

StoredImage ReadStoredImage(const std::filesystem::path& path, std::int64_t max_numbers) {
    const std::string bytes = ReadWholeFile(path);
    const ImageFormat format = CheckImageFormat(path, bytes);
    if (format == ImageFormat::kPfm) return ParsePfm(bytes, path.string(), max_numbers);
    if (format == ImageFormat::kTiff) return ReadTiffImage(path, max_numbers);
    if (format == ImageFormat::kPng) CheckPngIsWhole(path, bytes);
    return Read(path, max_numbers);
}

}  // namespace plumb
