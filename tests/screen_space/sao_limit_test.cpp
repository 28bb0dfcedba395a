// What SAO tends to as its taps and its pixels grow in number: its own integral over the disc,
//
//       A = 1 - c  Int_0^1 d alpha  1/(2 pi) Int_0^2pi d theta  f(v(alpha r', theta)),
//
// by a quadrature in double that shares no code with the taps, on the shape itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "screen_space/sao/obscurance_pass.h"
#include "tests/screen_space/made_gbuffers.h"

namespace plumb {
namespace {

// Written out here once more, on purpose.
struct Estimator {
    SaoParams params;

    double f(const Vec3& v, const Vec3& n, double z_C) const {
        const double vv = v.dot(v), vn = v.dot(n), r2 = params.radius_m * params.radius_m;
        if (params.falloff == SaoFalloffKind::kEquation1) {
            return std::fmax(0, vn + z_C * params.bias_per_depth) / (vv + params.epsilon_m2);
        }
        const double inside = std::fmax(0, r2 - vv);
        return inside * inside * inside * std::fmax(0, vn - params.bias_m) /
               (vv + params.epsilon_m2);
    }
    double c() const {
        return params.falloff == SaoFalloffKind::kEquation1
                   ? 2 * params.intensity
                   : 5 * params.intensity / std::pow(params.radius_m, 6);
    }
};

// Intensities at which no pixel looked at is cut off at A = 0: A is then linear in f.
std::vector<Estimator> Estimators() {
    return {{{.falloff = SaoFalloffKind::kSmooth, .intensity = 0.4}},
            {{.falloff = SaoFalloffKind::kEquation1,
              .bias_m = 0,
              .bias_per_depth = 0.002,
              .intensity = 0.15}}};
}

struct Spot {
    const char* name;
    MadeShape shape;
    Vec3 at;  ///< A point seen; its pixel is looked at.
};

std::vector<Spot> Spots() {
    return {{"floor beside a wall", MadeFloorAndWall(), {0.2, -1, -4.7}},
            {"wall above a floor", MadeFloorAndWall(), {-0.3, -0.6, -5}},
            {"middle of a trench", MadeTrench(), {0, 0.1, -5}},
            {"trench beside its wall", MadeTrench(), {0.3, -0.2, -5}},
            {"floor under a sphere", MadeSphereOverPlane(), {0.25, -1, -4}},
            {"sphere above a floor", MadeSphereOverPlane(), {0.1, -0.65, -4.08}}};
}

struct Pixel {
    GBuffer g;
    int x = 0, y = 0;
    Vec3 C, n;
    double disc_px = 0;

