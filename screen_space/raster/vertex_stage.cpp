#include "screen_space/raster/vertex_stage.h"

#include <bit>
#include <cmath>
#include <string>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

constexpr double kFarthestM = 1e15;
constexpr std::int64_t kVerticesAtATime = 4096;

// Round to nearest, ties to even, for |x| < 2^31: the last bits of x + 1.5 2^52 are the whole
// number. A call of the C library would cost more than the rest of the vertex.
std::int32_t RoundToInt(double x) {
    return std::int32_t(std::bit_cast<std::int64_t>(x + 0x1.8p52));
}

ScreenVertex Place(const PictureMap& map, double near_m, const Vec3& P) {
    ScreenVertex vertex{.P = P, .at = {}, .outcode = 0};
    const double t = -P.z();
    // Half-spaces, so that they hold behind the camera too.
    const double x_t = map.k_x * P.x() + map.c_x * t, y_t = map.c_y * t - map.k_y * P.y();
    const auto bit = [](bool outside, std::uint32_t code) { return outside ? code : 0; };
    const bool reached = t >= near_m && x_t >= -kReachPx * t && y_t >= -kReachPx * t &&
                         x_t <= (map.width_px + kReachPx) * t &&
                         y_t <= (map.height_px + kReachPx) * t;
    vertex.outcode =
        bit(x_t < 0, outcode::kLeft) | bit(x_t > map.width_px * t, outcode::kRight) |
        bit(y_t < 0, outcode::kAbove) | bit(y_t > map.height_px * t, outcode::kBelow) |
        bit(t < near_m, outcode::kBeforeNear) | bit(!reached, outcode::kBeyondReach);
    if (reached) vertex.at = ToFixed(map, P);
    return vertex;
}

// The float path. The matrix is view and projection in one, made in double and rounded once;
// the vertex is multiplied and divided in float.
class FloatShader {
  public:
    FloatShader(const CameraFrame& frame, const Camera& camera, const DepthCurve& curve)
        : tan_x_(frame.tan_half_width), tan_y_(frame.tan_half_height), curve_(curve) {
        const Vec3& o = camera.position_m;
        Eigen::Matrix4d M;
        // Rows: x and y over the half angles, e t = a + b t, and t.
        M.row(0) << frame.right.transpose() / tan_x_, -frame.right.dot(o) / tan_x_;
        M.row(1) << frame.up.transpose() / tan_y_, -frame.up.dot(o) / tan_y_;
        M.row(3) << -frame.backward.transpose(), frame.backward.dot(o);
        M.row(2) = curve.b * M.row(3);
        M(2, 3) += curve.a;
        M_ = M.cast<float>();
    }

    Vec3 operator()(const Vec3f& v) const {
        float clip[4];
        for (int r = 0; r < 4; ++r) {
            clip[r] = M_(r, 0) * v.x() + M_(r, 1) * v.y() + M_(r, 2) * v.z() + M_(r, 3);
        }
        const float w = clip[3];
        const float x = clip[0] / w, y = clip[1] / w, e = clip[2] / w;
        const bool divided = w > 0 && std::isfinite(x) && std::isfinite(y) && std::isfinite(e);
        if (!divided) return {clip[0] * tan_x_, clip[1] * tan_y_, -w};
        // The depth is what a shader hands on, so it says where the point is.
        const double t = double(e) > curve_.b ? curve_.DistanceM(double(e)) : double(w);
        return {x * tan_x_ * t, y * tan_y_ * t, -t};
    }

  private:
    double tan_x_, tan_y_;
    DepthCurve curve_;
    Eigen::Matrix4f M_;
};

void CheckFinite(const Vec3f& v, std::int64_t index) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::abs(v[axis]) <= kFarthestM)) {
            throw Error(MustBe("mesh: vertices_m[" + std::to_string(index) + "]." + "xyz"[axis],
                               v[axis], "finite and at most 1e15 from 0"));
        }
    }
}

}  // namespace

FixedPoint ToFixed(const PictureMap& map, const Vec3& P) {
    const double per_t = -1 / P.z();
    return {RoundToInt(kSubPixels * (map.k_x * P.x() * per_t + map.c_x)),
            RoundToInt(kSubPixels * (map.c_y - map.k_y * P.y() * per_t))};
}

FixedPoint ToFixedWithinReach(const PictureMap& map, const Vec3& P) {
    const double per_t = -1 / P.z();
    // The order of arguments turns NaN into a number.
    const auto within = [](double px, int size_px) {
        return RoundToInt(
            kSubPixels * std::min(std::max(-double(kReachPx), px), double(size_px + kReachPx)));
    };
    return {within(map.k_x * P.x() * per_t + map.c_x, map.width_px),
            within(map.c_y - map.k_y * P.y() * per_t, map.height_px)};
}

void TransformVertices(const Mesh& mesh, const Camera& camera, const View& view,
                       const RasterOptions& options, std::vector<ScreenVertex>& out) {
    const CameraFrame frame(camera);
    const PictureMap map(view);
    const FloatShader shader(frame, camera, DepthCurve(options.range));
    Eigen::Matrix3d to_camera;
    to_camera << frame.right.transpose(), frame.up.transpose(), frame.backward.transpose();
    out.resize(mesh.vertices_m.size());
    ParallelFor(
        std::int64_t(out.size()), kVerticesAtATime, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                const Vec3f& v = mesh.vertices_m[std::size_t(i)];
                CheckFinite(v, i);
                const Vec3 P = options.vertices == VertexPath::kFloat
                                   ? shader(v)
                                   : Vec3(to_camera * (v.cast<double>() - camera.position_m));
                out[std::size_t(i)] = Place(map, options.range.near_m, P);
            }
        });
}

}  // namespace plumb
