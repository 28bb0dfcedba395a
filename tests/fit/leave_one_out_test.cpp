#include "fit/leave_one_out.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/parallel.h"
#include "fit/baselines.h"
#include "fit/mayaux_refit.h"
#include "made_maps.h"

namespace plumb {
namespace {

// Expected: two alike maps and a different one. Whoever learns from the two alike knows nothing
// of the third: its constants are theirs, exactly; whoever sees the third is pulled off.
TEST(LeaveOneMapOut, TheMapScoredIsTheOneNotSeen) {
    const MadeSurface usual, odd{.g = {.a = 0.7, .b = 0.9}};
    const std::vector maps{MakeMap("a", usual), MakeMap("b", usual), MakeMap("odd", odd)};
    const std::vector methods{Refitted(ModelOf<EscapeOfV>())};
    const std::vector<HeldOut> rows = LeaveOneMapOut(maps, methods);
    ASSERT_EQ(rows.size(), 1);
    const HeldOut& row = rows[0];
    EXPECT_EQ(row.scores.formula, "escape of V, refitted");
    ASSERT_EQ(row.formulas.size(), 3);
    EXPECT_NEAR(row.formulas[2].values[0], usual.g.a, 1e-6);
    EXPECT_NEAR(row.formulas[2].values[1], usual.g.b, 1e-6);
    EXPECT_LT(row.formulas[0].values[0], usual.g.a - 0.01);
    EXPECT_EQ(row.scores.maps[2].rms, ScoreOf(row.formulas[2], maps[2]).rms);
    EXPECT_GT(row.scores.maps[2].rms, 0.01);
    EXPECT_EQ(row.scores.maps[0].rms, row.scores.maps[1].rms);
}

// Expected: a formula that learns nothing has the same score held out as not.
TEST(LeaveOneMapOut, BaselinesNeedNoRefit) {
    const std::vector maps{MakeMap("a"), MakeMap("b", {.g = {.a = 0.7, .b = 0.9}})};
    std::vector<FittingMethod> methods;
    for (const Formula& formula : Baselines()) methods.push_back(Unfitted(formula));
    const std::vector<HeldOut> rows = LeaveOneMapOut(maps, methods);
    ASSERT_EQ(rows.size(), methods.size());
    for (std::size_t c = 0; c < rows.size(); ++c) {
        const ScoreRow seen = ScoreOver(Baselines()[c], maps);
        EXPECT_EQ(rows[c].scores.formula, seen.formula);
        EXPECT_EQ(rows[c].scores.pooled.rms, seen.pooled.rms) << seen.formula;
    }
}

// Expected: the paper's way learns from E_0 and E_1 of all other maps, and of these only: the
// constants of two alike maps are found exactly, those of two different ones lie between.
TEST(LeaveOneMapOut, ThePapersWayIsAFittingMethod) {
    const std::vector maps{MakeMap("a", {.F0 = {0.45, 0.8}}), MakeMap("b", {.F0 = {0.45, 0.8}}),
                           MakeMap("c", {.F0 = {0.7, 0.8}})};
    const std::vector methods{RefittedAsPublished(PoleGuard::kPort)};
    const HeldOut row = LeaveOneMapOut(maps, methods).at(0);
    EXPECT_NEAR(row.formulas[2].values[0], 0.45, 1e-6);
    EXPECT_GT(row.formulas[0].values[0], 0.5);
    EXPECT_LT(row.formulas[0].values[0], 0.65);
    EXPECT_EQ(
        row.formulas[2].values,
        MayauxFormula(RefitMayaux({maps.data(), 2}).Constants(), PoleGuard::kPort, "").values);
}

TEST(LeaveOneMapOut, IsTheSameOnAnyNumberOfThreads) {
    const std::vector maps{MakeMap("a"), MakeMap("b", {.g = {.a = 0.7, .b = 0.9}}),
                           MakeMap("c", {.g = {.a = 0.8, .b = 0.3}})};
    const std::vector methods{Refitted(ModelOf<EscapeOfV>())};
    const auto run = [&](int threads) {
        SetThreadCount(threads);
        const auto rows = LeaveOneMapOut(maps, methods);
        SetThreadCount(0);
        return rows[0].scores.pooled.rms;
    };
    EXPECT_EQ(run(1), run(4));
}

TEST(LeaveOneMapOut, NeedsTwoMaps) {
    const std::vector maps{MakeMap("a")};
    EXPECT_THROW(LeaveOneMapOut(maps, {}), Error);
}

}  // namespace
}  // namespace plumb
