#include "fit/mayaux_faults.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

constexpr int kEvenSteps = 1000, kGeometricSteps = 2000;
constexpr double kNearestToOne = 1e-14;  // The last 1 - alpha that is looked at.

/// An excess that rounding alone can make: a few units in the last place of 1.
constexpr double kRounding = 1e-15;

/// The grid on which signs are compared: ascending, all within (0, 1).
std::vector<double> Grid() {
    std::vector<double> alphas;
    for (int i = 1; i < kEvenSteps; ++i) alphas.push_back(double(i) / kEvenSteps);
    for (int i = 1; i <= kGeometricSteps; ++i)
        alphas.push_back(1 - std::pow(kNearestToOne, double(i) / kGeometricSteps));
    std::sort(alphas.begin(), alphas.end());
    return alphas;
}

/// Bisects between low and high, at which f > 0 differs, until no double lies between.
template <class F>
double Bisect(const F& f, double low, double high) {
    const bool positive_at_low = f(low) > 0;
    for (;;) {
        const double middle = low + (high - low) / 2;
        if (middle <= low || middle >= high) return middle;
        ((f(middle) > 0) == positive_at_low ? low : high) = middle;
    }
}

/// The maximum of f between low and high by golden-section search; f has one there.
template <class F>
double Maximum(const F& f, double low, double high) {
    const double golden = (std::sqrt(5.0) - 1) / 2;
    // 60 steps shrink the bracket by 1e-12: below sqrt(epsilon), where f is flat to rounding.
    for (int step = 0; step < 60; ++step) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        (f(left) < f(right) ? low : high) = f(left) < f(right) ? left : right;
    }
    return low + (high - low) / 2;
}

/// Where excess(alpha) > 0, with its worst place.
template <class F>
std::vector<BrokenInterval> WherePositive(const F& excess) {
    const std::vector<double> alphas = Grid();
    std::vector<BrokenInterval> broken;
    for (std::size_t i = 0; i < alphas.size();) {
        if (!(excess(alphas[i]) > 0)) {
            ++i;
            continue;
        }
        std::size_t end = i, worst = i;
        for (; end < alphas.size() && excess(alphas[end]) > 0; ++end)
            if (excess(alphas[end]) > excess(alphas[worst])) worst = end;

        BrokenInterval interval;
        interval.low = i == 0 ? 0 : Bisect(excess, alphas[i - 1], alphas[i]);
        interval.high = end == alphas.size() ? 1 : Bisect(excess, alphas[end - 1], alphas[end]);
        interval.worst_alpha = Maximum(excess, worst == 0 ? 0 : alphas[worst - 1],
                                       worst + 1 == alphas.size() ? 1 : alphas[worst + 1]);
        interval.worst_excess = excess(interval.worst_alpha);
        if (interval.worst_excess > kRounding) broken.push_back(interval);
        i = end;
    }
    return broken;
}

/// F0 - alpha, without the cancellation that F0 suffers near alpha = 1.
double Gain(const DirectFactor<>& F0, double alpha) {
    return alpha * F0.a * std::pow(1 - alpha, F0.p);
}

}  // namespace

std::vector<UniformVisibility> PolesOf(const MayauxConstants<>& constants, Albedo rho) {
    if (rho.value <= 0) return {};  // No bounce, no series, no pole.
    const auto denominator = [&](double alpha) {
        const double one_minus_F0 = (1 - alpha) - Gain(constants.F0, alpha);
        const double F1 = Evaluate(constants.F1, UniformVisibility(alpha));
        return (1 - rho.value) * one_minus_F0 + rho.value * F1;
    };
    const std::vector<double> alphas = Grid();
    std::vector<UniformVisibility> poles;
    for (std::size_t i = 1; i < alphas.size(); ++i)
        if ((denominator(alphas[i - 1]) > 0) != (denominator(alphas[i]) > 0))
            poles.emplace_back(Bisect(denominator, alphas[i - 1], alphas[i]));
    return poles;
}

std::vector<BrokenInterval> DirectFactorAboveOne(const DirectFactor<>& F0) {
    return WherePositive([&](double alpha) { return Gain(F0, alpha) - (1 - alpha); });
}

std::vector<BrokenInterval> DirectFactorAboveBound(const DirectFactor<>& F0) {
    return WherePositive([&](double alpha) { return Gain(F0, alpha) - alpha * (1 - alpha); });
}

std::vector<BrokenInterval> DirectFactorBelowBound(const DirectFactor<>& F0) {
    return WherePositive([&](double alpha) { return -alpha * (1 - alpha) - Gain(F0, alpha); });
}

}  // namespace plumb
