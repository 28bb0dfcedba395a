// Triangles that reach before the near plane or beyond the reach of fixed-point coordinates, cut
// to what can be drawn.
//
// One plane after the other (Sutherland and Hodgman), in the camera's frame. A cut is computed
// from the point inside towards the point outside, so two triangles that share an edge cut it
// at the same point and no crack opens.
//
// Source   I. Sutherland, G. Hodgman, Reentrant Polygon Clipping, 1974.
#pragma once

#include <array>
#include <span>

#include "core/vec.h"
#include "screen_space/raster/vertex_stage.h"

namespace plumb {

/// A convex polygon. Each of the five planes adds one corner to a triangle's three; where rounding
/// lets a corner cross twice, at most half as many again: 3, 4, 6, 9, 13, 19.
struct ClippedPolygon {
    std::array<Vec3, 19> corners;
    int size = 0;

    std::span<const Vec3> Corners() const { return {corners.data(), std::size_t(size)}; }
};

/// What is left of the triangle; size 0 if nothing.
ClippedPolygon ClipTriangle(const std::array<Vec3, 3>& corners, const PictureMap& map,
                            double near_m);

}  // namespace plumb
