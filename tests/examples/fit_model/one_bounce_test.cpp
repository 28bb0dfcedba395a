#include "tests/examples/fit_model/one_bounce.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "fit/model_fit.h"
#include "jobs/light/fit_constants.h"

namespace plumb {
namespace {

// Expected by hand: 1/2 (1 + 1/2 x 4/5 x 1/2) = 0.6.
TEST(OneBounce, ByHand) {
    const Formula formula{"", FindModel("one bounce"), {0.5}};
    EXPECT_NEAR(formula({.V = CosineVisibility(0.5), .rho = Albedo(0.8)}), 0.6, 1e-15);
}

// The model is linear in c, so exact samples give it back to a few roundings.
TEST(OneBounce, IsFitted) {
    const Formula made{"", FindModel("one bounce"), {0.7}};
    std::vector<Sample> samples;
    for (const double V : {0.2, 0.5, 0.8}) {
        Sample sample{.at = {.V = CosineVisibility(V), .rho = Albedo(0.6)}};
        sample.y = made(sample.at);
        samples.push_back(sample);
    }
    EXPECT_NEAR(FitModel(made.model, samples).parameters.at(0).value, 0.7, 1e-9);
}

// From the build list it follows into `plumb fit`: fitted, held out, compared with the other forms.
TEST(OneBounce, IsARowOfTheReport) {
    FitSettings settings;
    settings.simulate.slices.slices = 4;
    settings.simulate.bounces = 4;
    settings.starts = 1;
    settings.bootstrap_replicates = 0;
    settings.study_convergence = settings.study_amplitude = false;
    std::vector<Surface> surfaces;
    for (const char* map :
         {"make:stone_wall:24", "make:cobbles:24", "make:terrain:24", "make:bricks:24"}) {
        surfaces.push_back(LoadSurface(map));
    }
    const FitReport report =
        FitConstants(surfaces, settings, {.version = "test", .command = "test"}).report;
    const auto row = std::find_if(
        report.formulas.begin(), report.formulas.end(),
        [](const FormulaRecord& record) { return record.name == "one bounce, refitted"; });
    ASSERT_NE(row, report.formulas.end());
    EXPECT_TRUE(row->held_out.has_value());
    ASSERT_TRUE(report.choice.has_value());
    EXPECT_THAT(report.choice->forms,
                testing::Contains(testing::Field(&FormScore::form, "one bounce")));
}

}  // namespace
}  // namespace plumb
