#include "fit/models/escape_alternatives.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <vector>

#include "tests/fit/light_laws.h"

namespace plumb {
namespace {

const std::array kForms{EscapeLinearOfV::kName,    TwoEscapesLinearOfV::kName,
                        EscapePowerOfAlpha::kName, EscapeOfClosures::kName,
                        EscapeScaledOfBoth::kName, EscapeRaisedOfBoth::kName,
                        TwoEscapesOfBoth::kName};

// Every corner of the constants' bounds, and where a fit starts: the laws hold for all of them.
TEST(EscapeForms, KeepTheLawsForAnyConstants) {
    for (const std::string_view name : kForms) {
        const Model& model = FindModel(name);
        const std::size_t n = model.parameters.size();
        int choices = 1;
        for (std::size_t j = 0; j < n; ++j) choices *= 3;
        for (int choice = 0; choice < choices; ++choice) {
            std::vector<double> p;
            for (int rest = choice; p.size() < n; rest /= 3) {
                const Parameter& at = model.parameters[p.size()];
                p.push_back(rest % 3 == 0 ? at.low : rest % 3 == 1 ? at.initial : at.high);
            }
            for (const double alpha : Shares()) {
                for (const double share : {0.0, 0.5, 1.0}) {
                    const UniformVisibility at(alpha);
                    const double V = std::lerp(LeastCosineVisibility(at),
                                               GreatestCosineVisibility(at), share);
                    ExpectLaws(
                        [&](double rho) {
                            return model.evaluate(p.data(),
                                                  {at, CosineVisibility(V), Albedo(rho)});
                        },
                        V,
                        std::string(name) + " " + testing::PrintToString(p) + " alpha " +
                            testing::PrintToString(alpha));
                }
            }
        }
    }
}

double At(std::string_view name, std::vector<double> p) {
    return FindModel(name).evaluate(
        p.data(), {UniformVisibility(0.5), CosineVisibility(0.36), Albedo(0.8)});
}

// Expected: g by hand at alpha = 1/2, V = 9/25, put into the family's own total.
TEST(EscapeForms, ByHand) {
    const auto with = [](double g) { return EscapeTotal(0.36, g, Albedo(0.8)); };
    EXPECT_NEAR(At(EscapeLinearOfV::kName, {0.25, 0.5}), with(0.43), kRounding);
    EXPECT_NEAR(At(EscapePowerOfAlpha::kName, {2}), with(0.25), kRounding);
    EXPECT_NEAR(At(EscapeOfClosures::kName, {0.5, 1}), with(1 - 0.8 * 0.5), kRounding);
    EXPECT_NEAR(At(EscapeScaledOfBoth::kName, {2, 0.5, 2}), with(2 * 0.6 * 0.25), kRounding);
    EXPECT_NEAR(At(EscapeRaisedOfBoth::kName, {0.1, 0.5, 2}), with(0.1 + 0.9 * 0.6 * 0.25),
                kRounding);
}

// Expected: with g_1 = g both are the one-escape family; with g_1 = 1 all light is gone after
// its first bounce, E = V + (1 - V) rho; with g_1 = 0 it waits one bounce longer,
// E = V + (1 - V) rho^2 g / (1 - rho (1 - g)).
TEST(TwoEscapes, AreOneWhereTheyAgreeAndApartWhereNot) {
    const double V = 0.36, rho = 0.8, one = EscapeTotal(V, 0.43, Albedo(rho));
    EXPECT_NEAR(At(TwoEscapesLinearOfV::kName, {0.25, 0.5, 0.25, 0.5}), one, kRounding);
    EXPECT_NEAR(At(TwoEscapesOfBoth::kName, {0.5, 2, 0.5, 2}),
                EscapeTotal(V, 0.15, Albedo(rho)), kRounding);
    EXPECT_NEAR(At(TwoEscapesLinearOfV::kName, {1, 0, 0.25, 0.5}), V + (1 - V) * rho,
                kRounding);
    EXPECT_NEAR(At(TwoEscapesLinearOfV::kName, {0, 0, 0.25, 0.5}), V + (one - V) * rho,
                kRounding);
}

}  // namespace
}  // namespace plumb
