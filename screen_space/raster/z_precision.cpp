#include "screen_space/raster/z_precision.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/conventions.h"
#include "core/error.h"
#include "core/random.h"
#include "core/vec.h"

namespace plumb {
namespace {

template <class Real>
using Matrix = std::array<std::array<Real, 4>, 4>;
template <class Real>
using Vector = std::array<Real, 4>;

// Of a rigid motion or of a projection, in Real from beginning to end.
template <class Real>
Matrix<Real> Times(const Matrix<Real>& a, const Matrix<Real>& b) {
    Matrix<Real> out{};
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            for (std::size_t k = 0; k < 4; ++k) out[i][j] += a[i][k] * b[k][j];
        }
    }
    return out;
}

template <class Real>
Matrix<Real> Turn(double angle_rad, std::size_t axis) {
    const Real c = std::cos(Real(angle_rad)), s = std::sin(Real(angle_rad));
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Matrix<Real> out{};
    for (std::size_t i = 0; i < 4; ++i) out[i][i] = 1;
    out[u][u] = out[v][v] = c;
    out[u][v] = -s;
    out[v][u] = s;
    return out;
}

template <class Real>
Matrix<Real> Move(const Vec3& by) {
    Matrix<Real> out{};
    for (std::size_t i = 0; i < 4; ++i) out[i][i] = 1;
    for (std::size_t i = 0; i < 3; ++i) out[i][3] = Real(by[int(i)]);
    return out;
}

// One of many cameras and objects: the roundings of one matrix are the same for all its points,
// so many matrices tell more than many points.
struct Pose {
    Vec3 object_m, camera_m;
    std::array<double, 4> turns_rad;  // Object about z and x, camera about z and x.
};

Pose PoseNumber(int number, const ZStudySettings& s) {
    const auto random = [&](std::uint64_t dimension) {
        return 2 * RandomUnit(s.seed, ~std::uint64_t{0}, std::uint64_t(number), dimension) - 1;
    };
    const auto direction = [&](std::uint64_t dimension) -> Vec3 {
        const double z = random(dimension), phi = kPi * random(dimension + 1);
        const double r = std::sqrt(1 - z * z);
        return {r * std::cos(phi), r * std::sin(phi), z};
    };
    return {s.object_from_origin_m * direction(0),
            s.from_origin_m * direction(2),
            {kPi * random(4), kPi * random(5), kPi * random(6), kPi * random(7)}};
}

template <class Real>
Matrix<Real> ObjectToScene(const Pose& pose) {
    return Times(Move<Real>(pose.object_m),
                 Times(Turn<Real>(pose.turns_rad[0], 2), Turn<Real>(pose.turns_rad[1], 0)));
}

// The inverse of a motion: moved back, then turned back.
template <class Real>
Matrix<Real> SceneToCamera(const Pose& pose) {
    return Times(Times(Turn<Real>(-pose.turns_rad[3], 0), Turn<Real>(-pose.turns_rad[2], 2)),
                 Move<Real>(-pose.camera_m));
}

constexpr double kAspect = 16.0 / 9;

template <class Real>
Matrix<Real> Projection(const ZPipeline& p, const ZStudySettings& s) {
    const Real n = Real(s.near_m), f = Real(s.far_m);
    const Real cot = 1 / std::tan(Real(s.fov_rad) / 2);
    Matrix<Real> out{};
    out[0][0] = cot / Real(kAspect);
    out[1][1] = cot;
    out[3][2] = -1;
    Real& z = out[2][2];
    Real& one = out[2][3];
    if (p.format == DepthFormat::kD32FReversed) {
        z = p.far_is_infinite ? 0 : n / (f - n);
        one = p.far_is_infinite ? n : f * n / (f - n);
    } else if (p.clip == ClipRange::kMinusOneToOne) {
        z = p.far_is_infinite ? -1 : -(f + n) / (f - n);
        one = p.far_is_infinite ? -2 * n : -2 * f * n / (f - n);
    } else {
        z = p.far_is_infinite ? -1 : -f / (f - n);
        one = p.far_is_infinite ? -n : -f * n / (f - n);
    }
    return out;
}

Matrix<float> ToFloat(const Matrix<double>& m) {
    Matrix<float> out;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = 0; j < 4; ++j) out[i][j] = float(m[i][j]);
    }
    return out;
}
Matrix<float> ToFloat(const Matrix<float>& m) {
    return m;
}

// What the vertex shader gets: its matrices from left to right.
template <class Real>
std::vector<Matrix<float>> ShaderMatrices(const ZPipeline& p, const ZStudySettings& s,
                                          const Pose& pose) {
    const auto P = Projection<Real>(p, s);
    const auto V = SceneToCamera<Real>(pose);
    const auto O = ObjectToScene<Real>(pose);
    if (p.concatenated) return {ToFloat(Times(Times(P, V), O))};
    return {ToFloat(P), ToFloat(V), ToFloat(O)};
}

Vector<float> Apply(const Matrix<float>& m, const Vector<float>& v, ProductOrder order) {
    Vector<float> out;
    for (std::size_t i = 0; i < 4; ++i) {
        const float a = m[i][0] * v[0], b = m[i][1] * v[1], c = m[i][2] * v[2],
                    d = m[i][3] * v[3];
        out[i] = order == ProductOrder::kColumns ? ((a + b) + c) + d : (a + b) + (c + d);
    }
    return out;
}

