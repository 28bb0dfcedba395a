#include "score/monotone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/score/made_images.h"

namespace plumb {
namespace {

double SquaresOf(const MonotoneMap& map, const std::vector<MonotoneSample>& samples) {
    double sum = 0;
    for (const MonotoneSample& s : samples) sum += std::pow(map(s.x) - s.y, 2);
    return sum;
}

/// The least sum of squares of a rising f with values at `n` sorted x, by trying every way to
/// cut them into runs of one value each, the run's mean, and keeping those that rise.
double BruteForce(const std::vector<double>& y) {
    const int n = int(y.size());
    double best = INFINITY;
    for (int cuts = 0; cuts < 1 << (n - 1); ++cuts) {
        double sum = 0, before = -INFINITY;
        bool rises = true;
        for (int begin = 0; begin < n;) {
            int end = begin + 1;
            while (end < n && !(cuts >> (end - 1) & 1)) ++end;
            double mean = 0;
            for (int k = begin; k < end; ++k) mean += y[k] / (end - begin);
            for (int k = begin; k < end; ++k) sum += (y[k] - mean) * (y[k] - mean);
            rises = rises && mean >= before;
            before = mean;
            begin = end;
        }
        if (rises) best = std::min(best, sum);
    }
    return best;
}

// Worked by hand: 1 3 2 4 has one violator, 3 > 2, which become 2.5 each.
TEST(Monotone, FourSamplesByHand) {
    const MonotoneMap map = FitMonotone({{3, 2}, {1, 1}, {4, 4}, {2, 3}});  // Not in order.
    ASSERT_EQ(map.levels.size(), 3u);
    EXPECT_EQ(map(1), 1);
    EXPECT_EQ(map(2), 2.5);
    EXPECT_EQ(map(2.7), 2.5);
    EXPECT_EQ(map(3), 2.5);
    EXPECT_EQ(map(4), 4);
    EXPECT_EQ(map(1.5), 1.75);  // Half way between the levels 1 and 2.5.
    EXPECT_EQ(map(0), 1);
    EXPECT_EQ(map(9), 4);
}

TEST(Monotone, EqualXShareOneValue) {
    const MonotoneMap map = FitMonotone({{1, 0}, {1, 4}, {2, 3}});
    EXPECT_EQ(map(1), 2);
    EXPECT_EQ(map(2), 3);
    // Not even where the pair, taken one by one, would rise and violate with what follows.
    EXPECT_EQ(FitMonotone({{1, 0}, {1, 4}, {2, 1}})(1), 5.0 / 3);
}

TEST(Monotone, AgreesWithBruteForce) {
    for (int run = 0; run < 200; ++run) {
        std::vector<MonotoneSample> samples;
        std::vector<double> y;
        for (int k = 0; k < 9; ++k) {
            y.push_back(0.1 * k + 0.5 * MadeNormal(1, k, run));
            samples.push_back({double(k), y.back()});
        }
        const double squares = SquaresOf(FitMonotone(samples), samples);
        EXPECT_NEAR(squares, BruteForce(y), 1e-12) << run;
    }
}

TEST(Monotone, OfRisingDataIsTheDataAndOfFallingDataTheMean) {
    std::vector<MonotoneSample> rising, falling;
    for (int k = 0; k < 10; ++k) {
        rising.push_back({double(k), double(k * k)});
        falling.push_back({double(k), double(-k)});
    }
    EXPECT_EQ(SquaresOf(FitMonotone(rising), rising), 0);
    const MonotoneMap map = FitMonotone(falling);
    ASSERT_EQ(map.levels.size(), 1u);
    EXPECT_DOUBLE_EQ(map.levels[0].y, -4.5);
}

}  // namespace
}  // namespace plumb
