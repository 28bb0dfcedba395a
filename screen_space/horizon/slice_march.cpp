#include "screen_space/horizon/slice_march.h"

#include <algorithm>
#include <string>

#include "core/error.h"

namespace plumb {

void Validate(const SliceSampling& sampling, const char* owner) {
    const auto in = [&](const char* field, double value, double least, double greatest,
                        const char* rule) {
        if (!(value >= least && value <= greatest))
            throw Error(MustBe(std::string(owner) + "::" + field, value, rule));
    };
    in("radius_m", sampling.radius_m, 1e-4, 1e7, "in [1e-4, 1e7]");
    in("slices", sampling.slices, 1, 4096, "in [1, 4096]");
    in("steps", sampling.steps, 1, 65536, "in [1, 65536]");
    in("step_power", sampling.step_power, 0.25, 8, "in [0.25, 8]");
}

SliceMarch::SliceMarch(const GBuffer& gbuffer, const SliceSampling& sampling)
    : gbuffer_(&gbuffer),
      sampling_(&sampling),
      width_(gbuffer.z_m.Width()),
      height_(gbuffer.z_m.Height()) {
    const View& view = gbuffer.view;
    for (int i = 0; i < width_; ++i) ray_x_.push_back(view.Point(i + 0.5, 0, -1).x());
    for (int j = 0; j < height_; ++j) ray_y_.push_back(view.Point(0, j + 0.5, -1).y());
    px_per_m_ = {view.width_px / (2 * view.tan_half_width),
                 -view.height_px / (2 * view.tan_half_height)};
}

bool SliceMarch::Receive(int x, int y) {
    const double z = gbuffer_->z_m(x, y);
    if (!(z < 0 && std::isfinite(z))) return false;
    const Vec3f& normal = sampling_->shading_normals ? gbuffer_->shading_normal(x, y)
                                                     : gbuffer_->face_normal(x, y);
    const double length = normal.cast<double>().norm();
    if (!(length > 0 && std::isfinite(length))) return false;
    n_ = normal.cast<double>() / length;
    C_ = PointAt(x, y, z);
    i_ = x;
    j_ = y;
    jitter_ = JitterOf(*sampling_, x, y, width_);
    return true;
}

Slice SliceMarch::SliceAt(double phi_rad) const {
    Slice slice;
    slice.V = -C_.normalized();
    Vec3 D(std::cos(phi_rad), std::sin(phi_rad), 0);
    if (sampling_->spread == SliceSpread::kLineOfSight) {
        const Vec3 e_1 = (Vec3::UnitX() - slice.V.x() * slice.V).normalized();
        slice.t = D.x() * e_1 + D.y() * slice.V.cross(e_1);
        D = (slice.t * slice.V.z() - slice.V * slice.t.z()).normalized();
    } else {
        slice.t = (D - D.dot(slice.V) * slice.V).normalized();
    }
    const Vec3 a = slice.V.cross(slice.t);
    const double n_a = n_.dot(a), n_t = n_.dot(slice.t), n_V = n_.dot(slice.V);
    const double L2 = n_t * n_t + n_V * n_V;
    slice.L = std::sqrt(L2);
    // A normal of a shading may point away from the eye: the slice sees it edge on.
    slice.gamma_rad = std::atan2(n_t, std::max(n_V, 0.0));
    // u has the parts -n_a n_t / L^2 along t and -n_a n_V / L^2 along V. Where the slice
    // hardly holds the normal its weight L is as little as the shear is steep: no shear then.
    const double shear = L2 > 1e-6 ? n_a / L2 : 0;
    slice.along = slice.t + shear * n_t * a;
    slice.up = slice.V + shear * n_V * a;
    slice.step_px = Vec2(D.x() * px_per_m_.x(), D.y() * px_per_m_.y()) / -C_.z();
    return slice;
}

}  // namespace plumb
