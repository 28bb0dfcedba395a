#include "truth/direct_light.h"

namespace plumb {

Ray ShadowRay(Ray start, const LightAt& light) {
    start.direction = light.towards.cast<float>();
    // A lamp's own surface must not shade it, nor the rounding of where the ray starts.
    constexpr double kShort = 1 - 1e-5;
    start.far = float(kShort * light.distance_m);
    return start;
}

void DirectLight::Ask(const Ray& start, const Vec3& n) {
    const Vec3 x_m = start.origin_m.cast<double>();
    for (std::size_t i = 0; i < lights_.Lights(); ++i) {
        const LightAt light = lights_.Light(i, x_m);
        const double cosine = n.dot(light.towards);
        if (!(cosine > 0)) continue;
        Pending pending{.point = asked_, .light = light.irradiance};
        for (double& colour : pending.light) colour *= cosine;
        rays_.push_back(ShadowRay(start, light));
        pending_.push_back(pending);
    }
    ++asked_;
}

const std::vector<std::array<double, 3>>& DirectLight::Answer() {
    answer_.assign(asked_, {0, 0, 0});
    met_.resize(BitWords(rays_.size()));
    caster_.Any(rays_, met_);
    for (std::size_t i = 0; i < rays_.size(); ++i) {
        if ((met_[i / 64] >> (i % 64)) & 1) continue;
        for (std::size_t c = 0; c < 3; ++c) {
            answer_[pending_[i].point][c] += pending_[i].light[c];
        }
    }
    asked_ = 0;
    rays_.clear();
    pending_.clear();
    return answer_;
}

}  // namespace plumb
