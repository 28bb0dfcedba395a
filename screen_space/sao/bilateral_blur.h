// The bilateral reconstruction: A smoothed along one axis, but not across edges of depth.
//
//       A'  =  (g_0 A + Sum_k w_k A_k) / (g_0 + Sum_k w_k + tiny),       k = -R .. R, k != 0
//       w_k =  (lift + g_|k|) max(0, 1 - e |key_k - key|)  [normal] [plane]
//
//       normal:  max(0, n.n_k)
//       plane:   max(0, 1 - 2 d / |C - C_k|)^2,    d = max(|(C - C_k).n|, |(C - C_k).n_k|);
//                1 where |C - C_k|^2 < 0.001 m^2
//
// Source   [McGuire12] section 2.4; lift, tiny and the arrays g: the shaders of its supplement and
//          of G3D 10; the normal's and the plane's weight: G3D 10.
// Symbols  A_k, key_k, n_k, C_k: obscurance, key z / z_min, normal and point of the pixel k strides
//          away; R taps on each side; e edge sharpness, 1 / e the difference of keys that stops it.
// Domain   A tap beyond the picture is left out. Where the key is 1 (the sky, and all beyond
//          z_min) A stays.
// Beware   As shipped (lift 0.3) the kernel is no Gaussian: of R = 4 the centre has 4.5 % of the
//          weight and each next tap 13.1 %. And a constant 1 does not stay 1 (tiny = 1e-4).
//          The points C_k are made of the key, as G3D 10 does: of a packed key they are off.
// Cost     2 R + 1 taps a pixel.
#pragma once

#include <array>

#include "core/image.h"
#include "core/vec.h"
#include "screen_space/pixel_rect.h"
#include "screen_space/view.h"

namespace plumb {

/// g_0 .. g_6, as published; not normalized.
using BlurKernel = std::array<double, 7>;
inline constexpr BlurKernel kBlurR3{0.356642, 0.239400, 0.072410, 0.009869};
inline constexpr BlurKernel kBlurStddev1{0.398943, 0.241971, 0.053991, 0.004432, 0.000134};
inline constexpr BlurKernel kBlurStddev2{0.153170, 0.144893, 0.122649, 0.092902, 0.062970};
inline constexpr BlurKernel kBlurStddev3{0.111220, 0.107798, 0.098151, 0.083953,
                                         0.067458, 0.050920, 0.036108};

struct BlurOptions {
    BlurKernel kernel = kBlurStddev2;
    int taps_each_side = 4;        ///< R. [0, 6]; 0 = A as it is
    int stride_px = 2;             ///< [1, 64]
    double lift = 0.3;             ///< Added to each g but the centre's. [0, 10]
    double edge_sharpness = 2000;  ///< e, per unit of key. [0, 1e9]
    double tiny = 1e-4;            ///< Added to the sum of weights. [0, 1]
    bool normal_weight = false;
    bool plane_weight = false;
    bool monotonic =
        false;  ///< The part of w after (lift + g) never rises away from the centre.
    double near_m2 = 0.001;  ///< Below this |C - C_k|^2 no plane weight. [1e-12, 1e12]
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const BlurOptions& options);

enum class BlurAxis { kX, kY };

/// What a filter needs of the pixels besides A.
struct BlurGuide {
    Image<float> key;                      ///< z / z_min in [0, 1].
    const Image<Vec3f>* normal = nullptr;  ///< For both weights; what is not a number weighs 0.
    View view{};                           ///< For plane_weight.
    double z_min_m = -300;                 ///< Depth of key 1.
};

/// A' within `where`, A elsewhere.
Image<float> BlurredAlong(BlurAxis axis, const Image<float>& A, const BlurGuide& guide,
                          const BlurOptions& options, const PixelRect& where);

/// A' of one pixel, in double: what BlurredAlong is compared with.
double BlurredPixel(BlurAxis axis, const Image<float>& A, const BlurGuide& guide,
                    const BlurOptions& options, int x, int y);

}  // namespace plumb
