#include "jobs/light/form_choice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "fit/models/escape_alternatives.h"
#include "fit/models/escape_of_alpha_and_v.h"
#include "fit/models/uniform_cavity.h"

namespace plumb {
namespace {

const double kAlbedos[] = {0.2, 0.5, 0.9};

double ByHand(double V, double alpha, double b, double c, double rho) {
    const double g = std::pow(V, b) * std::pow(alpha, c);
    return V + (1 - V) * rho * g / (1 - rho * (1 - g));
}

double CavityByHand(double V, double rho) {
    return V / (1 - rho * (1 - V));
}

struct Point {
    double alpha, V;
    std::int64_t count;
};

// No grid: a few bins, weights that differ, and V far from any function of alpha.
const Point kPoints[] = {{0.2, 0.3, 10},  {0.3, 0.15, 20}, {0.45, 0.6, 5},  {0.6, 0.4, 40},
                         {0.75, 0.9, 30}, {0.9, 0.85, 7},  {0.97, 0.99, 60}};

/// Light on the points by g = V^b alpha^c, the same in every histogram.
SurfaceLight MadeLight(const std::string& name, double b, double c) {
    SurfaceLight light;
    light.name = name;
    for (BounceHistogram* histogram : {&light.over_alpha, &light.over_V, &light.over_both}) {
        histogram->surface = name;
        histogram->albedos.assign(std::begin(kAlbedos), std::end(kAlbedos));
        for (const Point& point : kPoints) {
            BounceBin bin;
            bin.count = point.count;
            bin.alpha = point.alpha;
            bin.V = point.V;
            for (const double rho : kAlbedos)
                bin.total.push_back({.mean = ByHand(point.V, point.alpha, b, c, rho)});
            histogram->bins.push_back(bin);
        }
    }
    light.over_V.binned_by = BinnedBy::kCosineVisibility;
    light.over_both.binned_by = BinnedBy::kBothVisibilities;
    return light;
}

/// sqrt of the mean over albedos and facets of (f - E(b, c))^2.
template <class F>
double RmsByHand(const F& f, double b, double c) {
    double sum = 0, count = 0;
    for (const Point& point : kPoints) {
        for (const double rho : kAlbedos) {
            const double d = f(point, rho) - ByHand(point.V, point.alpha, b, c, rho);
            sum += double(point.count) * d * d;
            count += double(point.count);
        }
    }
    return std::sqrt(sum / count);
}

// Maps 1, 3, 5 obey one pair of constants, maps 2 and 4 others. Expected: the form that made the
// light wins on the choosing half without error; on the other half its error is that of the
// choosing half's constants there, worked out here. Were the halves swapped, or were the
// reporting maps fitted to, it would be another.
TEST(ChooseForm, ChoosesOnOneHalfAndReportsOnTheOther) {
    const std::vector<SurfaceLight> lights{MadeLight("a", 0.3, 0.6), MadeLight("b", 0.9, 0.2),
                                           MadeLight("c", 0.3, 0.6), MadeLight("d", 0.5, 1.1),
                                           MadeLight("e", 0.3, 0.6)};
    const std::vector<std::string_view> forms{
        UniformCavityModel::kName, EscapePowerOfAlpha::kName, EscapeOfAlphaAndV::kName};
    const auto choice = ChooseForm(lights, forms, {}, {.starts = 2});
    ASSERT_TRUE(choice);
    EXPECT_THAT(choice->choosing, testing::ElementsAre("a", "c", "e"));
    EXPECT_THAT(choice->reporting, testing::ElementsAre("b", "d"));
    ASSERT_EQ(choice->forms.size(), 3u);
    EXPECT_EQ(choice->forms[0].constants, 0);
    EXPECT_EQ(choice->forms[1].constants, 1);
    EXPECT_EQ(choice->forms[2].constants, 2);
    EXPECT_EQ(choice->Winner().form, EscapeOfAlphaAndV::kName);

    const auto pooled = [](double one, double two) {
        return std::sqrt((one * one + two * two) / 2);
    };
    const auto both = [](const Point& at, double rho) {
        return ByHand(at.V, at.alpha, 0.3, 0.6, rho);
    };
    EXPECT_LT(choice->forms[2].choosing_rms, 1e-7);
    EXPECT_NEAR(choice->forms[2].reporting_rms,
                pooled(RmsByHand(both, 0.9, 0.2), RmsByHand(both, 0.5, 1.1)), 1e-6);
    const auto cavity = [](const Point& at, double rho) { return CavityByHand(at.V, rho); };
    EXPECT_NEAR(choice->forms[0].choosing_rms, RmsByHand(cavity, 0.3, 0.6), 1e-12);
    EXPECT_NEAR(choice->forms[0].reporting_rms,
                pooled(RmsByHand(cavity, 0.9, 0.2), RmsByHand(cavity, 0.5, 1.1)), 1e-12);

    // One constant: the best of a fine scan. All choosing maps are alike, so that what is held
    // out is what was fitted to.
    double best = 1;
    for (double c = 0; c < 3; c += 1e-4) {
        const auto power = [c](const Point& at, double rho) {
            return ByHand(at.V, at.alpha, 0, c, rho);
        };
        best = std::min(best, RmsByHand(power, 0.3, 0.6));
    }
    EXPECT_NEAR(choice->forms[1].choosing_rms, best, 1e-6);
}

TEST(ChooseForm, NeedsFourMaps) {
    const std::vector<SurfaceLight> lights{MadeLight("a", 0.3, 0.6), MadeLight("b", 0.9, 0.2),
                                           MadeLight("c", 0.3, 0.6)};
    EXPECT_FALSE(ChooseForm(lights, ComparedForms(), {}, {}));
}

}  // namespace
}  // namespace plumb
