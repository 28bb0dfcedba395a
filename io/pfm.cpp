#include "io/pfm.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/error.h"
#include "io/image_format.h"

namespace plumb {
namespace {

/// The next word of the header, which ends with one white-space character.
std::string_view TakeWord(std::string_view& bytes, const std::string& name) {
    const std::size_t end = bytes.substr(0, 64).find_first_of(" \t\r\n");
    if (end == std::string_view::npos || end == 0) {
        throw Error(name + ": has a PFM header that breaks off");
    }
    const std::string_view word = bytes.substr(0, end);
    bytes.remove_prefix(end + 1);
    return word;
}

template <class T>
T TakeNumber(std::string_view& bytes, const std::string& name, const char* what) {
    const std::string_view word = TakeWord(bytes, name);
    T number{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || end != word.data() + word.size()) {
        throw Error(name + ": " + what + " = " + std::string(word) + ", must be a number");
    }
    return number;
}

float FloatAt(std::string_view bytes, std::size_t index, bool little_endian) {
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto byte = std::uint8_t(bytes[4 * index + (little_endian ? 3 - k : k)]);
        bits = bits << 8 | byte;
    }
    return std::bit_cast<float>(bits);
}

}  // namespace

StoredImage ParsePfm(std::string_view bytes, const std::string& name,
                     std::int64_t max_numbers) {
    const std::size_t channels = TakeWord(bytes, name) == "PF" ? 3 : 1;
    const auto width = TakeNumber<std::int64_t>(bytes, name, "width");
    const auto height = TakeNumber<std::int64_t>(bytes, name, "height");
    const auto scale = TakeNumber<double>(bytes, name, "scale");
    if (scale == 0 || !std::isfinite(scale)) {
        throw Error(MustBe(name + ": scale", scale, "finite and not 0"));
    }
    CheckImageSize(name, width, height, std::int64_t(channels), max_numbers);
    const std::size_t needed = 4 * channels * std::size_t(width) * std::size_t(height);
    if (bytes.size() < needed) {
        throw Error(name + ": is truncated, has " + std::to_string(bytes.size()) +
                    " bytes of pixels, must have " + std::to_string(needed));
    }
    StoredImage image;
    image.is_float = image.is_signed = true;
    image.bits = 32;
    for (std::size_t c = 0; c < channels; ++c) {
        Image<double> stored{int(width), int(height)};
        for (int j = 0; j < stored.Height(); ++j) {
            const auto row = std::size_t(stored.Height() - 1 - j) * std::size_t(width);
            for (int i = 0; i < stored.Width(); ++i) {
                stored(i, j) = std::abs(scale) *
                               double(FloatAt(bytes, (row + i) * channels + c, scale < 0));
            }
        }
        image.channels.push_back(
            {channels == 1 ? "Y" : std::string(1, "RGB"[c]), std::move(stored)});
    }
    return image;
}

}  // namespace plumb
