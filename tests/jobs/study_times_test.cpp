// Whose time stands in which row, by a clock whose intervals are known: two studies that time the
// same things all alike would not show that rows or columns are swapped.
#include <gtest/gtest.h>

#include "jobs/screen_space/technique.h"
#include "rays/embree/embree_caster.h"
#include "tests/jobs/made_scenes.h"
#include "tests/jobs/read_results.h"
#include "tests/jobs/stepping_clock.h"

namespace plumb {
namespace {

ViewTruth TruthOf(const Scene& scene, const RayCaster& caster) {
    const std::vector<Falloff> falloffs{Falloff::kHard, Falloff::kSao};
    return MeasureViewTruth(caster, scene, scene.cameras.front(), falloffs,
                            {.radius_m = 1, .spp = 16, .far = false});
}

// Expected, by hand: six steps from the taps on and the picture without a border, 7 things; one round
// after one that warms up: 8, 9 ... 14 s. What is made of thousands of taps has no time.
TEST(StudyTimes, OfTheBudgetStandBesideTheirSteps) {
    const Scene scene = FloorAndWall(48, 27);
    const EmbreeCaster caster(scene);
    const ResultTable budget = BudgetTable(
        SaoWith("supplement2012", {.radius_m = 1}), scene, scene.cameras.front(), caster,
        TruthOf(scene, caster), {.many_taps = 8, .stride_px = 2, .guard_px = 8, .rounds = 1},
        SteppingClock());
    ASSERT_EQ(budget.rows.size(), 5u + 6 + 1);
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_TRUE(std::holds_alternative<std::monostate>(budget.At(k, "ms"))) << k;
    }
    for (std::size_t k = 5; k < budget.rows.size(); ++k) {
        EXPECT_EQ(NumberAt(budget, k, "ms"), 1e3 * double(8 + k - 5)) << k;
    }
}

// Expected, by hand: six widths, drawn and computed in turns, 12 things: 13, 14 ... 24 s.
TEST(StudyTimes, OfTheGuardBandAreOfDrawingThenOfSao) {
    const Scene scene = FloorAndWall(64, 48);
    const EmbreeCaster caster(scene);
    const ResultTable guards =
        GuardTable(scene, scene.cameras.front(), TruthOf(scene, caster),
                   SaoWith("supplement2012", {.radius_m = 1}), 1, SteppingClock());
    ASSERT_EQ(guards.rows.size(), 6u);
    for (std::size_t k = 0; k < 6; ++k) {
        EXPECT_EQ(NumberAt(guards, k, "draw_ms"), 1e3 * double(13 + 2 * k));
        EXPECT_EQ(NumberAt(guards, k, "sao_ms"), 1e3 * double(14 + 2 * k));
    }
}

// Expected: 10 cm and each quarter of a metre up to 2 m, as in the paper's figure 5; of each radius 3
// things, two rounds after one: of the k-th the intervals 9 k + 1 ... 9 k + 9, of which the last six
// count.
TEST(StudyTimes, ByRadiusAreInTheirColumns) {
    const Scene scene = FloorAndWall(48, 27);
    const ResultTable radii =
        RadiiTable(scene, scene.cameras.front(), {48, 27, 8}, 2, SteppingClock());
    ASSERT_EQ(radii.rows.size(), 9u);
    for (std::size_t k = 0; k < 9; ++k) {
        EXPECT_EQ(NumberAt(radii, k, "radius_m"), k == 0 ? 0.1 : 0.25 * double(k));
        const double first = 9 * double(k);
        const char* columns[] = {"with_pyramid_ms", "without_pyramid_ms", "alchemy_ms"};
        for (std::size_t t = 0; t < 3; ++t) {
            const Measured& time = MeasuredAt(radii, k, columns[t]);
            EXPECT_EQ(time.interval.low, 1e3 * (first + 4 + double(t)));
            EXPECT_EQ(time.interval.high, 1e3 * (first + 7 + double(t)));
        }
    }
}

}  // namespace
}  // namespace plumb
