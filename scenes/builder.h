// How generators put a scene together: sheets, boxes and bodies of revolution.
//
// Faces are quads, counter-clockwise seen from their front. Sheets are cut as finely as the
// caller says: a shared vertex list within a sheet, none between sheets.
#pragma once

#include <functional>
#include <string>

#include "core/scene.h"

namespace plumb {

class SceneBuilder {
  public:
    explicit SceneBuilder(std::string name) { scene_.name = std::move(name); }

    /// Faces from now on are made of this.
    void Use(const std::string& name, const Rgb& albedo);

    void Quad(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
    void Triangle(const Vec3& a, const Vec3& b, const Vec3& c);

    /// n x m quads of the points f(i / n, j / m); the front is on the side of df/du x df/dv.
    void Sheet(int n, int m, const std::function<Vec3(double u, double v)>& f);

    /// A flat sheet from `corner` along `u` and `v`.
    void Rectangle(const Vec3& corner, const Vec3& u, const Vec3& v, int n = 1, int m = 1);

    /// Six sides seen from outside.
    void Box(const Vec3& low, const Vec3& high);

    /// About the vertical through `foot`: radius(v) at height(v), v from 0 to 1 upwards.
    void Revolve(const Vec3& foot, int segments, int rings,
                 const std::function<double(double v)>& radius,
                 const std::function<double(double v)>& height);

    void Ball(const Vec3& centre, double radius_m, int rings);

    void AddCamera(const std::string& name, const Vec3& position_m, const Vec3& target_m,
                   double fov_deg);
    SceneLight& Light() { return scene_.light; }

    /// Validates. The builder is empty afterwards.
    Scene Finish();

  private:
    void AddFace(const std::array<std::uint32_t, 4>& face);
    std::uint32_t AddVertex(const Vec3& p);

    Scene scene_;
};

}  // namespace plumb
