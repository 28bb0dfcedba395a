#include "core/camera.h"

#include "core/conventions.h"
#include "core/error.h"

namespace plumb {

namespace {

constexpr double kFarthestM = 1e15;  // As for vertices: beyond it squares overflow in float.

}  // namespace

void Validate(const Camera& camera, const std::string& name) {
    const auto finite = [&](const Vec3& v, const char* field) {
        for (int axis = 0; axis < 3; ++axis) {
            if (!(std::abs(v[axis]) <= kFarthestM)) {
                throw Error(MustBe(name + "." + field + "[" + std::to_string(axis) + "]",
                                   v[axis], "finite and at most 1e15 from 0"));
            }
        }
    };
    finite(camera.position_m, "position");
    finite(camera.target_m, "target");
    finite(camera.up, "up");
    if (!(camera.fov_rad > 0 && camera.fov_rad < kPi)) {
        throw Error(MustBe(name + ".fov_deg", camera.fov_rad * 180 / kPi, "in (0, 180)"));
    }
    for (const auto& [field, size] :
         {std::pair{".width_px", camera.width_px}, std::pair{".height_px", camera.height_px}}) {
        if (size < 1 || size > 65536) throw Error(MustBe(name + field, size, "in [1, 65536]"));
    }
    const double pixels = double(camera.width_px) * camera.height_px;
    if (pixels > double(std::int64_t{1} << 28)) {
        throw Error(MustBe(name + ": width_px x height_px", pixels, "at most 2^28"));
    }
    const Vec3 sight = camera.target_m - camera.position_m;
    if (!(sight.norm() > 0)) {
        throw Error(name + ".target is the position, must be another point");
    }
    if (!(sight.normalized().cross(camera.up).norm() > 1e-9 * camera.up.norm())) {
        throw Error(name + ".up is along the line of sight or zero, must not be");
    }
}

}  // namespace plumb
