// Luma: the brightness that the filters compare pixels by.
//
//       Rec. 601   0.299 R + 0.587 G + 0.114 B          FXAA
//       Rec. 709   0.2126 R + 0.7152 G + 0.0722 B       SMAA
//
// Beware   Luma is a weighted sum of *encoded* colours. Of linear ones the same sum is luminance.
#pragma once

#include "core/image.h"

namespace plumb {

enum class LumaWeights { kRec601, kRec709 };

/// Unitless, in [0, 1] for colours in [0, 1].
inline float Luma(LumaWeights weights, const Rgb& colour) {
    return weights == LumaWeights::kRec601
               ? 0.299f * colour[0] + 0.587f * colour[1] + 0.114f * colour[2]
               : 0.2126f * colour[0] + 0.7152f * colour[1] + 0.0722f * colour[2];
}

}  // namespace plumb
