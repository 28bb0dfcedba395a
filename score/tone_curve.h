// How a picture of high dynamic range is shown on a screen, and with which exposures.
//
//       ACES, Hable   T(x) = (k0 x^2 + k1 x + k2) / (k3 x^2 + k4 x + k5)      per channel
//       Reinhard      T(c) = c / (1 + Y),   Y = 0.2126 R + 0.7152 G + 0.0722 B
//
//       start = log2(x / Y_max),   stop = log2(x / Y_median),   T(x) = 0.85
//       exposures: max(2, ceil(stop - start)) of them, evenly from start to stop
//
// From the exposure at which the brightest pixel is 0.85 bright to the one at which the median is.
//
// Source   [Andersson21] sections 3.1 and 3.2; the curves as its program has them.
// Symbols  Y luminance of a pixel of the reference, x the brightness that is shown as 0.85.
// Domain   Colours finite and >= 0.
// Beware   Where the median is 0 (a picture mostly black, a mask) `stop` would be infinite, and the
//          published program does not end. Here the median is then that of the pixels with Y > 0,
//          and ToneExposures::median_of_positive says so.
#pragma once

#include <string>
#include <vector>

#include "core/image.h"
#include "score/over_tiles.h"

namespace plumb {

enum class ToneCurve { kAces, kHable, kReinhard };

/// "aces", "hable", "reinhard", in the order of the enumerators.
const std::vector<std::string>& ToneCurveNames();

/// The colour as it is shown, not yet clamped.
Rgb Shown(ToneCurve curve, const Rgb& linear);

/// The larger x with T(x) = 0.85.
double BrightestShown(ToneCurve curve);

struct ToneExposures {
    double start_stops = 0, stop_stops = 0;  ///< Pictures are multiplied by 2^stops.
    int count = 2;
    bool median_of_positive = false;

    double At(int k) const {
        return start_stops + (stop_stops - start_stops) * k / (count - 1);
    }
};

/// The exposures for these two luminances, 0 < median <= max.
ToneExposures ExposuresBetween(ToneCurve curve, double median, double max);

/// Those of a reference, over the pixels of `mask` (empty: all). The median is element n / 2 of the
/// n sorted luminances. Throws Error if no luminance is positive.
ToneExposures ExposuresOf(ToneCurve curve, const Image<Rgb>& reference, const Mask& mask = {});

}  // namespace plumb
