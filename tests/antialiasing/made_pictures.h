// Pictures made for the tests of filters.
#pragma once

#include <cstdint>
#include <functional>

#include "core/image.h"
#include "core/random.h"

namespace plumb {

inline Image<Rgb> GreyPicture(int width, int height,
                              const std::function<double(int, int)>& of) {
    Image<Rgb> picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const float value = float(of(x, y));
            picture(x, y) = {value, value, value};
        }
    }
    return picture;
}

/// Every channel of every pixel independent, uniform in [0, 1).
inline Image<Rgb> NoisePicture(int width, int height, std::uint64_t seed) {
    Image<Rgb> picture(width, height);
    for (int i = 0; i < width * height; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            picture.Pixels()[std::size_t(i)][c] =
                float(RandomUnit(seed, std::uint64_t(i), 0, c));
        }
    }
    return picture;
}

/// Blobs with curved borders of all directions, colours random but constant in each.
inline Image<Rgb> BlobPicture(int width, int height, std::uint64_t seed) {
    Image<Rgb> picture(width, height, Rgb{0.1f, 0.2f, 0.3f});
    for (std::uint64_t blob = 0; blob < 24; ++blob) {
        const auto unit = [&](std::uint64_t k) { return RandomUnit(seed, blob, k, 0); };
        const double cx = unit(0) * width, cy = unit(1) * height, r = 2 + unit(2) * width / 6;
        const Rgb colour{float(unit(3)), float(unit(4)), float(unit(5))};
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const double dx = x - cx, dy = (y - cy) * (0.3 + unit(6));
                if (dx * dx + dy * dy < r * r) picture(x, y) = colour;
            }
        }
    }
    return picture;
}

inline Image<Rgb> Transposed(const Image<Rgb>& picture) {
    Image<Rgb> out(picture.Height(), picture.Width());
    for (int y = 0; y < picture.Height(); ++y) {
        for (int x = 0; x < picture.Width(); ++x) out(y, x) = picture(x, y);
    }
    return out;
}

/// Left and right exchanged.
inline Image<Rgb> Mirrored(const Image<Rgb>& picture) {
    Image<Rgb> out(picture.Width(), picture.Height());
    for (int y = 0; y < picture.Height(); ++y) {
        for (int x = 0; x < picture.Width(); ++x) {
            out(picture.Width() - 1 - x, y) = picture(x, y);
        }
    }
    return out;
}

}  // namespace plumb
