// How exactly a camera's z comes back out of a depth buffer, for every way of getting it there.
//
//       clip = P V O v,    d = depth of clip_z / clip_w,    z(d) by [McGuire12 eq. 2]
//
// with P projection, V camera, O object. The error of z is measured for points all over the
// picture, distance by distance, against the same point in double: figure 3 of [McGuire12].
//
// Source   [McGuire12], section 2.1 and figure 3. The picture's numbers were not to be had; its
//          text says "worst-case error is on the order of 2mm".
// Symbols  t = -z distance from the camera's plane (m).
// Beware   Errors are of vertices: what interpolation adds is in jobs/screen_space/z_precision.h.
#pragma once

#include <cstdint>
#include <vector>

#include "screen_space/raster/z_pipeline.h"

namespace plumb {

struct ZStudySettings {
    double near_m = 0.1;               ///< n. > 0
    double far_m = 200;                ///< f, where it is not infinite. > last_m
    double first_m = 0.5;              ///< The nearest distance measured. >= near_m
    double last_m = 100;               ///< The farthest. > first_m
    int distances = 24;                ///< Evenly spaced in the logarithm. >= 2
    int poses = 100;                   ///< Of camera and object, at random. > 0
    int points = 20;                   ///< At each distance in each pose. > 0
    double from_origin_m = 30;         ///< Of the camera from the scene's origin. >= 0
    double object_from_origin_m = 10;  ///< Of the object's own origin. >= 0
    double fov_rad = 1;  ///< Of the picture's height; its width is 16/9 of that. (0, pi)
    std::uint64_t seed = 1;
};

/// Throws Error, naming field, value and rule.
void Validate(const ZStudySettings& settings);

struct ZError {
    double t_m = 0;
    double rms_m = 0, worst_m = 0, mean_m = 0;  ///< Of z - z_exact; the mean has a sign.
};

/// One a distance. Deterministic; poses * points * distances transforms.
std::vector<ZError> MeasureZError(const ZPipeline& pipeline, const ZStudySettings& settings);

}  // namespace plumb
