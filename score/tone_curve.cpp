#include "score/tone_curve.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

using Coefficients = std::array<double, 6>;

constexpr Coefficients kAces{0.9036, 0.018, 0, 0.8748, 0.354, 0.14};
constexpr Coefficients kHable{0.231683, 0.013791, 0, 0.18, 0.3, 0.018};

constexpr double kBrightest = 0.85;

const Coefficients& CoefficientsOf(ToneCurve curve) {
    return curve == ToneCurve::kAces ? kAces : kHable;
}

double Luminance(const Rgb& c) {
    return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
}

}  // namespace

const std::vector<std::string>& ToneCurveNames() {
    static const std::vector<std::string> names{"aces", "hable", "reinhard"};
    return names;
}

Rgb Shown(ToneCurve curve, const Rgb& linear) {
    Rgb shown;
    if (curve == ToneCurve::kReinhard) {
        const double scale = 1 / (1 + Luminance(linear));
        for (std::size_t c = 0; c < 3; ++c) shown[c] = float(linear[c] * scale);
        return shown;
    }
    const auto& [k0, k1, k2, k3, k4, k5] = CoefficientsOf(curve);
    for (std::size_t c = 0; c < 3; ++c) {
        const double x = linear[c];
        shown[c] = float((k0 * x * x + k1 * x + k2) / (k3 * x * x + k4 * x + k5));
    }
    return shown;
}

double BrightestShown(ToneCurve curve) {
    if (curve == ToneCurve::kReinhard) return kBrightest / (1 - kBrightest);
    const auto& [k0, k1, k2, k3, k4, k5] = CoefficientsOf(curve);
    const double a = k0 - kBrightest * k3, b = k1 - kBrightest * k4, c = k2 - kBrightest * k5;
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

ToneExposures ExposuresBetween(ToneCurve curve, double median, double max) {
    assert(0 < median && median <= max);
    const double x = BrightestShown(curve);
    ToneExposures exposures{.start_stops = std::log2(x / max),
                            .stop_stops = std::log2(x / median)};
    exposures.count = std::max(2, int(std::ceil(exposures.stop_stops - exposures.start_stops)));
    return exposures;
}

ToneExposures ExposuresOf(ToneCurve curve, const Image<Rgb>& reference, const Mask& mask) {
    std::vector<double> luminances;
    for (std::size_t p = 0; p < reference.Pixels().size(); ++p) {
        if (mask.Empty() || mask.Pixels()[p] != 0) {
            luminances.push_back(Luminance(reference.Pixels()[p]));
        }
    }
    const auto median = [&] {
        const auto middle = luminances.begin() + std::ptrdiff_t(luminances.size() / 2);
        std::nth_element(luminances.begin(), middle, luminances.end());
        return *middle;
    };
    const double max =
        luminances.empty() ? 0 : *std::max_element(luminances.begin(), luminances.end());
    if (!(max > 0)) throw Error(MustBe("reference: greatest luminance", max, "> 0"));
    double middle = median();
    const bool of_positive = !(middle > 0);
    if (of_positive) {
        std::erase_if(luminances, [](double Y) { return !(Y > 0); });
        middle = median();
    }
    ToneExposures exposures = ExposuresBetween(curve, middle, max);
    exposures.median_of_positive = of_positive;
    return exposures;
}

}  // namespace plumb
