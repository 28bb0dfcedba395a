// What the centre of each pixel shows: the truth of a G-buffer, and the receivers of its light.
//
// One ray a pixel, without jitter; the point is taken again from the triangle in double.
#pragma once

#include <cstdint>
#include <vector>

#include "core/image.h"
#include "core/scene.h"
#include "rays/ray_caster.h"
#include "truth/receiver.h"

namespace plumb {

struct PixelGeometry {
    /// Distance from the camera's plane; infinite where the sky is seen.
    Image<float> depth_m;
    /// In the camera's frame (x right, y up, looking along -z); 0 where the sky is seen.
    Image<Vec3f> position_m;
    /// Unit, on the side seen, in the camera's frame; 0 where the sky is seen.
    Image<Vec3f> normal;
    Image<Rgb> albedo;              ///< 0 where the sky is seen.
    Image<std::uint32_t> triangle;  ///< Hit::kNone where the sky is seen.

    /// The points seen, row after row, and their pixels (row * width + column).
    std::vector<Receiver> receivers;
    std::vector<std::uint32_t> pixel_of_receiver;

    std::int64_t seen_from_behind = 0;  ///< Pixels that show the back of a face.
};

/// Camera number `camera` of the scene, whose mesh the caster holds.
PixelGeometry LookThrough(const RayCaster& caster, const Scene& scene, const Camera& camera);

/// Share of the directions from a point, even over the sphere, in which a face's back is met
/// first: 1 inside a body whose faces look outward.
double ShareOfBacksAround(const RayCaster& caster, const Mesh& mesh, const Vec3& point_m);

}  // namespace plumb