    Pixel(const Spot& spot, int width, double radius_m) {
        g = MadeGBuffer(MadeView(width, width * 3 / 4), spot.shape);
        const Vec2 p = g.view.Project(spot.at);
        x = int(p.x());
        y = int(p.y());
        C = g.view.Point(x + 0.5, y + 0.5, g.z_m(x, y));
        n = g.face_normal(x, y).cast<double>();
        disc_px = radius_m * g.view.PixelsPerMetre() / -C.z();
    }
};

/// An integral over the disc, and how much f varies: along alpha its mean over theta, along theta
/// itself, on the mean over alpha.
struct Integral {
    double value = 0, along_alpha = 0, along_theta = 0;
};

/// f(alpha, theta) by the midpoint rule.
template <class Function>
Integral OverTheDisc(const Function& f, int n) {
    Integral integral;
    double before = 0;
    for (int i = 0; i < n; ++i) {
        double ring = 0, variation = 0;
        const double first = f((i + 0.5) / n, 2 * kPi * 0.5 / n);
        double last = first;
        for (int j = 0; j < n; ++j) {
            const double value = f((i + 0.5) / n, 2 * kPi * (j + 0.5) / n);
            variation += std::abs(value - last);
            ring += value / n;
            last = value;
        }
        variation += std::abs(first - last);
        integral.value += ring / n;
        integral.along_theta += variation / n;
        if (i > 0) integral.along_alpha += std::abs(ring - before);
        before = ring;
    }
    return integral;
}

/// f of the tap at h u on the drawn pixels, its offset cut to whole pixels; a tap beyond the picture
/// meets the nearest pixel of its border.
auto OnPixels(const Pixel& p, const Estimator& estimator) {
    return [&](double alpha, double theta) {
        const double h = alpha * p.disc_px;
        const int i = std::clamp(p.x + int(h * std::cos(theta)), 0, p.g.view.DrawnWidth() - 1);
        const int j = std::clamp(p.y + int(h * std::sin(theta)), 0, p.g.view.DrawnHeight() - 1);
        const Vec3 Q = p.g.view.Point(i + 0.5, j + 0.5, p.g.z_m(i, j));
        return estimator.f(Q - p.C, p.n, p.C.z());
    };
}

ObscuranceOptions OptionsOf(const Estimator& estimator, int samples) {
    ObscuranceOptions options;
    options.sao = estimator.params;
    options.taps.samples = samples;
    options.taps.coarsest_level = 0;
    options.normals = NormalSource::kFace;
    return options;
}

// Turned by every angle, s taps are s rings: the midpoint rule along alpha of the ring's mean, which
// is off by at most V / (2 s) for a mean that varies by V in all. M angles in place of all add
// T / (2 M), T the mean variation of a ring. The quadrature has both errors too, with n for
// s and M; and on pixels it may miss a jump of T between two of its angles, so T counts twice.
TEST(SaoLimit, MoreTapsReachTheIntegralOverTheDisc) {
    const int n = 1000, M = 360;
    for (const Spot& spot : Spots()) {
        for (const Estimator& estimator : Estimators()) {
            const Pixel p(spot, 400, estimator.params.radius_m);
            const Integral integral = OverTheDisc(OnPixels(p, estimator), n);
            const double limit = 1 - estimator.c() * integral.value;
            EXPECT_GT(limit, 0.1) << spot.name;
            EXPECT_LT(limit, 0.995) << spot.name;
            const ZPyramid pyramid(p.g.z_m, ZFilter::kRotatedGrid, 0);
            for (const int s : {1, 9, 64, 512, 4096}) {
                const ObscuranceOptions options = OptionsOf(estimator, s);
                double A = 0;
                for (int k = 0; k < M; ++k) {
                    A += ObscuranceOfPixel(p.g, pyramid, options, p.x, p.y,
                                           2 * kPi * (k + 0.5) / M) /
                         M;
                }
                const double V = integral.along_alpha, T = 2 * integral.along_theta;
                const double bound =
                    estimator.c() * (V / 2 * (1.0 / s + 1.0 / n) + T / 2 * (1.0 / M + 1.0 / n));
                EXPECT_NEAR(A, limit, bound) << spot.name << ", s = " << s;
                EXPECT_LT(bound, s < 4096 ? 1 : 0.03) << spot.name << ": says too little";
            }
        }
    }
}

// On the shape itself a tap meets what is at h u; on pixels what is at the centre of a pixel less than
// 1 px away along each axis, so less than sqrt(2) px. On the mean over the disc f differs by no more
// than it changes within such a step (looked for at 16 places around each point). Twice the pixels,
// half the bound: also where a step crosses an edge in depth, for edges are lines.
TEST(SaoLimit, MorePixelsReachTheIntegralOverTheShape) {
    const int n = 400;
    for (const Spot& spot : Spots()) {
        for (const Estimator& estimator : Estimators()) {
            double coarse_bound = 0;
            for (const int width : {400, 800}) {
                const Pixel p(spot, width, estimator.params.radius_m);
                const auto at = [&](const Vec2& place_px) {
                    const MadeHit hit =
                        spot.shape(p.g.view.Point(place_px.x(), place_px.y(), -1));
                    const Vec3 Q = p.g.view.Point(place_px.x(), place_px.y(), -hit.depth);
                    return estimator.f(Q - p.C, p.n, p.C.z());
                };
                const auto place = [&](double alpha, double theta) {
                    return Vec2(p.x + 0.5 + alpha * p.disc_px * std::cos(theta),
                                p.y + 0.5 + alpha * p.disc_px * std::sin(theta));
                };
                const Integral shape = OverTheDisc(
                    [&](double alpha, double theta) { return at(place(alpha, theta)); }, n);
                const Integral change = OverTheDisc(
                    [&](double alpha, double theta) {
                        const Vec2 middle = place(alpha, theta);
                        const double here = at(middle);
                        double most = 0;
                        for (int k = 0; k < 16; ++k) {
                            const double step = k % 2 == 0 ? std::sqrt(2.0) : 0.7;
                            const double angle = 2 * kPi * k / 16;
                            const Vec2 off(step * std::cos(angle), step * std::sin(angle));
                            most = std::max(most, std::abs(at(middle + off) - here));
                        }
                        return most;
                    },
                    n / 4);
                const Integral pixels = OverTheDisc(OnPixels(p, estimator), 2 * n);
                const double c = estimator.c(), bound = c * change.value;
                const double quadrature = c *
                                          (shape.along_alpha + shape.along_theta +
                                           pixels.along_alpha + pixels.along_theta) /
                                          (2 * n);
                EXPECT_NEAR(c * pixels.value, c * shape.value, bound + quadrature)
                    << spot.name << ", width " << width;
                EXPECT_LT(bound + quadrature, 0.12) << spot.name << ", width " << width;
                if (width == 400) {
                    coarse_bound = bound;
                } else {
                    EXPECT_LT(bound, 0.65 * coarse_bound) << spot.name;
                }
            }
        }
    }
}

// The pyramid puts the depth of a pixel up to 2^m - 1 px away at the place of the tap: on a plane
// n.P = d, v.n = d ((S - S').n) / (S'.n), with S - S' at most (2^m - 1) (a_x, a_y). Under a bias
// above that a tilted plane stays open; under the shipped 1 cm it darkens itself.
TEST(SaoLimit, ThePyramidMakesATiltedPlaneOccludeItself) {
    const View view = MadeView(400, 300);
    const Vec3 n = Vec3(0.2, -0.9, 0.4).normalized();
    const double d = -3 * n.z();
    const GBuffer g = MadeGBuffer(view, MadePlane(n, d));
    ObscuranceOptions options = OptionsOf({{}}, 64);
    options.taps.coarsest_level = 5;
    const ZPyramid pyramid(g.z_m, options.taps.filter, 5);
    const int x = 200, y = 150;
    const double z = g.z_m(x, y), disc = DiscRadiusPx(view, 1, z);
    const int level = LevelOfTap(disc, 3, 5);
    ASSERT_GE(level, 3);
    double least = 1e9;  // of S.n over all pixels that a tap can read
    for (const int i : {x - int(disc) - 32, x + int(disc) + 32}) {
        for (const int j : {y - int(disc) - 32, y + int(disc) + 32}) {
            least = std::min(least, std::abs(view.Point(i, j, 1).dot(n)));
        }
    }
    const double a_x = 2 * view.tan_half_width / 400, a_y = 2 * view.tan_half_height / 300;
    const double most = std::abs(d) * ((1 << level) - 1) *
                        (a_x * std::abs(n.x()) + a_y * std::abs(n.y())) / least;
    options.sao.bias_m = most * 1.0001 + 1e-6;
    EXPECT_EQ(ObscuranceOfPixel(g, pyramid, options, x, y), 1);
    options.sao.bias_m = 0.01;
    EXPECT_LT(ObscuranceOfPixel(g, pyramid, options, x, y), 0.999);
    options.taps.place = TapPlace::kLevelTexel;  // does not help: the rotated grid is no centre
    EXPECT_LT(ObscuranceOfPixel(g, pyramid, options, x, y), 1);
    const ZPyramid none(g.z_m, options.taps.filter, 0);
    EXPECT_EQ(ObscuranceOfPixel(g, none, options, x, y), 1);
}

}  // namespace
}  // namespace plumb
