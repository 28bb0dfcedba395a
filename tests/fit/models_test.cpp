#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "core/error.h"
#include "fit/model.h"
#include "fit/models/direct_factor.h"
#include "fit/models/escape_probability.h"

namespace plumb {
namespace {

TEST(Models, HaveDistinctNamesAndInitialValuesWithinTheirBounds) {
    std::set<std::string_view> names;
    for (const Model& model : AllModels()) {
        EXPECT_TRUE(names.insert(model.name).second) << model.name;
        for (const Parameter& parameter : model.parameters) {
            EXPECT_LT(parameter.low, parameter.high) << model.name << " " << parameter.name;
            EXPECT_LE(parameter.low, parameter.initial) << model.name << " " << parameter.name;
            EXPECT_GE(parameter.high, parameter.initial) << model.name << " " << parameter.name;
        }
    }
}

TEST(Models, InputsFollowFromTheSignature) {
    EXPECT_EQ(ModelOf<DirectFactorModel>().inputs, (ModelInputs{.alpha = true}));
    EXPECT_EQ(ModelOf<EscapeOfV>().inputs, (ModelInputs{.V = true, .rho = true}));
    EXPECT_EQ(ModelOf<EscapeOfAlpha>().inputs, (ModelInputs{.alpha = true, .rho = true}));
}

// Expected: what the model does not read is NaN here, and must not leak into the value.
TEST(Models, ReadNoMoreThanTheirInputs) {
    for (const Model& model : AllModels()) {
        LightPoint at;
        if (model.inputs.alpha) at.alpha = UniformVisibility(0.4);
        if (model.inputs.V) at.V = CosineVisibility(0.4);
        if (model.inputs.rho) at.rho = Albedo(0.6);
        EXPECT_TRUE(std::isfinite(AtInitialValues(model, "")(at))) << model.name;
    }
}

// Expected: central differences. Their error is h^2 f''' / 6 + epsilon |f| / h; with h = 1e-5
// of the parameter's size both are below 1e-9 of the slopes and values here, which are of order
// 1 at most; 1e-7 leaves room for third derivatives of order 1000. p0 of "escape of alpha"
// starts on its bound; the formula itself does not end there.
TEST(Models, DerivativesAreThoseOfTheValue) {
    int compared = 0;
    for (const Model& model : AllModels())
        for (double alpha : {0.15, 0.4, 0.8})
            for (double rho : {0.3, 0.8}) {
                const LightPoint at{UniformVisibility(alpha), CosineVisibility(0.9 * alpha),
                                    Albedo(rho)};
                std::vector<double> p = AtInitialValues(model, "").values;
                std::vector<double> gradient(p.size());
                // Dual numbers divide by a reciprocal: some roundings of a number up to 1.
                EXPECT_NEAR(model.differentiate(p.data(), at, gradient.data()),
                            model.evaluate(p.data(), at), 2e-15)
                    << model.name;
                for (std::size_t j = 0; j < p.size(); ++j) {
                    const double middle = p[j], h = 1e-5 * std::abs(middle);
                    p[j] = middle + h;
                    const double above = model.evaluate(p.data(), at);
                    p[j] = middle - h;
                    const double below = model.evaluate(p.data(), at);
                    p[j] = middle;
                    EXPECT_NEAR(gradient[j], (above - below) / (2 * h), 1e-7)
                        << model.name << " " << model.parameters[j].name << " alpha " << alpha;
                    ++compared;
                }
            }
    EXPECT_GE(compared, 100);
}

TEST(Models, AnUnknownNameIsAnErrorThatListsTheKnown) {
    try {
        FindModel("F2");
        FAIL();
    } catch (const Error& error) {
        EXPECT_THAT(error.what(), testing::StartsWith(
                                      "model = F2, must be one of F0; F1; F1, free exponents"));
    }
}

}  // namespace
}  // namespace plumb
