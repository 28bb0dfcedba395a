#include "screen_space/raster/raster_options.h"

#include "core/error.h"

namespace plumb {

constexpr int kLargest = 16384;

void Validate(const RasterOptions& options) {
    Validate(options.range);
    if (options.guard_px < 0 || options.guard_px > kLargest) {
        throw Error(MustBe("guard_px", options.guard_px, "in [0, 16384]"));
    }
}

View ViewOf(const Camera& camera, int guard_px) {
    Validate(camera);
    const CameraFrame frame(camera);
    const View view{.width_px = camera.width_px,
                    .height_px = camera.height_px,
                    .guard_px = guard_px,
                    .tan_half_width = frame.tan_half_width,
                    .tan_half_height = frame.tan_half_height};
    if (view.DrawnWidth() > kLargest) {
        throw Error(MustBe("width_px with its border", view.DrawnWidth(), "at most 16384"));
    }
    if (view.DrawnHeight() > kLargest) {
        throw Error(MustBe("height_px with its border", view.DrawnHeight(), "at most 16384"));
    }
    return view;
}

}  // namespace plumb
