// FXAA 3.11, its quality path: blends across the edges that it finds in the luma of a picture.
//
//       unchanged if  max - min < max(t_min, t max)      of M, N, S, W, E
//       out = picture at the pixel moved by max(offset, H) towards the far side of the edge
//
//       offset = 1/2 - d / (d_- + d_+)   d = min(d_-, d_+); 0 if the near end bends the other way
//       H      = s F^2,  F = C^2 (3 - 2 C),  C = min(1, |B| / (max - min))
//       B      = (2 (N + S + W + E) + NW + NE + SW + SE) / 12 - M
//
// The span of the edge is horizontal where the second differences across rows are the larger ones;
// its side is that of the greater step. Its ends d_-, d_+ are sought along the line between the two
// rows (columns): where luma leaves the edge's own by a quarter of the step.
//
// Source   [Lottes09] T. Lottes, FXAA; the steps, presets and defaults of version 3.11.
// Symbols  M, N, ... luma of the pixel and its neighbours, t edge threshold, t_min its floor, s the
//          share of sub-pixel smoothing; d in pixels.
// Domain   Colours as displayed, in [0, 1]: after tone mapping. The border is repeated.
// Beware   A pixel without contrast stays as it is even if t_min = 0; the shader would divide 0 by
//          0. On linear colours the sum of luma is not what the eye sees: see FxaaLuma.
#pragma once

#include <string>
#include <vector>

#include "core/image.h"

namespace plumb {

/// What edges are sought in.
enum class FxaaLuma {
    kRec601,        ///< Of encoded colours.
    kRootOfLinear,  ///< The square root of the sum: for linear colours.
    kGreen,         ///< Green alone, "GREEN_AS_LUMA": red and blue edges stay.
};

struct FxaaOptions {
    double subpix = 0.75;                ///< s. [0, 1]
    double edge_threshold = 0.166;       ///< t. >= 0
    double edge_threshold_min = 0.0833;  ///< t_min. >= 0
    FxaaLuma luma = FxaaLuma::kRec601;
    /// Steps of the search for the ends, added up. The last one is taken without looking: an end
    /// not found before it is where it leads. At least two, each > 0.
    std::vector<double> steps_px = {1, 1.5, 2, 4, 12};

    friend bool operator==(const FxaaOptions&, const FxaaOptions&) = default;
};

/// Throws Error, naming field, value and rule.
void Validate(const FxaaOptions& options);

/// The picture filtered. Cost: nine luma reads a pixel; at edges two for each step and side.
Image<Rgb> FxaaFiltered(const Image<Rgb>& picture, const FxaaOptions& options = {});

struct FxaaPreset {
    std::string name;  ///< "10" to "15", "20" to "29", "39"
    FxaaOptions options;
};

/// As published, defaults but for the steps. "12" is the default.
std::vector<FxaaPreset> FxaaPresets();

/// Throws Error, with the names there are, for any other name.
FxaaOptions FxaaPresetNamed(const std::string& name);

}  // namespace plumb
