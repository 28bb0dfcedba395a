#include "fit/model_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "fit/mayaux_refit.h"
#include "fit/models/escape_probability.h"
#include "fit/models/plain_visibility.h"
#include "made_maps.h"

namespace plumb {
namespace {

/// Exact samples of the formula, over alpha = V and five albedos.
std::vector<Sample> SamplesOf(const Formula& formula, int n = 50) {
    std::vector<Sample> samples;
    for (int i = 0; i < n; ++i)
        for (double rho : {0.1, 0.3, 0.5, 0.7, 0.9}) {
            const double x = (i + 0.5) / n;
            Sample sample{.at = {UniformVisibility(x), CosineVisibility(x), Albedo(rho)}};
            sample.y = formula(sample.at);
            samples.push_back(sample);
        }
    return samples;
}

/// A standard normal number (Box and Muller) that depends on its counter only.
double Normal(std::uint64_t seed, std::uint64_t i) {
    const double u = 1 - RandomUnit(seed, 0, i, 0), v = RandomUnit(seed, 0, i, 1);
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
}

// Expected: the constants that made the data. Tolerance: the cost at the end is below
// epsilon^2 times a condition number of up to 1e4 here.
TEST(FitModel, RecoversTheConstantsThatMadeTheData) {
    const std::vector<Formula> truths{
        {"", FindModel("F0"), {0.62, 1.3}},
        {"", FindModel("F1"), {19.0, 2.7}},
        {"", FindModel("F1, free exponents"), {12.0, 2.5, 0.4, 1.2}},
        {"", FindModel("E_k"), {400, 6.5, 0.3}},
        {"", FindModel("escape of V"), {0.93, 0.52}},
        {"", FindModel("escape of alpha"), {0.7, 1.4, 0.93, 0.52}},
        {"", FindModel("escape of alpha, clamped"), {0.5, 0.75, 0.93, 0.52}},
    };
    for (const Formula& truth : truths) {
        const LeastSquaresFit fit = FitModel(truth.model, SamplesOf(truth));
        EXPECT_TRUE(fit.converged) << truth.model.name << ": " << fit.termination;
        EXPECT_LT(fit.rmse, 1e-9) << truth.model.name;
        EXPECT_GE(fit.starts_agreeing, 2) << truth.model.name;
        for (std::size_t j = 0; j < truth.values.size(); ++j)
            EXPECT_NEAR(fit.parameters[j].value / truth.values[j], 1, 1e-6)
                << truth.model.name << " " << fit.parameters[j].name;
    }
}

// Expected: with noise of the stated sigma, chi2 / dof has mean 1 and standard deviation
// sqrt(2 / dof). Tolerance: 4 standard deviations; the seed is fixed, so this never flickers.
TEST(FitModel, Chi2IsOneWhenTheSigmasAreHonest) {
    const double sigma = 0.01;
    const Formula truth{"", FindModel("escape of V"), {0.93, 0.52}};
    std::vector<Sample> samples = SamplesOf(truth);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i].y += sigma * Normal(20240601, i);
        samples[i].weight = 1 / (sigma * sigma);
    }
    const LeastSquaresFit fit =
        FitModel(truth.model, samples, {.error_scale = ErrorScale::kFromWeights});
    const double dof = double(samples.size()) - 2;
    EXPECT_NEAR(fit.chi2_per_dof, 1, 4 * std::sqrt(2 / dof));
}

// Expected: the scatter of the constants over 200 repetitions of the experiment is their
// standard error. Their mean is the truth within 4 / sqrt(200) of it (the bias of a mildly
// nonlinear model, of order sigma^2, is far less), and the standard deviation of a standard
// deviation is 1 / sqrt(2 * 199) of it; 4 of them are allowed.
TEST(FitModel, StandardErrorsAreTheScatterOfRepetitions) {
    const double sigma = 0.01;
    const int repetitions = 200;
    const Formula truth{"", FindModel("F0"), {0.5, 0.75}};
    const std::vector<Sample> exact = SamplesOf(truth);
    std::vector<double> sum(2, 0), squares(2, 0);
    LeastSquaresFit fit;
    for (int r = 0; r < repetitions; ++r) {
        std::vector<Sample> samples = exact;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            samples[i].y += sigma * Normal(1000 + r, i);
            samples[i].weight = 1 / (sigma * sigma);
        }
        fit = FitModel(truth.model, samples,
                       {.starts = 1, .error_scale = ErrorScale::kFromWeights});
        for (int j : {0, 1}) {
            const double off = fit.parameters[j].value - truth.values[j];
            sum[j] += off;
            squares[j] += off * off;
        }
    }
    for (int j : {0, 1}) {
        const double stated = fit.parameters[j].standard_error.value();
        EXPECT_NEAR(sum[j] / repetitions, 0, 4 * stated / std::sqrt(repetitions));
        EXPECT_NEAR(std::sqrt(squares[j] / repetitions) / stated, 1,
                    4 / std::sqrt(2.0 * (repetitions - 1)));
    }
}

TEST(FitModel, SamplesOfWeightZeroAreLeftOut) {
    const Formula truth{"", FindModel("F0"), {0.62, 1.3}};
    std::vector<Sample> samples = SamplesOf(truth);
    Sample absurd = samples[7];
    absurd.y = 100;
    absurd.weight = 0;
    samples.push_back(absurd);
    const LeastSquaresFit fit = FitModel(truth.model, samples);
    EXPECT_EQ(fit.samples, int(samples.size()) - 1);
    EXPECT_NEAR(fit.parameters[0].value, 0.62, 1e-6);
}

