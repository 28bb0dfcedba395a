// How far the face normals that a depth buffer yields are from the true ones.
//
//       angle between NormalFromDepth (screen_space/depth_normal.h) and the face's own normal
//
// judged within faces only: where the pixel and both neighbours that its derivatives use show one
// triangle. Across edges the normal from depth belongs to neither surface.
//
// Source   figure 4 of [McGuire12]: "the peak error observed within a face was 0.2 degrees".
#pragma once

#include "core/image.h"
#include "screen_space/gbuffer.h"

namespace plumb {

/// Radians; NaN where nothing is judged. The size of the picture, border included.
Image<float> NormalErrorRad(const GBuffer& g);

}  // namespace plumb
