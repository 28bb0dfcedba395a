#include "jobs/light/fit_constants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/parallel.h"
#include "reports/render.h"
#include "tests/closed_forms/analytic_fields.h"

namespace plumb {
namespace {

FitSettings Brief() {
    FitSettings settings;
    settings.simulate.slices.slices = 8;
    settings.simulate.bounces = 4;
    settings.starts = 2;
    settings.bootstrap_replicates = kFewestReplicates;
    settings.study_convergence = settings.study_amplitude = false;
    return settings;
}

std::vector<Surface> ThreeWalls() {
    std::vector<Surface> surfaces;
    for (const char* name : {"make:stone_wall:40", "make:cobbles:40", "make:terrain:40"}) {
        surfaces.push_back(LoadSurface(name));
    }
    return surfaces;
}

FitReport Fit(std::span<const Surface> surfaces) {
    return FitConstants(surfaces, Brief(), {.version = "test", .command = "plumb fit"}).report;
}

const FormulaRecord& Named(const FitReport& report, const std::string& name) {
    return *std::find_if(report.formulas.begin(), report.formulas.end(),
                         [&](const FormulaRecord& record) { return record.name == name; });
}

// The claim of the project (issue of job 1): the refitted bounded families have, on maps that they
// have not seen, at most half the error of the published constants, and no pole.
TEST(FitConstants, BoundedFamiliesHalveThePublishedErrorOnUnseenMaps) {
    const std::vector<Surface> surfaces = ThreeWalls();
    const FitReport report = Fit(surfaces);
    Validate(report);
    const double published = Named(report, report.published).in_sample.pooled.rms;
    for (const char* name : {"escape of V, refitted", "escape of alpha and V, refitted",
                             "bent escape of V, refitted"}) {
        const FormulaRecord& record = Named(report, name);
        ASSERT_TRUE(record.held_out.has_value());
        EXPECT_LE(record.held_out->pooled.rms, published / 2) << name;
        EXPECT_EQ(record.held_out->pooled.poles, 0) << name;
        EXPECT_EQ(record.held_out->pooled.out_of_range, 0) << name;
    }
}

// Expected: no formula of an input beats that input's floor facet by facet. Tolerance: the scores
// and the floor see the same facets, so only the bins' width may help: 1e-3 at 100 bins.
TEST(FitConstants, NoFormulaBeatsTheFloorOfItsInput) {
    const FitReport report = Fit(ThreeWalls());
    int compared = 0;
    for (const FormulaRecord& record : report.formulas) {
        for (std::size_t m = 0; m < report.floors.size(); ++m) {
            const ModelInputs& inputs = record.formula.model.inputs;
            if (inputs.alpha && inputs.V) continue;
            const double floor = inputs.V ? report.floors[m].of_V : report.floors[m].of_alpha;
            EXPECT_GE(record.facet_rms[m], floor - 1e-3) << record.name;
            ++compared;
        }
    }
    EXPECT_GE(compared, 30);
}

TEST(FitConstants, SameBytesOnOneThreadAndOnTwo) {
    const std::vector<Surface> surfaces = ThreeWalls();
    std::vector<std::string> reports;
    for (const int threads : {1, 2}) {
        SetThreadCount(threads);
        reports.push_back(ToJsonText(DocumentOf(Fit(surfaces))));
    }
    SetThreadCount(0);
    EXPECT_EQ(reports[0], reports[1]);
}

TEST(FitConstants, RefusesMapsWithNothingToFit) {
    std::vector<Surface> flat;
    flat.push_back({MakeFlat({.width_texels = 8, .height_texels = 8}), {}});
    try {
        Fit(flat);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("nothing to fit"), std::string::npos);
    }
    EXPECT_THROW(Fit({}), Error);
}

TEST(FitConstants, OneMapIsFittedButNothingIsHeldOut) {
    const std::vector<Surface> surfaces = ThreeWalls();
    const FitReport report = Fit({surfaces.data(), 1});
    EXPECT_FALSE(Named(report, report.recommended).held_out.has_value());
    EXPECT_LT(Named(report, report.recommended).in_sample.pooled.rms, 0.05);
}

// Expected: the faults of the published formula where root finding by hand put them.
TEST(FitConstants, ReportsWhereThePublishedFormulaBreaks) {
    const std::vector<Surface> surfaces = ThreeWalls();
    const FitReport report = Fit({surfaces.data(), 1});
    const FormulaFaults& published = report.faults.front();
    EXPECT_EQ(published.name, "published");
    const auto half =
        std::find_if(published.poles.begin(), published.poles.end(),
                     [](const FormulaFaults::Pole& pole) { return pole.rho.value == 0.5; });
    ASSERT_NE(half, published.poles.end());
    ASSERT_FALSE(half->alphas.empty());
    EXPECT_NEAR(half->alphas.front().value, 0.970264, 1e-6);
    ASSERT_FALSE(published.above_one.empty());
    EXPECT_NEAR(published.above_one.front().low, 0.949253, 1e-6);
    ASSERT_FALSE(published.above_bound.empty());
    EXPECT_NEAR(published.above_bound.front().low, 0.9375, 1e-6);
}

}  // namespace
}  // namespace plumb
