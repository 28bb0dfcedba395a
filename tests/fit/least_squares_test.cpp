#include "fit/least_squares.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"

namespace plumb {
namespace {

using testing::HasSubstr;

/// f = intercept + slope x.
struct Line {
    std::vector<double> x, y, weights;
    std::array<Parameter, 2> parameters{{{"intercept", 0, -10, 10}, {"slope", 0, -10, 10}}};

    LeastSquaresProblem Problem() const {
        return {.name = "line",
                .parameters = parameters,
                .y = y,
                .weights = weights,
                .predict = [this](const double* p, double* f, double* jacobian) {
                    for (std::size_t i = 0; i < x.size(); ++i) {
                        f[i] = p[0] + p[1] * x[i];
                        if (!jacobian) continue;
                        jacobian[2 * i] = 1;
                        jacobian[2 * i + 1] = x[i];
                    }
                }};
    }
};

std::string MessageOf(const LeastSquaresProblem& problem) {
    try {
        Minimize(problem);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

// Expected: the regression of y = (0, 1, 1, 3) on x = (0, 1, 2, 3), by hand: mean x = 3/2, mean
// y = 5/4, S_xx = 5, S_xy = 9/2, slope = 9/10, intercept = -1/10;
// f - y = (-0.1, -0.2, 0.7, -0.4), so chi2 = 0.70, dof = 2, s^2 = 0.35; Var(slope) = s^2 / 5,
// Var(intercept) = s^2 (1/4 + (9/4) / 5) = 0.7 s^2; the correlation is -mean x over the root
// of mean x^2, -1.5 / sqrt(3.5).
// Tolerance: linear, so the last step is exact to rounding; 1e-9 is far below any error bar.
TEST(LeastSquares, RegressionByHand) {
    const Line line{.x = {0, 1, 2, 3}, .y = {0, 1, 1, 3}, .weights = {1, 1, 1, 1}};
    const LeastSquaresFit fit = Minimize(line.Problem());
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(fit.parameters[0].value, -0.1, 1e-9);
    EXPECT_NEAR(fit.parameters[1].value, 0.9, 1e-9);
    EXPECT_NEAR(fit.parameters[0].standard_error.value(), std::sqrt(0.35 * 0.7), 1e-9);
    EXPECT_NEAR(fit.parameters[1].standard_error.value(), std::sqrt(0.35 / 5), 1e-9);
    EXPECT_NEAR(fit.correlation(0, 1), -1.5 / std::sqrt(3.5), 1e-9);
    EXPECT_EQ(fit.correlation(1, 1), 1);
    EXPECT_NEAR(fit.chi2_per_dof, 0.35, 1e-9);
    EXPECT_NEAR(fit.rmse, std::sqrt(0.70 / 4), 1e-9);
    EXPECT_NEAR(fit.max_abs, 0.7, 1e-9);
    EXPECT_EQ(fit.samples, 4);
    EXPECT_EQ(fit.starts_agreeing, fit.starts);
}

// Expected: for two columns scaled to length 1, with cosine c, the singular values are
// sqrt(1 +- c); c = mean x / sqrt(mean x^2) = 1.5 / sqrt(3.5).
// Unscaled, the eigenvalues of J^T J = ((4, 6), (6, 14)) are 9 +- sqrt(61).
TEST(LeastSquares, ConditionByHand) {
    const Line line{.x = {0, 1, 2, 3}, .y = {0, 1, 1, 3}, .weights = {1, 1, 1, 1}};
    const LeastSquaresFit fit = Minimize(line.Problem());
    const double c = 1.5 / std::sqrt(3.5);
    EXPECT_NEAR(fit.condition, std::sqrt((1 + c) / (1 - c)), 1e-9);
    EXPECT_NEAR(fit.condition_unscaled,
                std::sqrt((9 + std::sqrt(61.0)) / (9 - std::sqrt(61.0))), 1e-9);
}

// Expected: a sample of weight 2 is two samples; the standard errors from weights, s^2 = 1, are
// then those of (J^T W J)^-1.
TEST(LeastSquares, AWeightOfTwoIsTheSampleTwice) {
    const Line twice{.x = {0, 1, 2, 3, 3}, .y = {0, 1, 1, 3, 3}, .weights = {1, 1, 1, 1, 1}};
    const Line weighted{.x = {0, 1, 2, 3}, .y = {0, 1, 1, 3}, .weights = {1, 1, 1, 2}};
    const LeastSquaresOptions from_weights{.error_scale = ErrorScale::kFromWeights};
    const LeastSquaresFit a = Minimize(twice.Problem(), from_weights);
    const LeastSquaresFit b = Minimize(weighted.Problem(), from_weights);
    for (int j : {0, 1}) {
        EXPECT_NEAR(a.parameters[j].value, b.parameters[j].value, 1e-9);
        EXPECT_NEAR(a.parameters[j].standard_error.value(),
                    b.parameters[j].standard_error.value(), 1e-9);
    }
    EXPECT_NEAR(a.rmse, b.rmse, 1e-9);
}

// Expected: NIST's certified values for the nonlinear regression "Misra1a" (Statistical
// Reference Datasets, lower difficulty), y = b1 (1 - exp(-b2 x)): eleven digits.
// Tolerance: 1e-7 relative, the square root of the solver's function tolerance with a margin.
TEST(LeastSquares, AgreesWithTheCertifiedValuesOfNist) {
    const std::vector<double> x{77.6,  114.9, 141.1, 190.8, 239.9, 289.0, 332.8,
                                378.4, 434.8, 477.3, 536.8, 593.1, 689.1, 760.0};
    const std::vector<double> y{10.07, 14.73, 17.94, 23.93, 29.61, 35.18, 40.02,
                                44.82, 50.76, 55.05, 61.01, 66.40, 75.47, 81.78};
    const std::vector<double> weights(x.size(), 1);
    const std::array<Parameter, 2> parameters{{{"b1", 500, 1, 1e4}, {"b2", 1e-4, 1e-6, 1}}};
    const LeastSquaresFit fit =
        Minimize({.name = "Misra1a",
                  .parameters = parameters,
                  .y = y,
                  .weights = weights,
                  .predict = [&](const double* b, double* f, double* jacobian) {
                      for (std::size_t i = 0; i < x.size(); ++i) {
                          const double decay = std::exp(-b[1] * x[i]);
                          f[i] = b[0] * (1 - decay);
                          if (!jacobian) continue;
                          jacobian[2 * i] = 1 - decay;
                          jacobian[2 * i + 1] = b[0] * x[i] * decay;
                      }
                  }});
    EXPECT_TRUE(fit.converged);
    EXPECT_NEAR(fit.parameters[0].value / 2.3894212918E+02, 1, 1e-7);
    EXPECT_NEAR(fit.parameters[1].value / 5.5015643181E-04, 1, 1e-7);
    EXPECT_NEAR(fit.parameters[0].standard_error.value() / 2.7070075241E+00, 1, 1e-6);
    EXPECT_NEAR(fit.parameters[1].standard_error.value() / 7.2668688436E-06, 1, 1e-6);
    EXPECT_NEAR(std::sqrt(fit.chi2_per_dof) / 1.0187876330E-01, 1, 1e-7);
}

// Expected: with the slope held at 1/2 by its bound, the best intercept is mean y - mean x / 2
// = 1/2. The bound, not the data, fixes the slope: it has no standard error, and the
// intercept's is s / sqrt(4) with dof = 3: residuals (0.5, 0, 0.5, -1), s^2 = 1.5 / 3.
TEST(LeastSquares, AParameterHeldByItsBoundHasNoErrorBar) {
    Line line{.x = {0, 1, 2, 3}, .y = {0, 1, 1, 3}, .weights = {1, 1, 1, 1}};
    line.parameters[1].high = 0.5;
    const LeastSquaresFit fit = Minimize(line.Problem());
    EXPECT_NEAR(fit.parameters[0].value, 0.5, 1e-9);
    EXPECT_FALSE(fit.parameters[0].at_bound);
    EXPECT_NEAR(fit.parameters[0].standard_error.value(), std::sqrt(0.5 / 4), 1e-9);
    EXPECT_EQ(fit.parameters[1].value, 0.5);
    EXPECT_TRUE(fit.parameters[1].at_bound);
    EXPECT_FALSE(fit.parameters[1].standard_error.has_value());
    EXPECT_NEAR(fit.condition, 1, 1e-12);
}

// Expected: at one single x only intercept + slope x is known: no rank, no error bars, and the
// prediction is the mean all the same.
TEST(LeastSquares, ALossOfRankIsReportedNotHidden) {
    const Line line{.x = {2, 2, 2}, .y = {1, 2, 3}, .weights = {1, 1, 1}};
    const LeastSquaresFit fit = Minimize(line.Problem());
    EXPECT_TRUE(std::isinf(fit.condition));
    EXPECT_FALSE(fit.parameters[0].standard_error.has_value());
    EXPECT_FALSE(fit.parameters[1].standard_error.has_value());
    EXPECT_NEAR(fit.rmse, std::sqrt(2.0 / 3), 1e-9);
}

// Expected: y = cos(p x) has many valleys; the initial value lies in a wrong one, and only some
// starts find p = 3, where the misfit vanishes.
TEST(LeastSquares, ManyStartsFindTheValleyThatOneMisses) {
    std::vector<double> x, y;
    for (int i = 0; i < 40; ++i) {
        x.push_back(0.25 * i);
        y.push_back(std::cos(3 * x.back()));
    }
    const std::vector<double> weights(x.size(), 1);
    const std::array<Parameter, 1> parameters{{{"p", 5, 0, 6}}};
    const LeastSquaresProblem problem{
        .name = "cosine",
        .parameters = parameters,
        .y = y,
        .weights = weights,
        .predict = [&](const double* p, double* f, double* jacobian) {
            for (std::size_t i = 0; i < x.size(); ++i) {
                f[i] = std::cos(p[0] * x[i]);
                if (jacobian) jacobian[i] = -x[i] * std::sin(p[0] * x[i]);
            }
        }};
    EXPECT_GT(Minimize(problem, {.starts = 1}).rmse, 0.1);
    const LeastSquaresFit fit = Minimize(problem, {.starts = 32});
    EXPECT_NEAR(fit.parameters[0].value, 3, 1e-9);
    EXPECT_GE(fit.starts_agreeing, 1);
    EXPECT_LT(fit.starts_agreeing, 32);
}

TEST(LeastSquares, NotConvergingIsAnOutcome) {
    const Line line{.x = {0, 1, 2, 3}, .y = {0, 1, 1, 3}, .weights = {1, 1, 1, 1}};
    const LeastSquaresFit fit = Minimize(line.Problem(), {.starts = 1, .max_iterations = 1});
    EXPECT_FALSE(fit.converged);
    EXPECT_FALSE(fit.termination.empty());
}

TEST(LeastSquares, RefusesTooFewSamples) {
    EXPECT_EQ(MessageOf(Line{.x = {0, 1}, .y = {0, 1}, .weights = {1, 1}}.Problem()),
              "line: samples = 2, must be more than the parameters, of which there are 2");
}

TEST(LeastSquares, RefusesDataThatAreNotFinite) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(MessageOf(Line{.x = {0, 1, 2}, .y = {0, nan, 1}, .weights = {1, 1, 1}}.Problem()),
              "line: y[1] = nan, must be finite");
    EXPECT_EQ(MessageOf(Line{.x = {0, 1, 2}, .y = {0, 1, 1}, .weights = {1, 1, -1}}.Problem()),
              "line: weights[2] = -1, must be finite and > 0");
}

// Expected: at x = 0 throughout the slope moves nothing.
TEST(LeastSquares, RefusesDataThatSayNothingOfAParameter) {
    EXPECT_THAT(MessageOf(Line{.x = {0, 0, 0}, .y = {1, 2, 3}, .weights = {1, 1, 1}}.Problem()),
                HasSubstr("line: nothing to fit, the data do not depend on slope"));
}

TEST(LeastSquares, ValidatesItsOptions) {
    const Line line{.x = {0, 1, 2}, .y = {0, 1, 1}, .weights = {1, 1, 1}};
    EXPECT_THROW(Minimize(line.Problem(), {.starts = 0}), Error);
    EXPECT_THROW(Minimize(line.Problem(), {.max_iterations = 0}), Error);
    EXPECT_THROW(Minimize(line.Problem(), {.least_effect = 0}), Error);
}

}  // namespace
}  // namespace plumb
