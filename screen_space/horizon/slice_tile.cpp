#include "screen_space/horizon/slice_tile.h"

#include <cmath>
#include <numbers>

namespace plumb {

SliceTask::SliceTask(const GBuffer& of, const SliceSampling& options)
    : gbuffer(&of), sampling(options), width(of.z_m.Width()), height(of.z_m.Height()) {
    const View& view = of.view;
    // View::Point, solved for x / z and y / z.
    a_x = float(-2 * view.tan_half_width / view.width_px);
    b_x = float(view.tan_half_width * (1 + 2.0 * view.guard_px / view.width_px));
    a_y = float(2 * view.tan_half_height / view.height_px);
    b_y = float(-view.tan_half_height * (1 + 2.0 * view.guard_px / view.height_px));
    px_x = float(view.width_px / (2 * view.tan_half_width));
    px_y = float(-view.height_px / (2 * view.tan_half_height));
    for (int k = 0; k < options.slices; ++k) {
        cosine.push_back(float(std::cos(std::numbers::pi * k / options.slices)));
        sine.push_back(float(std::sin(std::numbers::pi * k / options.slices)));
    }
}

}  // namespace plumb
