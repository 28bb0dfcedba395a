#include "screen_space/sao/alchemy_ao.h"

namespace plumb {

SaoOptions AlchemyAo() {
    SaoOptions options;
    options.sampling.sao = {.falloff = SaoFalloffKind::kEquation1,  // [McGuire12 eq. 1]
                            .radius_m = 1,
                            .bias_m = 0,
                            .bias_per_depth = 0.001,
                            .intensity = 1,
                            .epsilon_m2 = 0.01};
    options.sampling.taps = {.samples = 12,
                             .pattern = TapPattern::kSunflower,
                             .hash = HashReading::kCPrecedence,
                             .coarsest_level = 0};
    options.sampling.normals = NormalSource::kFace;
    options.quad_filter = false;
    options.pack_rgb8 = false;
    options.z_min_m = -200;
    options.blur = {.kernel = kBlurStddev3,
                    .taps_each_side = 6,
                    .stride_px = 1,
                    .lift = 0,
                    .edge_sharpness = 2048,
                    .tiny = 0};
    return options;
}

}  // namespace plumb
