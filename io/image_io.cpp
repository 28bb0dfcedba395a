#include "io/image_io.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <set>

#include "core/error.h"
#include "core/srgb.h"
#include "io/whole_file.h"

namespace plumb {
namespace {

/// Encodes to memory, so that every write to the disk is our own and its failure is seen.
template <class T>
void Encode(const std::filesystem::path& path, const std::string& format, OIIO::ImageSpec spec,
            const std::vector<T>& numbers) {
    assert(numbers.size() ==
           std::size_t(spec.width) * std::size_t(spec.height) * std::size_t(spec.nchannels));
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(format, &memory);
    if (!output || !output->open(path.string(), spec) ||
        !output->write_image(OIIO::BaseTypeFromC<T>::value, numbers.data()) ||
        !output->close()) {
        throw MachineError(path.string() + ": cannot be encoded: " +
                           (output ? output->geterror() : OIIO::geterror()));
    }
    WriteWholeFile(path,
                   std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::uint8_t PreviewByte(float linear) {
    return std::uint8_t(std::lround(255 * EncodeSrgb(std::clamp(double(linear), 0.0, 1.0))));
}

const StoredImage::Channel* FindChannel(const StoredImage& image, const std::string& name) {
    for (const StoredImage::Channel& channel : image.channels) {
        if (channel.name == name) return &channel;
    }
    return nullptr;
}

/// The three channels of a picture, all the same one if it is grey.
std::array<const StoredImage::Channel*, 3> ColourChannels(const StoredImage& image,
                                                          const std::string& name) {
    std::array<const StoredImage::Channel*, 3> rgb{
        FindChannel(image, "R"), FindChannel(image, "G"), FindChannel(image, "B")};
    if (rgb[0] != nullptr && rgb[1] != nullptr && rgb[2] != nullptr) return rgb;
    const StoredImage::Channel* grey = FindChannel(image, "Y");
    if (image.channels.size() == 1) grey = &image.channels.front();
    if (grey != nullptr) return {grey, grey, grey};
    std::string names;
    for (const StoredImage::Channel& channel : image.channels) names += " " + channel.name;
    throw Error(name + ": has the channels" + names + ", must have R, G and B or only one");
}

}  // namespace

void WriteExr(const std::filesystem::path& path, const std::vector<NamedChannel>& channels,
              const ImageTexts& texts) {
    assert(!channels.empty());
    const int width = channels.front().pixels.Width();
    const int height = channels.front().pixels.Height();
    const std::size_t count = channels.size();
    OIIO::ImageSpec spec(width, height, int(count), OIIO::TypeDesc::FLOAT);
    spec.channelnames.clear();
    std::vector<float> numbers(std::size_t(width) * std::size_t(height) * count);
    std::set<std::string> names;
    for (std::size_t c = 0; c < count; ++c) {
        const auto& [name, pixels] = channels[c];
        if (name.empty() || !names.insert(name).second) {
            throw Error(path.string() + ": channel name = \"" + name +
                        "\", must be a name of its own");
        }
        assert(pixels.Width() == width && pixels.Height() == height);
        spec.channelnames.push_back(name);
        for (std::size_t k = 0; k < pixels.Pixels().size(); ++k) {
            numbers[k * count + c] = pixels.Pixels()[k];
        }
    }
    spec.attribute("compression", "zip");
    // Without a date of ours OpenImageIO writes the time of day, and no file equals another.
    spec.attribute("DateTime", "1970:01:01 00:00:00");
    for (const auto& [key, text] : texts) spec.attribute(key, text);
    Encode(path, "exr", spec, numbers);
}

std::vector<NamedChannel> ReadChannels(const std::filesystem::path& path,
                                       std::int64_t max_numbers) {
    const StoredImage image = ReadStoredImage(path, max_numbers);
    std::vector<NamedChannel> channels;
    for (const auto& [name, stored] : image.channels) {
        Image<float> pixels(stored.Width(), stored.Height());
        std::transform(stored.Pixels().begin(), stored.Pixels().end(), pixels.Pixels().begin(),
                       [&](double number) { return float(number / image.full_scale); });
        channels.push_back({name, std::move(pixels)});
    }
    return channels;
}

void WritePreview(const std::filesystem::path& path, const Image<Rgb>& linear) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(3 * linear.Pixels().size());
    for (const Rgb& pixel : linear.Pixels()) {
        const bool is_number = std::none_of(pixel.begin(), pixel.end(),
                                            [](float value) { return std::isnan(value); });
        for (float value : is_number ? pixel : Rgb{1, 0, 1}) {
            bytes.push_back(PreviewByte(value));
        }
    }
    Encode(path, "png",
           OIIO::ImageSpec(linear.Width(), linear.Height(), 3, OIIO::TypeDesc::UINT8), bytes);
}

void WritePreview(const std::filesystem::path& path, const Image<float>& linear_grey) {
    Image<Rgb> rgb(linear_grey.Width(), linear_grey.Height());
    std::transform(linear_grey.Pixels().begin(), linear_grey.Pixels().end(),
                   rgb.Pixels().begin(), [](float value) {
                       return Rgb{value, value, value};
                   });
    WritePreview(path, rgb);
}

Image<Rgb> ReadPicture(const std::filesystem::path& path, std::int64_t max_numbers) {
    const StoredImage image = ReadStoredImage(path, max_numbers);
    const auto channels = ColourChannels(image, path.string());
    Image<Rgb> picture(image.Width(), image.Height());
    for (std::size_t k = 0; k < picture.Pixels().size(); ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
            const double value = channels[c]->stored.Pixels()[k] / image.full_scale;
            picture.Pixels()[k][c] = float(image.is_float ? value : DecodeSrgb(value));
        }
    }
    return picture;
}

void WriteGreyPng(const std::filesystem::path& path, const Image<double>& values, int bits) {
    assert(bits == 8 || bits == 16);
    const double full_scale = bits == 8 ? 255 : 65535;
    std::vector<std::uint16_t> numbers;
    numbers.reserve(values.Pixels().size());
    for (int j = 0; j < values.Height(); ++j) {
        for (int i = 0; i < values.Width(); ++i) {
            const double value = values(i, j);
            if (!(0 <= value && value <= 1)) {
                throw Error(MustBe(path.string() + ": value at pixel (" + std::to_string(i) +
                                       ", " + std::to_string(j) + ")",
                                   value, "in [0, 1]"));
            }
            numbers.push_back(std::uint16_t(std::lround(full_scale * value)));
        }
    }
    const int width = values.Width(), height = values.Height();
    if (bits == 8) {
        Encode(path, "png", OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::UINT8),
               std::vector<std::uint8_t>(numbers.begin(), numbers.end()));
    } else {
        Encode(path, "png", OIIO::ImageSpec(width, height, 1, OIIO::TypeDesc::UINT16), numbers);
    }
}

}  // namespace plumb
