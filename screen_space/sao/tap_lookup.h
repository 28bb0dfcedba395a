// From a tap of the disc to a depth: the disc's radius, the level to read and the texel in it.
//
//       r'  = -r S' / z_C                                           [McGuire12 eq. 5]
//       m_i = floor(log2(h_i / q')), in [0, coarsest]               [McGuire12 eq. 9]
//       z_i = z^m_i((x, y) + h_i u_i, each / 2^m_i)                 [McGuire12 eq. 10]
//
// Source   [McGuire12] section 2.3 and the listing below eq. 10.
// Symbols  r radius (m), S' pixels that 1 m covers at 1 m, z_C depth of the pixel (m, < 0), h_i
//          distance of the tap (px), q' a power of two (px), (x, y) the pixel.
// Beware   The text calls q' the radius at which the level changes; by the formula, and the code,
//          level 1 begins at 2 q'. Eq. 10 prints the division by 2^m outside of the brackets, which
//          would divide a depth: we divide the place, as the listing does. And the paper does not
//          say at which place in the picture the depth of a coarse texel is put (TapPlace).
#pragma once

#include "core/conventions.h"
#include "core/vec.h"
#include "screen_space/sao/rotation_hash.h"
#include "screen_space/sao/spiral_taps.h"
#include "screen_space/sao/z_pyramid.h"
#include "screen_space/view.h"

namespace plumb {

/// Which texel a tap between texels means. (x, y) is whole.
enum class TapRounding {
    kOffset,  ///< trunc(h u) + (x, y): towards the pixel. The shipped code.
    kSum,     ///< trunc(h u + (x, y)): to the left and up. The paper's listing.
};

/// Where in the picture the depth found is put, to make the point Q of it.
enum class TapPlace {
    kTexel,       ///< At the centre of the pixel that the tap met. The shipped code.
    kLevelTexel,  ///< At the centre of the coarse texel that was read.
    kTap,         ///< At (x + 1/2, y + 1/2) + h u, not rounded at all.
};

/// A tap that leaves the drawn picture reads the nearest pixel of its border ...
enum class TapOutside {
    kBorderPoint,  ///< ... and puts the depth there: a point that was drawn.
    kBorderDepth,  ///< ... and puts the depth where the tap went. G3D 10.
};

enum class TapPattern { kSpiral, kSunflower };

struct TapOptions {
    int samples = 11;  ///< s, taps a pixel. [1, 4096]
    int turns = 0;     ///< tau. [1, 65536]; 0 = SpiralTurns(samples)
    TapPattern pattern = TapPattern::kSpiral;
    double full_turn_rad = 2 * kPi;  ///< Of the spiral. [6, 7]; shipped: 6.28
    HashReading hash = HashReading::kCode;
    /// Added to x and y in the hash, so that pictures with other borders have one pattern where they
    /// are shown. [-16383, 16383], and x and y of what is computed in [0, 16384) with it.
    int hash_shift_px = 0;
    PhiArithmetic phi = PhiArithmetic::kExact;
    TapRounding rounding = TapRounding::kOffset;
    TapPlace place = TapPlace::kTexel;
    TapOutside outside = TapOutside::kBorderPoint;
    ZFilter filter = ZFilter::kRotatedGrid;
    int log2_switch_px = 3;  ///< log2 q'. [0, 14]; paper: 3 to 5 look alike
    int coarsest_level = 5;  ///< [0, 14]; 0 = no pyramid
    double min_radius_px =
        0;                  ///< Below it A = 1, from it to 1 px above it A fades in. [0, 1e3]
    double min_tap_px = 0;  ///< Least h. [0, 1e3]; G3D 10: 0.75
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const TapOptions& taps);

/// Tap i of the pattern, before it is turned.
UnitTap TapOf(const TapOptions& taps, int i);

/// r' of a pixel at depth z_C, at most kWidestPx: a disc wider than any picture.
inline constexpr double kWidestPx = 1 << 22;
double DiscRadiusPx(const View& view, double radius_m, double z_m);

/// m of a tap at a distance of h px; 0 below 2 q'.
int LevelOfTap(double h_px, int log2_switch_px, int coarsest);

/// Where a tap reads and where it puts what it read.
struct TapTexel {
    int level = 0, i = 0, j = 0;  ///< Texel (i, j) of the level.
    Vec2 place_px;                ///< Of Q in the picture.
};

/// Of the tap h u from the pixel (x, y).
TapTexel LookUpTap(const TapOptions& taps, const ZPyramid& pyramid, int x, int y, double h_px,
                   const Vec2& u);

}  // namespace plumb
