// The deterministic shading model: what a point looks like whose visibility is known.
//
//       L = rho ( A + Sum_i s_i E_i(x) max(0, <n, l_i>) )
//
//       A         mean radiance of the sky over all directions
//       E_i(x)    directional light: its irradiance;  point light: intensity / distance^2
//
// It has no noise and no filter of its own: whatever a picture of it has too much or too little
// of, its sampling is to blame. The path tracer's beauty image and the rasterizer's shading are
// both this.
//
// Symbols  rho albedo, n unit shading normal on the side seen, l_i unit vector to light i, s_i 0
//          or 1: whether light i reaches x. Irradiances are divided by pi (core/scene.h).
// Beware   Not what light does: no occlusion of the ambient part, no bounces. Light that comes
//          from infinitely near a point light counts as none.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/scene.h"

namespace plumb {

/// One light as a point of the scene has it, if nothing is in between.
struct LightAt {
    std::size_t number = 0;  ///< Directional lights first, then point lights.
    Vec3 towards{0, 0, 1};   ///< l_i, unit.
    double distance_m = std::numeric_limits<double>::infinity();
    std::array<double, 3> irradiance{};  ///< E_i: of a surface that faces the light.
};

/// sky radiance from direction w: the colour of the sky times its picture.
inline Rgb SkyRadiance(const SceneLight& light, const Vec3& w) {
    const Rgb of_picture = RadianceFrom(light.environment, w);
    Rgb out;
    for (std::size_t c = 0; c < 3; ++c) out[c] = light.sky[c] * of_picture[c];
    return out;
}

class ShadingModel {
  public:
    explicit ShadingModel(const SceneLight& light) : points_(light.points) {
        const Rgb mean = MeanRadiance(light.environment);
        for (std::size_t c = 0; c < 3; ++c) ambient_[c] = double(light.sky[c]) * mean[c];
        for (const DirectionalLight& of : light.directional) {
            directional_.push_back(
                {.number = directional_.size(),
                 .towards = of.towards.normalized(),
                 .irradiance = {of.irradiance[0], of.irradiance[1], of.irradiance[2]}});
        }
    }

    std::size_t Lights() const { return directional_.size() + points_.size(); }
    const std::array<double, 3>& Ambient() const { return ambient_; }  ///< A

    /// Light number i as x has it.
    LightAt Light(std::size_t i, const Vec3& x_m) const {
        if (i < directional_.size()) return directional_[i];
        const PointLight& of = points_[i - directional_.size()];
        const Vec3 to = of.position_m - x_m;
        LightAt at{.number = i, .distance_m = to.norm()};
        if (!(at.distance_m > kNearestM)) return at;
        at.towards = to / at.distance_m;
        for (std::size_t c = 0; c < 3; ++c) {
            at.irradiance[c] = of.intensity[c] / (at.distance_m * at.distance_m);
        }
        return at;
    }

    /// L. is_lit(LightAt) says s_i; it is asked only about lights in front of the surface.
    template <class IsLit>
    Rgb Shade(const Vec3& x_m, const Vec3& n, const Rgb& rho, const IsLit& is_lit) const {
        std::array<double, 3> sum = ambient_;
        for (std::size_t i = 0; i < Lights(); ++i) {
            const LightAt at = Light(i, x_m);
            const double cosine = n.dot(at.towards);
            if (!(cosine > 0) || !is_lit(at)) continue;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += at.irradiance[c] * cosine;
        }
        Rgb L;
        for (std::size_t c = 0; c < 3; ++c) L[c] = float(rho[c] * sum[c]);
        return L;
    }

  private:
    static constexpr double kNearestM = 1e-6;

    std::array<double, 3> ambient_{};
    std::vector<LightAt> directional_;
    std::vector<PointLight> points_;
};

}  // namespace plumb
