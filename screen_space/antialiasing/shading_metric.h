// Samples that a pixel needs by the shading around it: the range of luminance beside it.
//
//       k_s = 0      if r < max(t_min, l_max t_edge),   r = l_max - l_min   [Hollander13 eq. 4]
//       k_s = c r    otherwise
//
// over the four direct neighbours in the picture of one sample a pixel.
//
// Source   [Hollander13] section 3.1. Whether the pixel itself counts, the weights of luminance and
//          its encoding are not said: they are options. The thresholds are not given either: those
//          here are FXAA's, which the paper names as its model.
// Symbols  l luminance, c samples for a range of 1.
// Beware   Linear light may be above 1: then k_s may be above c. The border is repeated.
#pragma once

#include "core/image.h"
#include "screen_space/antialiasing/luma.h"

namespace plumb {

/// Whose luminance counts.
enum class ShadingNeighbours { kFour, kFourAndCentre };

/// Of which values.
enum class LuminanceEncoding {
    kLinear,  ///< As they are.
    kSrgb,    ///< Of each channel's sRGB value, clamped to [0, 1].
};

struct ShadingMetric {
    double c = 16;                  ///< Ours: as many as m = 4 has. >= 0
    double min_threshold = 0.0833;  ///< t_min. >= 0
    double edge_threshold = 0.166;  ///< t_edge. >= 0
    ShadingNeighbours neighbours = ShadingNeighbours::kFour;
    LumaWeights weights = LumaWeights::kRec709;
    LuminanceEncoding encoding = LuminanceEncoding::kLinear;

    friend bool operator==(const ShadingMetric&, const ShadingMetric&) = default;
};

/// Throws Error, naming field, value and rule.
void Validate(const ShadingMetric& metric);

/// k_s of every pixel, >= 0, from the picture with one sample a pixel.
Image<float> ShadingSamples(const Image<Rgb>& one_sample, const ShadingMetric& metric);

}  // namespace plumb
