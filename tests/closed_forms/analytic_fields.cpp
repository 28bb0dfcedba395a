#include "tests/closed_forms/analytic_fields.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/conventions.h"
#include "core/error.h"

namespace plumb {
namespace {

void Require(bool holds, const std::string& thing, double value, const std::string& rule) {
    if (!holds) throw Error(MustBe(thing, value, rule));
}

void RequirePositive(const std::string& thing, double value) {
    Require(value > 0 && std::isfinite(value), thing, value, "finite and > 0");
}

// The upper end keeps every product of two counts within an int.
void RequireCount(const std::string& thing, int value, int least) {
    Require(value >= least && value <= 16384, thing, value,
            "in [" + std::to_string(least) + ", 16384]");
}

template <class HeightOfTexel>
Image<double> Fill(int width, int height, const HeightOfTexel& z) {
    Image<double> heights_m(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) heights_m(i, j) = z(i, j);
    return heights_m;
}

}  // namespace

double VGroove::DepthM() const {
    return face_m * std::cos(opening_rad / 2);
}
double VGroove::PeriodM() const {
    return 2 * face_m * std::sin(opening_rad / 2);
}
double VGroove::SpacingM() const {
    return face_m * std::sin(opening_rad / 2) / texels_per_face;
}
double Trench::SpacingM() const {
    return width_m / width_texels;
}
double Trench::LandM() const {
    return land_texels * SpacingM();
}
double Pit::SpacingM() const {
    return radius_m / radius_texels;
}
double Bowl::DepthM() const {
    return sphere_radius_m * (1 - std::cos(half_angle_rad));
}
double Bowl::RimRadiusM() const {
    return sphere_radius_m * std::sin(half_angle_rad);
}
double Bowl::SpacingM() const {
    return RimRadiusM() / rim_texels;
}

void Validate(const Flat& p) {
    RequireCount("Flat::width_texels", p.width_texels, 2);
    RequireCount("Flat::height_texels", p.height_texels, 2);
    RequirePositive("Flat::spacing_m", p.spacing_m);
    Require(std::isfinite(p.height_m), "Flat::height_m", p.height_m, "finite");
}

void Validate(const Tilted& p) {
    RequireCount("Tilted::width_texels", p.width_texels, 2);
    RequireCount("Tilted::height_texels", p.height_texels, 2);
    RequirePositive("Tilted::spacing_m", p.spacing_m);
    Require(std::isfinite(p.slope_x), "Tilted::slope_x", p.slope_x, "finite");
    Require(std::isfinite(p.slope_y), "Tilted::slope_y", p.slope_y, "finite");
}

void Validate(const VGroove& p) {
    Require(p.opening_rad > 0 && p.opening_rad < kPi, "VGroove::opening_rad", p.opening_rad,
            "in (0, pi)");
    RequirePositive("VGroove::face_m", p.face_m);
    RequireCount("VGroove::texels_per_face", p.texels_per_face, 1);
    RequireCount("VGroove::grooves", p.grooves, 1);
    RequireCount("VGroove::rows", p.rows, 2);
}

void Validate(const Trench& p) {
    RequirePositive("Trench::width_m", p.width_m);
    RequirePositive("Trench::depth_m", p.depth_m);
    RequireCount("Trench::width_texels", p.width_texels, 1);
    RequireCount("Trench::land_texels", p.land_texels, 1);
    RequireCount("Trench::rows", p.rows, 2);
}

void Validate(const Pit& p) {
    RequirePositive("Pit::radius_m", p.radius_m);
    RequirePositive("Pit::depth_m", p.depth_m);
    RequireCount("Pit::texels", p.texels, 6);
    Require(p.radius_texels >= 1 && p.radius_texels <= p.texels / 2 - 2, "Pit::radius_texels",
            p.radius_texels, "in [1, texels / 2 - 2]");
}

void Validate(const Bowl& p) {
    RequirePositive("Bowl::sphere_radius_m", p.sphere_radius_m);
    Require(p.half_angle_rad > 0 && p.half_angle_rad <= kPi / 2, "Bowl::half_angle_rad",
            p.half_angle_rad, "in (0, pi/2]");
    RequireCount("Bowl::texels", p.texels, 8);
    Require(p.rim_texels >= 2 && p.rim_texels <= p.texels / 2 - 2, "Bowl::rim_texels",
            p.rim_texels, "in [2, texels / 2 - 2]");
}

void Validate(const Sinusoid& p) {
    Require(p.amplitude_m >= 0 && std::isfinite(p.amplitude_m), "Sinusoid::amplitude_m",
            p.amplitude_m, "finite and >= 0");
    RequireCount("Sinusoid::width_texels", p.width_texels, 3);
    RequireCount("Sinusoid::height_texels", p.height_texels, 3);
    Require(p.periods_x >= 0 && 2 * p.periods_x < p.width_texels, "Sinusoid::periods_x",
            p.periods_x, "in [0, width_texels / 2)");
    Require(p.periods_y >= 0 && 2 * p.periods_y < p.height_texels, "Sinusoid::periods_y",
            p.periods_y, "in [0, height_texels / 2)");
    Require(p.periods_x + p.periods_y > 0, "Sinusoid::periods_x", p.periods_x,
            "> 0 where periods_y is 0");
    RequirePositive("Sinusoid::width_m", p.width_m);
}

HeightField MakeFlat(const Flat& p) {
    Validate(p);
    return HeightField(Image<double>(p.width_texels, p.height_texels, p.height_m), p.spacing_m,
                       p.spacing_m, p.boundary);
}

HeightField MakeTilted(const Tilted& p) {
    Validate(p);
    auto z = [&](int i, int j) {
        return p.slope_x * ((i + 0.5) * p.spacing_m) + p.slope_y * ((j + 0.5) * p.spacing_m);
    };
    return HeightField(Fill(p.width_texels, p.height_texels, z), p.spacing_m, p.spacing_m,
                       Boundary::kOpen);
}

HeightField MakeVGroove(const VGroove& p) {
    Validate(p);
    const int n = p.texels_per_face;
    auto z = [&](int i, int) {
        const int k = i % (2 * n);  // Cells from the crest on the left.
        return -p.DepthM() * (k <= n ? k : 2 * n - k) / n;
    };
    return HeightField(Fill(2 * n * p.grooves, p.rows, z), p.SpacingM(), p.SpacingM());
}

HeightField MakeTrench(const Trench& p) {
    Validate(p);
    auto z = [&](int i, int) { return i < p.width_texels ? -p.depth_m : 0; };
    return HeightField(Fill(p.width_texels + p.land_texels, p.rows, z), p.SpacingM(),
                       p.SpacingM());
}

HeightField MakePit(const Pit& p) {
    Validate(p);
    const int middle = p.texels / 2;
    auto z = [&](int i, int j) {
        return std::hypot(i - middle, j - middle) < p.radius_texels ? -p.depth_m : 0;
    };
    return HeightField(Fill(p.texels, p.texels, z), p.SpacingM(), p.SpacingM());
}

HeightField MakeBowl(const Bowl& p) {
    Validate(p);
    const int middle = p.texels / 2;
    const double R = p.sphere_radius_m;
    const double centre_above_ground_m = R * std::cos(p.half_angle_rad);
    auto z = [&](int i, int j) {
        const double r = std::hypot(i - middle, j - middle) * p.SpacingM();
        if (r >= p.RimRadiusM()) return 0.0;
        return std::min(0.0, centre_above_ground_m - std::sqrt((R - r) * (R + r)));
    };
    return HeightField(Fill(p.texels, p.texels, z), p.SpacingM(), p.SpacingM());
}

HeightField MakeSinusoid(const Sinusoid& p) {
    Validate(p);
    const double spacing_m = p.width_m / p.width_texels;
    auto z = [&](int i, int j) {
        const double u = (i + 0.5) / p.width_texels, v = (j + 0.5) / p.height_texels;
        return p.amplitude_m / 2 * std::sin(2 * kPi * (p.periods_x * u + p.periods_y * v));
    };
    return HeightField(Fill(p.width_texels, p.height_texels, z), spacing_m, spacing_m);
}

}  // namespace plumb
