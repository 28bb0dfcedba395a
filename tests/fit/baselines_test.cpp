#include "fit/baselines.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "fit/model_fit.h"
#include "fit/models/gtao_cubic.h"

namespace plumb {
namespace {

// Expected: at rho = 1, V -> 0 the cubic rises with slope c1 + c0 = 3.4455; at V = 1 its value
// is a + b + c = rho (a1 + b1 + c1) + a0 + b0 + c0 = 0.0005 rho + 0.9996.
TEST(GtaoCubic, EndsByHand) {
    EXPECT_NEAR(Evaluate(kJimenez16, CosineVisibility(1e-9), Albedo(1)) / 1e-9, 3.4455, 1e-6);
    EXPECT_NEAR(Evaluate(kJimenez16, CosineVisibility(1), Albedo(0.8)), 1, 5e-15);
    EXPECT_EQ(Evaluate(kJimenez16, CosineVisibility(0), Albedo(0.8)), 0);
}

// Expected: c < 1 for rho < (1 - 0.6903) / 2.7552 = 0.1124, so that the cubic of a small V is
// below V and max() decides.
TEST(GtaoCubic, NeverDarkerThanTheDirectLight) {
    EXPECT_EQ(Evaluate(kJimenez16, CosineVisibility(0.001), Albedo(0.1)), 0.001);
    EXPECT_GT(Evaluate(kJimenez16, CosineVisibility(0.001), Albedo(0.13)), 0.001);
}

// Expected: V = 1/4 and 1/2 of the wedges of 60 and 90 degrees at rho = 0.8, by an independent
// program, to the digits given.
TEST(GtaoCubic, OnTheWedges) {
    EXPECT_NEAR(Evaluate(kJimenez16, CosineVisibility(0.25), Albedo(0.8)), 0.5443, 5e-5);
    EXPECT_NEAR(Evaluate(kJimenez16, CosineVisibility(0.5), Albedo(0.8)), 0.8111, 5e-5);
}

// Expected: as printed in [Jimenez16], the multi-bounce approximation, with AO in place of V:
// a = 2.0404 albedo - 0.3324, b = -4.7951 albedo + 0.6417, c = 2.7552 albedo + 0.6903.
TEST(GtaoCubic, TheModelStartsAtThePublishedConstants) {
    EXPECT_EQ(AtInitialValues(ModelOf<GtaoCubicModel>(), "").values,
              (std::vector<double>{2.0404, -0.3324, -4.7951, 0.6417, 2.7552, 0.6903}));
    const auto names = ModelOf<GtaoCubicModel>().parameters;
    std::string text;
    for (const Parameter& parameter : names) text += std::string(parameter.name) + " ";
    EXPECT_EQ(text, "a1 a0 b1 b0 c1 c0 ");
}

// Expected: the constants that made the samples, which the cubic fits exactly. Tolerance: the
// solver's own, times the condition of six powers (about 1e3).
TEST(GtaoCubic, IsRefitted) {
    const std::vector<double> made{1.5, -0.25, -3.5, 0.5, 2.25, 0.75};
    const Formula truth{"made", ModelOf<GtaoCubicModel>(), made};
    std::vector<Sample> samples;
    for (int i = 1; i < 20; ++i) {
        for (int r = 1; r < 10; ++r) {
            Sample sample;
            sample.at = {{}, CosineVisibility(i / 20.0), Albedo(r / 10.0)};
            sample.y = truth(sample.at);
            samples.push_back(sample);
        }
    }
    const LeastSquaresFit fit = FitModel(ModelOf<GtaoCubicModel>(), samples, {.starts = 2});
    EXPECT_TRUE(fit.converged);
    for (std::size_t j = 0; j < made.size(); ++j) {
        EXPECT_NEAR(fit.parameters[j].value, made[j], 1e-5) << fit.parameters[j].name;
    }
}

TEST(Baselines, PredictTotalsUnderNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const Formula& formula : Baselines()) {
        EXPECT_TRUE(formula.model.inputs.rho) << formula.name;
        EXPECT_EQ(formula.values.size(), formula.model.parameters.size()) << formula.name;
        EXPECT_TRUE(names.insert(formula.name).second) << formula.name;
    }
    EXPECT_EQ(names.size(), 9);
}

// Expected: with alpha = 1/3 and V = 1/4 each formula must show which of the two it was fed.
TEST(Baselines, ReadTheVisibilityThatTheySay) {
    const LightPoint wedge{UniformVisibility(1.0 / 3), CosineVisibility(0.25), Albedo(0.8)};
    const std::map<std::string, double> expected{
        {"plain alpha", 1.0 / 3},
        {"plain V", 0.25},
        {"Mayaux18", 0.8612},
        {"GTAO cubic", 0.5443},
        {"GTAO cubic, fed alpha", Evaluate(kJimenez16, CosineVisibility(1.0 / 3), Albedo(0.8))},
        {"cavity", 0.625}};
    int found = 0;
    for (const Formula& formula : Baselines())
        if (const auto it = expected.find(formula.name); it != expected.end()) {
            EXPECT_NEAR(formula(wedge), it->second, 5e-5) << formula.name;  // Four digits.
            ++found;
        }
    EXPECT_EQ(found, expected.size());
}

}  // namespace
}  // namespace plumb
