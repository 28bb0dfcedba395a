#include "techniques/filter_knobs.h"

#include "screen_space/sao/sao_presets.h"

namespace plumb {

BoundKnobs<SaoOptions> FilterKnobs() {
    using O = SaoOptions;
    BoundKnobs<O> knobs{
        Switch<O>(
            "packing", "A and depth are kept in 8-bit channels between the passes",
            [](auto& o) -> auto& { return o.pack_rgb8; }),
        Number<O>(
            "filter_z_min_m", "z_min", "m", {-1e9, -1e-3},
            "Depth from which on all is one for the filter",
            [](auto& o) -> auto& { return o.z_min_m; }),
        Whole<O>(
            "filter_taps", "R", "", {0, 6}, "Taps on each side",
            [](auto& o) -> auto& { return o.blur.taps_each_side; }),
        Whole<O>(
            "filter_stride_px", "", "px", {1, 64}, "From tap to tap",
            [](auto& o) -> auto& { return o.blur.stride_px; }),
        Number<O>(
            "filter_lift", "", "", {0, 10}, "Added to each weight but the middle's",
            [](auto& o) -> auto& { return o.blur.lift; }),
        Number<O>(
            "filter_sharpness", "e", "", {0, 1e9},
            "1 / e is the difference of z / z_min that stops the filter",
            [](auto& o) -> auto& { return o.blur.edge_sharpness; }),
        Number<O>(
            "filter_tiny", "", "", {0, 1}, "Added to the sum of weights",
            [](auto& o) -> auto& { return o.blur.tiny; }),
        Switch<O>(
            "filter_normals", "Weights fall with the angle of the normals",
            [](auto& o) -> auto& { return o.blur.normal_weight; }),
        Switch<O>(
            "filter_planes", "Weights fall with the distance from each other's plane",
            [](auto& o) -> auto& { return o.blur.plane_weight; }),
        Switch<O>(
            "filter_monotonic", "Weights never rise away from the middle",
            [](auto& o) -> auto& { return o.blur.monotonic; }),
        Number<O>(
            "filter_near_m2", "", "m^2", {1e-12, 1e12},
            "Below this squared distance planes do not count",
            [](auto& o) -> auto& { return o.blur.near_m2; }),
    };
    for (std::size_t k = 0; k < std::tuple_size_v<BlurKernel>; ++k) {
        const std::string number = std::to_string(k);
        knobs.push_back(Number<O>(
            "filter_g" + number, "g_" + number, "", {k == 0 ? 1e-6 : 0, 1e6},
            "Weight of the taps " + number + " strides away", [k](auto& o) -> auto& {
                return o.blur.kernel[k];
            }));
    }
    BoundKnob<O> both{SwitchCalled("filter", "Both filter passes"),
                      [](const O& o) { return o.blur_x || o.blur_y ? 1 : 0; },
                      [](O& o, double on) { o.blur_x = o.blur_y = on != 0; }};
    both.knob.covers = {"filter_x", "filter_y"};
    knobs.push_back(both);
    knobs.push_back(Switch<O>(
        "filter_x", "The bilateral filter along x", [](auto& o) -> auto& { return o.blur_x; }));
    knobs.push_back(Switch<O>(
        "filter_y", "The bilateral filter along y", [](auto& o) -> auto& { return o.blur_y; }));
    return knobs;
}

SaoOptions CommonFilter() {
    SaoOptions options = SaoSupplement2012();
    options.pack_rgb8 = false;
    return options;
}

void RunFilter(const GBuffer& gbuffer, const SaoOptions& filter, Image<float> A,
               const PassObserver& observer) {
    if (observer) observer("sample", A);
    if (!filter.blur_x && !filter.blur_y && !filter.pack_rgb8) return;
    SaoScratch scratch;
    scratch.A = std::move(A);
    RunSaoFilter(gbuffer, filter, scratch, observer);
}

}  // namespace plumb