// Expected: an open plain, alpha = V = 1 throughout, has no occlusion to learn from.
TEST(FitModel, RefusesAFlatMap) {
    MadeSurface surface;
    BounceHistogram flat = MakeMap("flat", surface);
    for (BounceBin& bin : flat.bins) {
        bin.alpha = bin.V = 1;
        for (Spread& E_k : bin.bounce) E_k.mean = &E_k == bin.bounce.data();
        for (Spread& E : bin.total) E.mean = 1;
    }
    const std::span<const BounceHistogram> maps(&flat, 1);
    for (const char* curve : {"F0", "F1"}) {
        try {
            FitModel(FindModel(curve), BounceSamples(maps, curve[1] - '0'));
            ADD_FAILURE() << curve;
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr("nothing to fit")) << curve;
        }
    }
    EXPECT_THROW(FitModel(ModelOf<EscapeOfV>(), TotalSamples(maps)), Error);
    EXPECT_THROW(FitModel(ModelOf<EscapeOfAlpha>(), TotalSamples(maps)), Error);
}

TEST(FitModel, RefusesWhatItCannotFit) {
    const auto message = [](const Model& model, std::span<const Sample> samples) {
        try {
            FitModel(model, samples);
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    const std::vector<double> x{0.1, 0.2, 0.3}, y{0.2, 0.3, 0.4};
    const auto pairs = PairSamples(BinnedBy::kUniformVisibility, x, y);
    EXPECT_EQ(message(ModelOf<EscapeOfV>(), pairs),
              "escape of V: sample 0, V = nan, must be finite, the model reads it");
    EXPECT_EQ(message(ModelOf<PlainVModel>(), pairs),
              "plain V: has no free constant, nothing to fit");
    EXPECT_EQ(
        message(FindModel("F1, free exponents"), pairs),
        "F1, free exponents: samples = 3, must be more than the parameters, of which there "
        "are 4");
}

// Expected: the same bits twice. Threads play no part: each fit runs on one.
TEST(FitModel, IsRepeatableToTheLastBit) {
    const std::vector maps{MakeMap("made", {.F0 = {0.6, 0.7}})};
    const auto fit = [&] { return FitModel(ModelOf<EscapeOfAlpha>(), TotalSamples(maps)); };
    EXPECT_EQ(fit().Values(), fit().Values());
}

// Expected: the made surface has p0 = 0.7 < 1, out of reach of the bounded model: the bound
// holds, and says so.
TEST(FitModel, ABoundThatHoldsIsReported) {
    const std::vector maps{MakeMap("made", {.F0 = {0.6, 0.7}})};
    const LeastSquaresFit fit = FitModel(ModelOf<EscapeOfAlpha>(), TotalSamples(maps));
    EXPECT_TRUE(fit.parameters[1].at_bound);
    EXPECT_EQ(fit.parameters[1].value, 1);
    EXPECT_FALSE(fit.parameters[1].standard_error.has_value());
    EXPECT_TRUE(fit.parameters[0].standard_error.has_value());
}

// Expected: the constants of F0 that made the map; F1 has no exact answer there, but the refit
// must fit E_1 better than the published constants do.
TEST(RefitMayaux, FindsF0AndBeatsThePublishedF1) {
    const std::vector maps{MakeMap("made", {.F0 = {0.45, 0.8}})};
    const MayauxRefit refit = RefitMayaux(maps);
    EXPECT_NEAR(refit.Constants().F0.a, 0.45, 1e-6);
    EXPECT_NEAR(refit.Constants().F0.p, 0.8, 1e-6);
    const Formula published = AtInitialValues(FindModel("F1"), "published");
    double chi2 = 0, sum_w = 0;
    for (const Sample& sample : BounceSamples(maps, 1)) {
        chi2 += sample.weight * std::pow(published(sample.at) - sample.y, 2);
        sum_w += sample.weight;
    }
    EXPECT_LT(refit.F1.rmse, std::sqrt(chi2 / sum_w));
    const Formula formula = MayauxFormula(refit.Constants(), PoleGuard::kPort, "refit");
    EXPECT_EQ(formula.values[2], refit.F1.parameters[0].value);
    EXPECT_EQ(formula.model.name, "Mayaux18, guard 1e-5");
}

// Expected: a map whose bounces are themselves curves of the family, one set of constants each.
TEST(FitBounceFamily, RecoversEachBouncesConstants) {
    BounceHistogram map = MakeMap("made", {}, 60, 3);
    const auto curve = [](int k) {
        return BounceCurve<>{.A = 20.0 + 30 * k, .B = 3.0 + k, .C = 0.3 + 0.05 * k, .q = 1.5};
    };
    for (BounceBin& bin : map.bins)
        for (int k = 1; k <= 3; ++k)
            bin.bounce[k].mean = Evaluate(curve(k), UniformVisibility(bin.alpha));
    const std::vector<LeastSquaresFit> fits = FitBounceFamily({&map, 1}, {}, 3);
    ASSERT_EQ(fits.size(), 3);
    for (int k = 1; k <= 3; ++k) {
        EXPECT_NEAR(fits[k - 1].parameters[0].value / curve(k).A, 1, 1e-6) << k;
        EXPECT_NEAR(fits[k - 1].parameters[1].value / curve(k).B, 1, 1e-6) << k;
        EXPECT_NEAR(fits[k - 1].parameters[2].value / curve(k).C, 1, 1e-6) << k;
    }
    EXPECT_THROW(FitBounceFamily({&map, 1}, {}, 4), Error);
}

}  // namespace
}  // namespace plumb
