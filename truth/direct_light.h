// D(x): the light that reaches points of surfaces straight from the lights of a scene.
//
//       D(x) = Sum_i s_i E_i(x) max(0, <n, l_i>)
//
// Shadow rays of many points go to the caster together. A shadow ray to a point light ends just
// before the light.
//
// Symbols  as in truth/irradiance.h.
#pragma once

#include <array>
#include <vector>

#include "core/shading.h"
#include "rays/ray_caster.h"

namespace plumb {

class DirectLight {
  public:
    DirectLight(const RayCaster& caster, const ShadingModel& lights)
        : caster_(caster), lights_(lights) {}

    /// Asks what reaches the point that `start` leaves (its direction is of no matter), with
    /// the unit normal n. The answer is number `Asked() - 1`.
    void Ask(const Ray& start, const Vec3& n);
    std::size_t Asked() const { return asked_; }

    /// D of every point asked about since the last call, in their order.
    const std::vector<std::array<double, 3>>& Answer();

  private:
    struct Pending {
        std::size_t point;
        std::array<double, 3> light;
    };

    const RayCaster& caster_;
    const ShadingModel& lights_;
    std::size_t asked_ = 0;
    std::vector<Ray> rays_;
    std::vector<Pending> pending_;
    std::vector<std::uint64_t> met_;
    std::vector<std::array<double, 3>> answer_;
};

/// The ray from a point that `start` leaves to a light: it ends just before a point light.
Ray ShadowRay(Ray start, const LightAt& light);

}  // namespace plumb