// The stored depth as a shader reads it back.
float Store(const ZPipeline& p, const Vector<float>& clip) {
    const float ndc = clip[2] / clip[3];
    const bool gl =
        p.clip == ClipRange::kMinusOneToOne && p.format != DepthFormat::kD32FReversed;
    const float d = std::clamp(gl ? 0.5f * ndc + 0.5f : ndc, 0.f, 1.f);
    if (p.format == DepthFormat::kD32F || p.format == DepthFormat::kD32FReversed) return d;
    return float(DecodeDepth(p.format, EncodeDepth(p.format, 1 - double(d))));
}

Vec3 Apply(const Matrix<double>& m, const Vec3& v) {
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i) {
        out[int(i)] = m[i][0] * v.x() + m[i][1] * v.y() + m[i][2] * v.z() + m[i][3];
    }
    return out;
}

Matrix<double> InverseMotion(const Matrix<double>& m) {
    Matrix<double> out{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            out[i][j] = m[j][i];
            out[i][3] -= m[j][i] * m[j][3];
        }
    }
    out[3][3] = 1;
    return out;
}

class OfPose {
  public:
    OfPose(const ZPipeline& p, const ZStudySettings& s, const Pose& pose)
        : p_(p),
          matrices_(p.host == HostPrecision::kDouble ? ShaderMatrices<double>(p, s, pose)
                                                     : ShaderMatrices<float>(p, s, pose)),
          to_camera_(Times(SceneToCamera<double>(pose), ObjectToScene<double>(pose))),
          to_object_(InverseMotion(to_camera_)),
          range_{
              .near_m = s.near_m,
              .far_m = p.far_is_infinite ? std::numeric_limits<double>::infinity() : s.far_m},
          tan_half_(std::tan(s.fov_rad / 2)) {}

    /// Of a vertex at (x, y) in [-1, 1]^2 of the picture, t away. It is stored in the object's
    /// frame in float; that rounding is not counted.
    double ErrorM(double t_m, double x, double y) const {
        const Vec3 wanted(t_m * tan_half_ * kAspect * x, t_m * tan_half_ * y, -t_m);
        const Vec3f vertex = Apply(to_object_, wanted).cast<float>();
        Vector<float> v{vertex.x(), vertex.y(), vertex.z(), 1};
        for (auto m = matrices_.rbegin(); m != matrices_.rend(); ++m)
            v = Apply(*m, v, p_.order);
        return double(ReconstructZ(p_.format, range_, Store(p_, v))) -
               Apply(to_camera_, vertex.cast<double>()).z();
    }

  private:
    ZPipeline p_;
    std::vector<Matrix<float>> matrices_;
    Matrix<double> to_camera_, to_object_;
    DepthRange range_;
    double tan_half_;
};

}  // namespace

void Validate(const ZStudySettings& s) {
    const auto positive = [](const char* field, double value) {
        if (!(value > 0 && std::isfinite(value))) {
            throw Error(MustBe(field, value, "> 0 and finite"));
        }
    };
    positive("near_m", s.near_m);
    positive("last_m", s.last_m);
    if (!(s.first_m >= s.near_m)) throw Error(MustBe("first_m", s.first_m, ">= near_m"));
    if (!(s.last_m > s.first_m)) throw Error(MustBe("last_m", s.last_m, "> first_m"));
    if (!(s.far_m > s.last_m && std::isfinite(s.far_m))) {
        throw Error(MustBe("far_m", s.far_m, "> last_m and finite"));
    }
    if (!(s.fov_rad > 0 && s.fov_rad < kPi)) {
        throw Error(MustBe("fov_rad", s.fov_rad, "in (0, pi)"));
    }
    if (s.distances < 2) throw Error(MustBe("distances", s.distances, ">= 2"));
    if (s.points < 1) throw Error(MustBe("points", s.points, ">= 1"));
    if (s.poses < 1) throw Error(MustBe("poses", s.poses, ">= 1"));
    for (const auto& [field, value] :
         {std::pair{"from_origin_m", s.from_origin_m},
          std::pair{"object_from_origin_m", s.object_from_origin_m}}) {
        if (!(value >= 0 && std::isfinite(value))) {
            throw Error(MustBe(field, value, ">= 0 and finite"));
        }
    }
}

std::vector<ZError> MeasureZError(const ZPipeline& p, const ZStudySettings& s) {
    Validate(s);
    std::vector<ZError> errors(std::size_t(s.distances));
    for (int k = 0; k < s.distances; ++k) {
        errors[std::size_t(k)].t_m =
            s.first_m * std::pow(s.last_m / s.first_m, k / (s.distances - 1.0));
    }
    for (int number = 0; number < s.poses; ++number) {
        const OfPose pose(p, s, PoseNumber(number, s));
        for (int k = 0; k < s.distances; ++k) {
            ZError& error = errors[std::size_t(k)];
            for (int i = 0; i < s.points; ++i) {
                const auto random = [&](std::uint64_t dimension) {
                    return 2 * RandomUnit(s.seed, std::uint64_t(k),
                                          std::uint64_t(number) * s.points + i, dimension) -
                           1;
                };
                // Within 1 % of the distance, so that no depth is hit again and again.
                const double t = error.t_m * (1 + 0.01 * random(0));
                const double off = pose.ErrorM(t, random(1), random(2));
                error.mean_m += off;
                error.rms_m += off * off;
                error.worst_m = std::max(error.worst_m, std::abs(off));
            }
        }
    }
    for (ZError& error : errors) {
        const double points = double(s.poses) * s.points;
        error.mean_m /= points;
        error.rms_m = std::sqrt(error.rms_m / points);
    }
    return errors;
}

}  // namespace plumb
