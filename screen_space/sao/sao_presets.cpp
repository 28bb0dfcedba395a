#include "screen_space/sao/sao_presets.h"

#include "core/names.h"
#include "screen_space/sao/alchemy_ao.h"

namespace plumb {

SaoOptions SaoPaper() {
    SaoOptions options;
    options.sampling.sao = {.falloff = SaoFalloffKind::kEquation1,
                            .radius_m = 1,
                            .bias_m = 0,
                            .bias_per_depth = 0.001,
                            .intensity = 1,
                            .epsilon_m2 = 0.01};
    options.sampling.taps = {.samples = 9,
                             .turns = 7,
                             .hash = HashReading::kCPrecedence,
                             .rounding = TapRounding::kSum};
    options.z_min_m = -200;
    options.blur = {.kernel = kBlurR3,
                    .taps_each_side = 3,
                    .stride_px = 3,
                    .lift = 0,
                    .edge_sharpness = 2048,
                    .tiny = 0};
    return options;
}

SaoOptions SaoSupplement2012() {
    SaoOptions options;
    options.sampling.sao = {.falloff = SaoFalloffKind::kSmooth,
                            .radius_m = 1,
                            .bias_m = 0.01,
                            .intensity = 1,
                            .epsilon_m2 = 0.01};
    options.sampling.taps = {.samples = 11,
                             .turns = 7,
                             .full_turn_rad = 6.28,
                             .hash = HashReading::kCode,
                             .phi = PhiArithmetic::kFloat32};
    options.z_min_m = -300;
    options.blur = {.kernel = kBlurStddev2, .taps_each_side = 4, .stride_px = 2};
    return options;
}

SaoOptions SaoG3d10() {
    SaoOptions options;
    options.sampling.sao = {.falloff = SaoFalloffKind::kHighQuality,
                            .radius_m = 0.75,
                            .bias_m = 0.023,
                            .intensity = 1,
                            .epsilon_m2 = 0.001};
    options.sampling.taps = {.samples = 19,
                             .full_turn_rad = 6.28,
                             .phi = PhiArithmetic::kFloat32,
                             .outside = TapOutside::kBorderDepth,
                             .filter = ZFilter::kRotatedGridG3d10,
                             .min_radius_px = 3,
                             .min_tap_px = 0.75};
    options.sampling.normals = NormalSource::kShading;
    options.sampling.steepest_area = 6e-5;  // for whoever sets normals to kDepth
    options.quad_filter = false;
    options.pack_rgb8 = false;
    options.z_min_m = -1000;
    options.blur = {.kernel = kBlurStddev2,
                    .taps_each_side = 4,
                    .stride_px = 2,
                    .normal_weight = true,
                    .plane_weight = true};
    return options;
}

std::vector<SaoPreset> SaoPresets() {
    return {{"paper", SaoPaper()},
            {"supplement2012", SaoSupplement2012()},
            {"g3d10", SaoG3d10()},
            {"alchemy", AlchemyAo()}};
}

SaoOptions SaoPresetNamed(const std::string& name) {
    const std::vector<SaoPreset> presets = SaoPresets();
    return FindNamed(
               presets, [](const SaoPreset& preset) { return preset.name; }, name,
               "preset \"" + name + "\"")
        .options;
}

}  // namespace plumb
