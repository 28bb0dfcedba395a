// The truth's noise leaves no trace in the scores: z-tests over simulated truths.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/statistics.h"
#include "score/errors.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

constexpr int kWidth = 24, kHeight = 16, kRuns = 2000;

/// An error that varies from pixel to pixel, from none to twice the noise, and a noise that
/// does.
double ErrorAt(int i, int j) {
    return 0.002 * (i - 8) + 0.003 * (j % 3);
}
double SigmaAt(int i, int j) {
    return 0.004 + 0.001 * ((i + 2 * j) % 8);
}

const auto kTrue =
    MadeImage<float>(kWidth, kHeight, [](int i, int j) { return 0.5 + 0.01 * i - 0.005 * j; });
const auto kCandidate = MadeImage<float>(
    kWidth, kHeight, [](int i, int j) { return 0.5 + 0.01 * i - 0.005 * j + ErrorAt(i, j); });

struct Measurement {
    Image<float> truth, standard_error;
};

/// Of `replicates` measurements of each pixel, mean and standard error; 0: sigma is known.
Measurement Measure(int replicates, int run) {
    Measurement result{kTrue, kTrue};
    for (int j = 0; j < kHeight; ++j) {
        for (int i = 0; i < kWidth; ++i) {
            const std::uint64_t pixel = std::uint64_t(j) * kWidth + i;
            const double sigma = SigmaAt(i, j);
            if (replicates == 0) {
                result.truth(i, j) = float(kTrue(i, j) + sigma * MadeNormal(1, pixel, run));
                result.standard_error(i, j) = float(sigma);
                continue;
            }
            Moments moments;
            for (int r = 0; r < replicates; ++r) {
                moments.Add(sigma * std::sqrt(replicates) *
                            MadeNormal(2, pixel, std::uint64_t(run) * replicates + r));
            }
            result.truth(i, j) = float(kTrue(i, j) + moments.Mean());
            result.standard_error(i, j) = float(moments.StandardError());
        }
    }
    return result;
}

double TrueMean(double (*of)(double)) {
    double sum = 0;
    for (std::size_t k = 0; k < kTrue.Pixels().size(); ++k)
        sum += of(double(kCandidate.Pixels()[k]) - double(kTrue.Pixels()[k]));
    return sum / double(kTrue.Pixels().size());
}

class TruthNoise : public testing::TestWithParam<int> {};

// Expected: the scores of the noiseless truth, and z = (score - that) / noise_error with mean
// square 1. Tolerance: kSigmas standard errors of the means over the runs; the mean square of
// nearly normal z has the standard error sqrt(2 / runs); the estimated noise_error is itself
// off by a few parts in a hundred from run to run, which averages to below 1 part in 100.
TEST_P(TruthNoise, IsTakenOffAndItsErrorIsHonest) {
    const int replicates = GetParam();
    const double mse = TrueMean([](double d) { return d * d; });
    const double bias = TrueMean([](double d) { return d; });
    ErrorOptions options;
    options.truth_dof =
        replicates == 0 ? std::numeric_limits<double>::infinity() : replicates - 1;
    Moments mses, biases, z2_mse, z2_bias;
    for (int run = 0; run < kRuns; ++run) {
        const Measurement made = Measure(replicates, run);
        const ErrorScore score =
            ScoreErrors(kCandidate, made.truth, made.standard_error, {}, options);
        mses.Add(score.mse.value);
        biases.Add(score.bias.value);
        z2_mse.Add(std::pow((score.mse.value - mse) / score.mse.noise_error, 2));
        z2_bias.Add(std::pow((score.bias.value - bias) / score.bias.noise_error, 2));
    }
    EXPECT_NEAR(mses.Mean(), mse, kSigmas * mses.StandardError());
    EXPECT_NEAR(biases.Mean(), bias, kSigmas * biases.StandardError());
    const double tolerance = kSigmas * std::sqrt(2.0 / kRuns) + 0.01;
    EXPECT_NEAR(z2_mse.Mean(), 1, tolerance);
    EXPECT_NEAR(z2_bias.Mean(), 1, tolerance);
    // The test can tell: what is taken off is a large part of the MSE.
    EXPECT_GT(ScoreErrors(kCandidate, Measure(replicates, 0).truth).mse.value, 1.15 * mse);
}

INSTANTIATE_TEST_SUITE_P(KnownAndMeasured, TruthNoise, testing::Values(0, 8, 4));

// Expected: |e| <= E|d| <= |e| + the bound, pixel means; and the bound is not idle: it is
// below the plain sqrt(2/pi) sigma, and noise does raise the MAE.
TEST(MaeNoise, IsWithinItsBound) {
    const double mae = TrueMean([](double d) { return std::abs(d); });
    Moments maes, bounds;
    for (int run = 0; run < kRuns; ++run) {
        const Measurement made = Measure(0, run);
        const ErrorScore score = ScoreErrors(kCandidate, made.truth, made.standard_error);
        maes.Add(score.mae.value);
        bounds.Add(score.mae_noise_bias);
    }
    const double excess = maes.Mean() - mae;
    EXPECT_GT(excess, kSigmas * maes.StandardError());
    EXPECT_LT(excess + kSigmas * maes.StandardError(), bounds.Mean());
    double plain = 0;
    for (int j = 0; j < kHeight; ++j)
        for (int i = 0; i < kWidth; ++i)
            plain += std::sqrt(2 / std::numbers::pi) * SigmaAt(i, j);
    EXPECT_LT(bounds.Mean(), 0.9 * plain / (kWidth * kHeight));
}

// Expected: of truths that are noise alone, the candidate being right, max_at_least exceeds 0
// in 5 % of the runs. Tolerance: kSigmas standard errors of a share.
TEST(MaxAtLeast, IsAboveZeroAsOftenAsItSays) {
    int above = 0;
    for (int run = 0; run < kRuns; ++run) {
        const Measurement made = Measure(0, run);
        above += ScoreErrors(kTrue, made.truth, made.standard_error).max_at_least > 0;
    }
    EXPECT_NEAR(above / double(kRuns), 0.05, kSigmas * std::sqrt(0.05 * 0.95 / kRuns));
}

// The noise of a shared truth cancels out of a comparison but for the part that it states.
TEST(CompareMseNoise, IsHonest) {
    const auto other = MadeImage<float>(kWidth, kHeight, [](int i, int j) {
        return kTrue(i, j) + 0.5 * ErrorAt(i, j) + 0.001;
    });
    const double expected = CompareMse(kCandidate, other, kTrue).value;
    Moments differences, z2;
    for (int run = 0; run < kRuns; ++run) {
        const Measurement made = Measure(0, run);
        const Measured figure = CompareMse(kCandidate, other, made.truth, made.standard_error);
        differences.Add(figure.value);
        z2.Add(std::pow((figure.value - expected) / figure.noise_error, 2));
    }
    EXPECT_NEAR(differences.Mean(), expected, kSigmas * differences.StandardError());
    EXPECT_NEAR(z2.Mean(), 1, kSigmas * std::sqrt(2.0 / kRuns));
}

}  // namespace
}  // namespace plumb
