#include "core/distributions.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/conventions.h"

namespace plumb {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// A probability and its complement, so that the smaller one keeps its digits.
struct Tails {
    double lower, upper;
};

Tails FromLower(double lower) {
    return {lower, 1 - lower};
}
Tails Swapped(const Tails& tails) {
    return {tails.upper, tails.lower};
}

/// ln Gamma(n + 1) - ln( sqrt(2 pi n) (n/e)^n ), the error of Stirling's formula [Loader00].
double StirlingError(double n) {
    if (n < 15) {
        return std::log(std::tgamma(n + 1)) - (n + 0.5) * std::log(n) + n -
               0.5 * std::log(2 * kPi);
    }
    // Bernoulli numbers B_2k / (2k (2k-1)); the first one left out is below 1e-15 at n = 15.
    const double q = 1 / (n * n);
    return (1. / 12 - (1. / 360 - (1. / 1260 - (1. / 1680 - q / 1188) * q) * q) * q) / n;
}

/// x ln(x / m) + m - x, without cancellation near x = m [Loader00].
double Deviance(double x, double m) {
    const double v = (x - m) / (x + m);
    if (std::abs(v) >= 0.1) return x * std::log(x / m) + m - x;
    // ln(x/m) = 2 atanh(v): the terms of the series beyond the first.
    double sum = (x - m) * v, power = 2 * x * v;
    for (int k = 3; k < 100; k += 2) {
        power *= v * v;
        const double next = sum + power / k;
        if (next == sum) break;
        sum = next;
    }
    return sum;
}

/// Gamma(a+b+1) / (Gamma(a+1) Gamma(b+1)) x^a y^b with x + y = 1.
double BinomialTerm(double a, double b, double x, double y) {
    const double n = a + b;
    const double exponent = StirlingError(n) - StirlingError(a) - StirlingError(b) -
                            Deviance(a, n * x) - Deviance(b, n * y);
    return std::exp(exponent) * std::sqrt(n / (2 * kPi * a * b));
}

double AwayFromZero(double x) {
    return std::abs(x) < 1e-300 ? 1e-300 : x;
}

/// x^a y^b / (B(a, b) I_x(a, b)) for x + y = 1, the continued fraction of [DiDonato92] by
/// Lentz. It converges in O(sqrt(max(a, b))) steps for x (b + 1) <= y (a + 1), and has y
/// instead of 1 - x, so that x near 1 costs no digits.
double BetaFraction(double x, double y, double a, double b) {
    const auto partial_denominator = [&](double m) {
        return m + m * (b - m) * x / (a + 2 * m - 1) +
               (a + m) * (a * y - b * x + 1 + m * (1 + y)) / (a + 2 * m + 1);
    };
    double f = AwayFromZero(a * (a * y - b * x + 1) / (a + 1)), c = f, d = 0;
    for (double m = 1, change = 0; std::abs(change - 1) > kEpsilon && m < 1e6; ++m) {
        const double root = x / (a + 2 * m - 1);
        const double numerator = (a + m - 1) * (a + b + m - 1) * m * (b - m) * root * root;
        const double denominator = partial_denominator(m);
        d = 1 / AwayFromZero(denominator + numerator * d);
        c = AwayFromZero(denominator + numerator / c);
        change = c * d;
        f *= change;
    }
    return f;
}

/// I_x(a, b) and its complement, for x + y = 1.
Tails BetaTails(double x, double y, double a, double b) {
    if (x <= 0) return {0, 1};
    if (y <= 0) return {1, 0};
    if (x * (b + 1) > y * (a + 1)) return Swapped(BetaTails(y, x, b, a));
    const double front = BinomialTerm(a, b, x, y) * a * b / (a + b);
    return FromLower(std::min(1.0, front / BetaFraction(x, y, a, b)));
}

/// P(a, x) and Q(a, x) of the incomplete gamma function.
Tails GammaTails(double a, double x) {
    if (x <= 0) return {0, 1};
    // x^a e^-x / Gamma(a + 1)
    const double front = std::exp(-StirlingError(a) - Deviance(a, x)) / std::sqrt(2 * kPi * a);
    if (x < a + 1) {
        double sum = 1, term = 1;
        for (double n = a + 1; term > kEpsilon * sum; ++n) sum += term *= x / n;
        return FromLower(std::min(1.0, front * sum));
    }
    // [DLMF] 8.9.2, by Lentz.
    double c = 1e300, d = 1 / (x + 1 - a), f = d;
    for (double k = 1, change = 0; std::abs(change - 1) > kEpsilon && k < 1e6; ++k) {
        const double factor = k * (a - k), b = x + 2 * k + 1 - a;
        d = 1 / AwayFromZero(b + factor * d);
        c = AwayFromZero(b + factor / c);
        change = c * d;
        f *= change;
    }
    return Swapped(FromLower(std::min(1.0, front * a * f)));
}

/// The root of an increasing function in [low, high]: Newton's step where it stays inside the
/// bracket, else its middle. `function(x)` returns the value and the derivative.
template <class Function>
double Root(const Function& function, double low, double high, double start) {
    double x = start;
    for (int step = 0; step < 500; ++step) {
        const auto [value, slope] = function(x);
        if (value == 0) return x;
        (value < 0 ? low : high) = x;
        const double newton = x - value / slope;
        const double next = newton > low && newton < high ? newton : (low + high) / 2;
        if (std::abs(next - x) <= kEpsilon * std::abs(x)) return next;
        x = next;
    }
    return x;
}

struct ValueAndSlope {
    double value, slope;
};

/// ln(reached / wanted) of the smaller tail, which Newton finds almost straight; increasing.
ValueAndSlope TailMismatch(const Tails& reached, const Tails& wanted, double density) {
    if (wanted.lower < wanted.upper) {
        return {std::log(reached.lower / wanted.lower), density / reached.lower};
    }
    return {-std::log(reached.upper / wanted.upper), density / reached.upper};
}

Tails NormalTails(double z) {
    return {std::erfc(-z / std::sqrt(2.)) / 2, std::erfc(z / std::sqrt(2.)) / 2};
}

Tails StudentTails(double t, double dof) {
    const double far =
        BetaTails(dof / (dof + t * t), t * t / (dof + t * t), dof / 2, 0.5).lower / 2;
    const Tails tails{1 - far, far};
    return t < 0 ? Swapped(tails) : tails;
}

}  // namespace

