// A ray caster that needs no tree: everything on one side of a tilted plane through the
// receiver is hidden. Its answers are known, so it tests what is made of the rays alone.
#pragma once

#include <algorithm>
#include <cmath>

#include "core/conventions.h"
#include "rays/ray_caster.h"
#include "tests/truth/shapes.h"

namespace plumb {

/// Hides the directions w of unit length with w . axis > c, `axis` horizontal.
class HalfHiddenCaster final : public RayCaster {
  public:
    HalfHiddenCaster(const Vec3& axis, double c) : axis_(axis.cast<float>()), c_(float(c)) {}

    void Closest(std::span<const Ray> rays, std::span<Hit> hits) const override {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            hits[i] = {};
            if (Hides(rays[i].direction)) hits[i] = {.triangle = 0, .t = 1};
        }
    }
    void Any(std::span<const Ray> rays, std::span<std::uint64_t> met) const override {
        std::ranges::fill(met, 0);
        for (std::size_t i = 0; i < rays.size(); ++i) Set(met, i, rays[i].direction);
    }
    void AnyFromPoint(const Ray&, std::span<const Vec3f> directions,
                      std::span<std::uint64_t> met) const override {
        std::ranges::fill(met, 0);
        for (std::size_t i = 0; i < directions.size(); ++i) Set(met, i, directions[i]);
    }
    GeometryCounts Counts() const override { return {}; }

    /// In the cosine-weighted hemisphere (w_x, w_y) is uniform over the disk, of which the
    /// segment beyond the chord at c is hidden.
    static double V(double c) {
        return 1 - (std::acos(c) - c * std::sqrt((1 - c) * (1 + c))) / kPi;
    }

    /// A level triangle to stand on.
    static Mesh Ground() {
        Mesh mesh;
        AddTriangle(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0});
        return mesh;
    }

  private:
    bool Hides(const Vec3f& w) const { return w.dot(axis_) > c_; }
    void Set(std::span<std::uint64_t> met, std::size_t i, const Vec3f& w) const {
        met[i / 64] |= std::uint64_t(Hides(w)) << (i % 64);
    }

    Vec3f axis_;
    float c_;
};

}  // namespace plumb
