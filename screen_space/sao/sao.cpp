#include "screen_space/sao/sao.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/error.h"

namespace plumb {
namespace {

void CheckRange(const char* field, double value, double low, double high, const char* rule) {
    if (!(value >= low && value <= high)) {
        throw Error(MustBe(std::string("SaoParams::") + field, value, rule));
    }
}

}  // namespace

void Validate(const SaoParams& params) {
    CheckRange("radius_m", params.radius_m, 1e-4, 1e7, "in [1e-4, 1e7]");
    CheckRange("bias_m", params.bias_m, 0, 1e7, "in [0, 1e7]");
    CheckRange("bias_per_depth", params.bias_per_depth, 0, 1e3, "in [0, 1000]");
    CheckRange("intensity", params.intensity, 0, 1e30, "in [0, 1e30]");
    CheckRange("epsilon_m2", params.epsilon_m2, 1e-12, 1e12, "in [1e-12, 1e12]");
    CheckRange("exponent", params.exponent, 0, 100, "in [0, 100]");
}

int IntensityPower(SaoFalloffKind falloff) {
    switch (falloff) {
        case SaoFalloffKind::kEquation1:
        case SaoFalloffKind::kSmooth:
            return 1;
        case SaoFalloffKind::kHpg12:
        case SaoFalloffKind::kNoDivision:
        case SaoFalloffKind::kLowContrast:
            return 5;
        case SaoFalloffKind::kHighQuality:
            return 0;
    }
    return 0;
}

SaoParams InOtherUnit(const SaoParams& params, double scale) {
    SaoParams scaled = params;
    scaled.radius_m *= scale;
    scaled.bias_m *= scale;
    scaled.intensity *= std::pow(scale, IntensityPower(params.falloff));
    scaled.epsilon_m2 *= scale * scale;
    return scaled;
}

double SaoFalloff(const Vec3& v_m, const Vec3& n, double z_C_m, const SaoParams& params) {
    const double r2 = params.radius_m * params.radius_m, eps = params.epsilon_m2;
    const double vv = v_m.squaredNorm();
    const double beta = params.bias_m - z_C_m * params.bias_per_depth;
    const double over = std::max(v_m.dot(n) - beta, 0.0);
    const double share = std::max(1 - vv / r2, 0.0);
    switch (params.falloff) {
        case SaoFalloffKind::kEquation1:
            return over / (vv + eps);  // [McGuire12 eq. 1]
        case SaoFalloffKind::kHpg12:
            return vv < r2 ? 0.6 * r2 * over / (vv + eps) : 0;
        case SaoFalloffKind::kSmooth:
            return std::pow(share * r2, 3) * over / (vv + eps);
        case SaoFalloffKind::kNoDivision:
            return 4 * share * over;
        case SaoFalloffKind::kLowContrast:
            return vv < r2 ? 2 * over : 0;
        case SaoFalloffKind::kHighQuality:
            return share * over / std::sqrt(vv + eps) *
                   (0.65 + 0.35 * std::max(0.0, 1.5 * n.z()));
    }
    return 0;
}

double SaoFromMean(double mean_f, const SaoParams& params) {
    const double sigma = params.intensity;
    switch (params.falloff) {
        case SaoFalloffKind::kEquation1:
            return std::pow(std::max(0.0, 1 - 2 * sigma * mean_f), params.exponent);
        case SaoFalloffKind::kHighQuality:
            return std::pow(std::max(0.0, 1 - std::sqrt(3 * mean_f)), sigma);
        default:
            break;
    }
    const double A = std::max(0.0, 1 - 5 * sigma / std::pow(params.radius_m, 6) * mean_f);
    return params.lift_dark ? (std::pow(A, 0.2) + 1.2 * std::pow(A, 4)) / 2.2 : A;
}

double SaoVisibility(std::span<const Vec3> taps_m, const Vec3& n, double z_C_m,
                     const SaoParams& params) {
    double sum = 0;
    for (const Vec3& v : taps_m) sum += SaoFalloff(v, n, z_C_m, params);
    return SaoFromMean(sum / double(taps_m.size()), params);
}

}  // namespace plumb