double NormalCdf(double z) {
    return NormalTails(z).lower;
}

double NormalQuantile(double probability) {
    assert(0 <= probability && probability <= 1);
    if (probability == 0 || probability == 1) return probability == 0 ? -kInfinity : kInfinity;
    const Tails wanted = FromLower(probability);
    const auto mismatch = [&](double z) {
        return TailMismatch(NormalTails(z), wanted, std::exp(-z * z / 2) / std::sqrt(2 * kPi));
    };
    return Root(mismatch, -38.5, 38.5, 0);  // beyond, the density is below the least double
}

double BetaCdf(double x, double a, double b) {
    assert(a > 0 && b > 0);
    return BetaTails(x, 1 - x, a, b).lower;
}

double BetaQuantile(double probability, double a, double b) {
    assert(0 <= probability && probability <= 1 && a > 0 && b > 0);
    if (probability == 0 || probability == 1) return probability;
    const Tails wanted = FromLower(probability);
    const auto mismatch = [&](double x) {
        const double density = BinomialTerm(a, b, x, 1 - x) * a * b / ((a + b) * x * (1 - x));
        return TailMismatch(BetaTails(x, 1 - x, a, b), wanted, density);
    };
    return Root(mismatch, 0, 1, a / (a + b));
}

double StudentCdf(double t, double dof) {
    assert(dof > 0);
    return StudentTails(t, dof).lower;
}

double StudentQuantile(double probability, double dof) {
    assert(0 <= probability && probability <= 1 && dof > 0);
    if (probability == 0 || probability == 1) return probability == 0 ? -kInfinity : kInfinity;
    if (probability == 0.5) return 0;
    const double tail = std::min(probability, 1 - probability), half = dof / 2;
    const auto mismatch = [&](double t) {
        const double x = dof / (dof + t * t), y = t * t / (dof + t * t);
        const double density = BinomialTerm(half, 0.5, x, y) * half / (dof + 1) / t;
        return TailMismatch(StudentTails(t, dof), {1 - tail, tail}, density);
    };
    double far = 1;
    while (StudentTails(far, dof).upper > tail) far *= 2;
    return std::copysign(Root(mismatch, 0, far, far), probability - 0.5);
}

double ChiSquareSurvival(double chi2, double dof) {
    assert(dof > 0);
    return GammaTails(dof / 2, chi2 / 2).upper;
}

}  // namespace plumb
