// Signed errors as colours on one fixed scale, so that pictures of different techniques compare.
//
//       A - t = -0.25 and below: blue (too dark);  0: white;  +0.25 and above: red (too bright)
//
// linear between; the sky is grey.
#pragma once

#include "core/image.h"
#include "score/over_tiles.h"

namespace plumb {

inline constexpr double kSignedScale = 0.25;

Image<Rgb> SignedPicture(const Image<float>& A, const Image<float>& truth, const Mask& seen);

}  // namespace plumb
