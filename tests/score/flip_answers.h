// Pictures of which the published FLIP program's answer is known.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "core/image.h"
#include "tests/score/made_images.h"

namespace plumb {

struct FlipAnswer {
    std::string name;
    Image<Rgb> candidate, reference;
    double mean, max = -1, middle = -1;  ///< -1: not known.
    bool hdr = false;
    /// How far the program's mean lies off by its own rounding, see flip_test.cpp.
    double rounding = 0;
};

inline float FromSrgb(double encoded) {
    return float(encoded <= 0.04045 ? encoded / 12.92
                                    : std::pow((encoded + 0.055) / 1.055, 2.4));
}

inline Rgb Grey(float value) {
    return {value, value, value};
}

/// The picture one pixel to the right, its first column twice.
inline Image<Rgb> ShiftedRight(const Image<Rgb>& picture) {
    Image<Rgb> shifted = picture;
    for (int j = 0; j < picture.Height(); ++j)
        for (int i = 1; i < picture.Width(); ++i) shifted(i, j) = picture(i - 1, j);
    return shifted;
}

inline Image<Rgb> Scaled(Image<Rgb> picture, float factor) {
    for (Rgb& pixel : picture.Pixels())
        for (float& c : pixel) c *= factor;
    return picture;
}

/// Red, green and blue of three other wavelengths, in 8 bits.
inline Image<Rgb> Weave() {
    return MadeImage<Rgb>(64, 48, [](int x, int y) {
        return Rgb{FromSrgb((7 * x + 13 * y) % 256 / 255.0),
                   FromSrgb((x * x + 3 * y) % 256 / 255.0),
                   FromSrgb(5 * (x ^ y) % 256 / 255.0)};
    });
}

/// Eight stops in red, four in green.
inline Image<Rgb> Stops() {
    return MadeImage<Rgb>(64, 48, [](int x, int y) {
        return Rgb{float(std::exp2((x - 32) / 8.0)), float(std::exp2((y - 24) / 8.0)), 0.5F};
    });
}

inline Image<Rgb> Step(double at_31) {
    return MadeImage<Rgb>(64, 64, [&](int x, int) {
        return Grey(FromSrgb(x == 31 ? at_31 : x < 32 ? 0 : 1));
    });
}

inline std::vector<FlipAnswer> FlipAnswers() {
    const auto flat = [](Rgb colour) { return Image<Rgb>(64, 64, colour); };
    const auto byte = [&](int value) { return flat(Grey(FromSrgb(value / 255.0))); };
    const auto checker =
        MadeImage<Rgb>(64, 64, [](int x, int y) { return Grey(float((x + y) % 2)); });
    Image<Rgb> dot = flat(Grey(0.25F));
    dot(32, 32) = Grey(1);
    return {
        {"weave", ShiftedRight(Weave()), Weave(), 0.369264, 0.978544, 0.361891},
        {"half an edge", Step(0.5), Step(0), 0.021537, 0.366400, 0.166792},
        {"a whole edge", Step(1), Step(0), 0.051732, 0.772917, 0.497553, false, 1e-5},
        {"checker", flat(Grey(FromSrgb(0.5))), checker, 0.518188, 0.791464, 0.511889},
        {"dot", dot, flat(Grey(0.25F)), 0.000963, 0.351878, 0.351878},
        {"a tenth brighter", Scaled(Stops(), 1.1F), Stops(), 0.145370, 0.180805, 0.161508,
         true},
        {"stops", ShiftedRight(Stops()), Stops(), 0.081336, 0.121702, 0.097169, true},
        {"black, white", byte(0), byte(255), 0.967388, -1, -1, false, 2e-5},
        {"one step", byte(129), byte(128), 0.029863, -1, -1, false, 2e-5},
        {"ten steps", byte(138), byte(128), 0.149010, -1, -1, false, 4e-5},
        {"red, green", flat({1, 0, 0}), flat({0, 1, 0}), 0.986665},
        {"green, blue", flat({0, 1, 0}), flat({0, 0, 1}), 1},
        {"the same", byte(77), byte(77), 0, 0, 0},
    };
}

}  // namespace plumb
