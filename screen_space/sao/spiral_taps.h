// Where a pixel's taps lie in its disc: a spiral of s taps and tau turns.
//
//       alpha_i = (i + 1/2) / s                                     [McGuire12 eq. 6]
//       h_i     = r' alpha_i,       theta_i = 2 pi alpha_i tau + phi
//       u_i     = (cos theta_i, sin theta_i)                        [McGuire12 eq. 7]
//
// Taps are as dense in h as in theta, so dense about the centre: the density per area is
// 1 / (2 pi h r'), not that of a disc sampled evenly.
//
// Source   [McGuire12 eq. 6]; tau for every s: the table of G3D 10, which minimizes the
//          discrepancy of the points (alpha_i, theta_i).
// Symbols  s number of taps, tau turns of the spiral, r' radius of the disc (px), h_i distance of
//          tap i from the pixel (px), theta_i its angle, phi the pixel's own angle.
// Beware   tau and -tau modulo s are mirror images. The paper's pair (9, 7) is the table's (9, 2)
//          mirrored; the shipped pair (11, 7) is (11, 4) mirrored, and not the table's (11, 3).
//          The shipped shaders write 6.28 for 2 pi.
#pragma once

namespace plumb {

/// tau for s taps: coprime with s for s in [1, 99]; the prime 5779 from 100 on.
int SpiralTurns(int samples);

struct UnitTap {
    double alpha = 0;      ///< Distance from the centre, as a share of the disc's radius.
    double angle_rad = 0;  ///< Before the pixel's own angle is added.
};

/// Tap i of [0, s). `full_turn_rad` stands for 2 pi.
UnitTap SpiralTap(int i, int samples, int turns, double full_turn_rad);

/// Tap i of [0, s) of a pattern that is even over the disc's area: the sunflower, alpha =
/// sqrt((i + 1/2) / s), each tap a golden angle on from the last.
UnitTap SunflowerTap(int i, int samples);

}  // namespace plumb
