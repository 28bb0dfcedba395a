// Depth as a shader reads it out of a depth buffer of some format.
//
//       z' = z( rounded( e(-z) ) )        e, z(d) and the rounding as in depth_format.h
//
// Source   [McGuire12] section 2.1: what the precision of the depth buffer does to SAO.
// Symbols  z depth of the surface (m, < 0), z' what is read.
// Beware   Rounded once, from z as exact as a float: what the way from the vertex to the buffer
//          loses besides is plumb's z-precision study (z_precision.h). What is nearer than the
//          near plane reads as if it were there; where the buffer holds what an empty one holds,
//          the sky is read.
#pragma once

#include "core/image.h"
#include "screen_space/gbuffer.h"

namespace plumb {

enum class DepthRead {
    kSurface,  ///< z itself, a float.
    kD16,
    kD24,
    kD32F,
    kD32FReversed,
};

/// z' of all pixels. `read` is not kSurface.
Image<float> DepthAsRead(const Image<float>& z_m, const DepthRange& range, DepthRead read);

}  // namespace plumb
