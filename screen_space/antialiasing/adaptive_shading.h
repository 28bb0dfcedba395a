// Adaptive shading: each pixel the mean of as many samples of its window as it was given.
//
//       L(x, y) = 1/k Sum_{i < k}  L_i,    L_0 = S(x, y)
//
// where sample i is at the place of number i of the index matrix. First S, one sample a pixel, is
// shaded; the metrics read it; then the rest is shaded, in one of the ways of the paper:
//
//   one loop    row by row, each pixel all that it still needs
//   by count    all pixels of one count together, then those of the next
//
// Source   [Hollander13] section 3.2, listing 1, section 4.2.
// Symbols  S picture of the first samples, k samples of a pixel, m window edge.
// Domain   Counts in [1, m^2].
// Beware   Sums are in double and in the order of the index matrix, on any number of threads and in
//          both ways: m^2 samples everywhere are the full grid to the bit, if the shader has no
//          filter (else with FirstShade::kAgain).
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/image.h"

namespace plumb {

/// A sample to be shaded.
struct SampleToShade {
    int X = 0, Y = 0;  ///< Of the enlarged picture.
    int of_pixel = 1;  ///< Samples that its pixel is the mean of: what a texture filter needs.
};

/// Shades a batch: colours[i] of samples[i]. It is called from many threads at once.
using SampleShader =
    std::function<void(std::span<const SampleToShade> samples, std::span<Rgb> colours)>;

/// How the rest is gone through.
enum class RestOrder { kOneLoop, kByCount };

/// What the first sample of a pixel with more of them is.
enum class FirstShade {
    kReused,  ///< S as it is, the paper's way: shaded as if it were the only one.
    kAgain,   ///< Shaded again as one of k: dearer; the texture filter suits all alike.
};

struct RestOptions {
    RestOrder order = RestOrder::kOneLoop;
    FirstShade first = FirstShade::kReused;
};

/// S: number 0 of each window of a picture of w x h pixels. of_pixel is 1.
Image<Rgb> ShadeFirst(int width_px, int height_px, int m, const SampleShader& shader);

/// The picture: S and the samples that each pixel still needs. Throws Error if S and the counts are
/// not of one size or a count is not in [1, m^2].
Image<Rgb> ShadeRest(const Image<Rgb>& first, const Image<std::uint8_t>& counts, int m,
                     const SampleShader& shader, const RestOptions& options = {});

/// Every pixel with all its samples, each as one of m^2: the full ordered grid.
Image<Rgb> ShadeAll(int width_px, int height_px, int m, const SampleShader& shader);

}  // namespace plumb
