// The cosine-weighted integral over a slice of the hemisphere, closed.
//
//       a(h, gamma) = Int_0^h cos(th - gamma) |sin th| dth          h of either sign
//                   = 1/4 ( -cos(2h - gamma) + cos(gamma) + 2 h sin(gamma) )
//
//       open slice  a(gamma - pi/2, gamma) + a(gamma + pi/2, gamma) = cos(gamma) + gamma sin(gamma)
//
// Source   [Jimenez16] J. Jimenez et al., Practical Real-Time Strategies for Accurate Indirect
//          Occlusion, 2016: its inner integral.
// Symbols  th angle from the line of sight within the slice, gamma that of the normal
//          projected into the slice, h that of the horizon; all signed, in radians.
#pragma once

#include <cmath>

namespace plumb {

inline double SliceIntegral(double h_rad, double gamma_rad) {
    return (-std::cos(2 * h_rad - gamma_rad) + std::cos(gamma_rad) +
            2 * h_rad * std::sin(gamma_rad)) /
           4;
}

inline double OpenSlice(double gamma_rad) {
    return std::cos(gamma_rad) + gamma_rad * std::sin(gamma_rad);
}

}  // namespace plumb
