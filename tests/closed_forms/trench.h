// Trenches: endless along y, exact visibility along the cross-section.
//
// V-groove of two faces of length 1 with opening angle phi, at distance s from the apex:
//
//       V     = 1/2 (1 - (cos phi - s) / sqrt(s^2 + 1 - 2 s cos phi))
//       alpha = atan2(sin phi, cos phi - s) / pi            mean of V over a face: sin(phi / 2)
//
// Trench of width w and depth d, on the floor at distance t from one wall, and on a wall at
// depth z:
//
//       V_floor = 1/2 ((w - t) / sqrt((w - t)^2 + d^2) + t / sqrt(t^2 + d^2))
//       alpha_floor = (atan((w - t) / d) + atan(t / d)) / pi
//       V_wall  = 1/2 (1 - z / sqrt(z^2 + w^2))         alpha_wall = 1/2 - atan(z / w) / pi
//
// Source   derived from V = (sin a_1 + sin a_2) / 2 for a sky strip between the angles -a_1 and
//          a_2 from the normal, and alpha = (a_1 + a_2) / pi, in the cross-section of anything
//          endless.
// Symbols  lengths in metres (or any one unit), angles in radians.
#pragma once

#include <cmath>

#include "core/conventions.h"
#include "core/visibility.h"

namespace plumb {

inline CosineVisibility GrooveVisibility(double phi_rad, double s) {
    const double c = std::cos(phi_rad);
    return CosineVisibility((1 - (c - s) / std::sqrt(s * s + 1 - 2 * s * c)) / 2);
}
inline UniformVisibility GrooveUniformVisibility(double phi_rad, double s) {
    return UniformVisibility(std::atan2(std::sin(phi_rad), std::cos(phi_rad) - s) / kPi);
}
inline double GrooveFaceMeanVisibility(double phi_rad) {
    return std::sin(phi_rad / 2);
}

inline CosineVisibility TrenchFloorVisibility(double w_m, double d_m, double t_m) {
    return CosineVisibility(
        ((w_m - t_m) / std::hypot(w_m - t_m, d_m) + t_m / std::hypot(t_m, d_m)) / 2);
}
inline UniformVisibility TrenchFloorUniformVisibility(double w_m, double d_m, double t_m) {
    return UniformVisibility((std::atan((w_m - t_m) / d_m) + std::atan(t_m / d_m)) / kPi);
}
inline CosineVisibility TrenchWallVisibility(double w_m, double z_m) {
    return CosineVisibility((1 - z_m / std::hypot(z_m, w_m)) / 2);
}

}  // namespace plumb
