// The oracle against every allocation there is, on pictures small enough for that, and its laws.
#include "screen_space/antialiasing/sample_oracle.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "tests/antialiasing/made_pictures.h"

namespace plumb {
namespace {

using testing::ElementsAre;

constexpr SampleDraw kDraws[] = {SampleDraw::kIndependent, SampleDraw::kOfWindow};

Image<double> Variances(int width, int height, std::uint64_t seed) {
    Image<double> v(width, height);
    for (std::uint64_t i = 0; i < v.Pixels().size(); ++i) {
        // Of all sizes, some of them nothing.
        const double u = RandomUnit(seed, i, 0, 0);
        v.Pixels()[i] = u < 0.2 ? 0 : std::pow(10, -4 * RandomUnit(seed, i, 1, 0));
    }
    return v;
}

double F(int k, int n, SampleDraw draw) {
    return draw == SampleDraw::kIndependent ? 1.0 / k : double(n - k) / ((n - 1.0) * k);
}

struct Tried {
    int samples;
    double mse;
};

/// Every allocation of 1 to n samples to each pixel.
std::vector<Tried> EveryAllocation(const Image<double>& v, int n, SampleDraw draw) {
    std::vector<Tried> tried;
    const std::size_t P = v.Pixels().size();
    const int all = int(std::lround(std::pow(n, double(P))));
    for (int code = 0; code < all; ++code) {
        Tried one{0, 0};
        int rest = code;
        for (std::size_t p = 0; p < P; ++p, rest /= n) {
            const int k = rest % n + 1;
            one.samples += k;
            one.mse += v.Pixels()[p] * F(k, n, draw) / double(P);
        }
        tried.push_back(one);
    }
    return tried;
}

// Targets between the errors that can be had, so that no rounding decides; and exactly none.
TEST(LeastSamples, NoAllocationOfTinyPicturesIsBetter) {
    const int n = 4;
    int checked = 0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Image<double> v = Variances(3, 2, seed);
        for (const SampleDraw draw : kDraws) {
            const std::vector<Tried> tried = EveryAllocation(v, n, draw);
            const double worst = tried.front().mse;
            for (const double share : {0.91, 0.62, 0.4431, 0.3333, 0.2707, 0.1234, 0.021}) {
                const double target = worst * share;
                int least = std::numeric_limits<int>::max();
                for (const Tried& one : tried) {
                    if (one.mse <= target) least = std::min(least, one.samples);
                }
                const Allocation found = LeastSamples(v, n, target, draw);
                EXPECT_EQ(found.reached, least < std::numeric_limits<int>::max());
                if (!found.reached) continue;
                EXPECT_EQ(found.samples, least) << seed << " " << share;
                EXPECT_LE(found.mse, target);
                EXPECT_NEAR(found.mse, ExpectedMse(v, found.counts, n, draw), 1e-15);
                ++checked;
            }
        }
    }
    EXPECT_GT(checked, 200);
}

TEST(LeastError, NoAllocationOfTinyPicturesIsBetter) {
    const int n = 4;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Image<double> v = Variances(5, 1, seed);
        for (const SampleDraw draw : kDraws) {
            const std::vector<Tried> tried = EveryAllocation(v, n, draw);
            for (int samples = 5; samples <= 5 * n; ++samples) {
                double least = HUGE_VAL;
                for (const Tried& one : tried) {
                    if (one.samples <= samples) least = std::min(least, one.mse);
                }
                const Allocation found = LeastError(v, n, samples, draw);
                EXPECT_NEAR(found.mse, least, 1e-12 * tried.front().mse)
                    << seed << " " << samples;
                EXPECT_LE(found.samples, samples);
            }
        }
    }
}

// Two pixels, v = 1 and 1/4: gains 1/2, 1/6, 1/12 and 1/8, 1/24, 1/48.
TEST(LeastSamples, ByHand) {
    Image<double> v(2, 1);
    v.Pixels() = {1, 0.25};
    const auto with = [&](double sum) {
        return LeastSamples(v, 4, sum / 2, SampleDraw::kIndependent).counts.Pixels();
    };
    EXPECT_THAT(with(1.25), ElementsAre(1, 1));
    EXPECT_THAT(with(0.8), ElementsAre(2, 1));
    EXPECT_THAT(with(0.59), ElementsAre(3, 1));
    EXPECT_THAT(with(0.5), ElementsAre(3, 2));
    EXPECT_THAT(with(0.38), ElementsAre(4, 2));
    const Allocation too_much = LeastSamples(v, 4, 0.1, SampleDraw::kIndependent);
    EXPECT_FALSE(too_much.reached);
    EXPECT_THAT(too_much.counts.Pixels(), ElementsAre(4, 4));
    // The whole window has no error left.
    const Allocation none = LeastSamples(v, 4, 0, SampleDraw::kOfWindow);
    EXPECT_TRUE(none.reached);
    EXPECT_EQ(none.mse, 0);
    EXPECT_THAT(none.counts.Pixels(), ElementsAre(4, 4));
}

// Equal variances: ties are broken by rows, and no pixel is two samples ahead. Flat pixels get one.
TEST(LeastError, SharesEquallyAmongEquals) {
    Image<double> v(4, 2, 0.5);
    v(3, 1) = 0;
    const Allocation found = LeastError(v, 16, 7 * 2 + 3 + 1, SampleDraw::kIndependent);
    EXPECT_THAT(found.counts.Pixels(), ElementsAre(3, 3, 3, 2, 2, 2, 2, 1));
    EXPECT_TRUE(found.reached);
    const Allocation all = LeastError(v, 4, 8 * 4, SampleDraw::kIndependent);
    EXPECT_EQ(all.samples, 7 * 4 + 1);
    EXPECT_FALSE(all.reached);
}

// Neyman: k ~ sqrt v. With 120 samples for v = 1, 4, 9 that is 20, 40, 60.
TEST(LeastError, IsNeymansAllocation) {
    Image<double> v(3, 1);
    v.Pixels() = {1, 4, 9};
    EXPECT_THAT(LeastError(v, 255, 120, SampleDraw::kIndependent).counts.Pixels(),
                ElementsAre(20, 40, 60));
}

// Drawn without return: (n - k) / (n - 1) / k of the variance, the mean over all ways to draw k of
// the samples. By counting, n = 4: values 0, 1, 3, 7, pairs.
TEST(ExpectedMse, OfAWindowIsTheMeanOverAllDraws) {
    const double values[] = {0, 1, 3, 7}, mean = 11.0 / 4;
    double variance = 0, squares = 0;
    for (int i = 0; i < 4; ++i) {
        variance += std::pow(values[i] - mean, 2) / 4;
        for (int j = 0; j < i; ++j)
            squares += std::pow((values[i] + values[j]) / 2 - mean, 2) / 6;
    }
    const Image<double> v(1, 1, variance);
    EXPECT_NEAR(ExpectedMse(v, Image<std::uint8_t>(1, 1, 2), 4, SampleDraw::kOfWindow), squares,
                1e-12);
    EXPECT_EQ(ExpectedMse(v, Image<std::uint8_t>(1, 1, 4), 4, SampleDraw::kOfWindow), 0);
    EXPECT_EQ(ExpectedMse(v, Image<std::uint8_t>(1, 1, 1), 1, SampleDraw::kOfWindow), 0);
}

// Colours 0, 0, 1, 1 in red and a green that does not vary: 1/4 over three colours.
TEST(WindowVariances, ByHand) {
    Image<Rgb> samples(4, 2, Rgb{0.5f, 0.5f, 0.5f});
    samples(0, 0) = samples(1, 1) = {0, 0.5f, 0.5f};
    samples(1, 0) = samples(0, 1) = {1, 0.5f, 0.5f};
    EXPECT_THAT(WindowVariances(samples, 2).Pixels(), ElementsAre(0.25 / 3, 0));
}

TEST(ShareOfGain, IsOneForTheOracleAndNoughtForEqualShares) {
    const Image<double> v = Variances(40, 30, 3);
    for (const SampleDraw draw : kDraws) {
        const Allocation oracle = LeastError(v, 16, 3000, draw);
        const OracleShare best = ShareOfGain(v, oracle.counts, 16, draw);
        // A sum taken apart and put together again may ask for one sample more.
        EXPECT_NEAR(best.share, 1, 2.0 / 1200 / (best.uniform - best.oracle));
        EXPECT_EQ(best.used, 2.5);
        const OracleShare equal = ShareOfGain(v, Image<std::uint8_t>(40, 30, 5), 16, draw);
        EXPECT_NEAR(equal.share, 0, 1e-9);
        EXPECT_NEAR(equal.uniform, 5, 1e-9);
        EXPECT_LT(equal.oracle, 4);
    }
    const OracleShare flat =
        ShareOfGain(Image<double>(3, 3, 0.0), Image<std::uint8_t>(3, 3, 1), 16, kDraws[0]);
    EXPECT_TRUE(std::isnan(flat.share));
}

TEST(LeastSamples, IsTheSameOnAnyNumberOfThreads) {
    const Image<double> v = Variances(123, 77, 8);
    SetThreadCount(1);
    const Allocation one = LeastSamples(v, 64, 2e-3, SampleDraw::kIndependent);
    SetThreadCount(4);
    const Allocation four = LeastSamples(v, 64, 2e-3, SampleDraw::kIndependent);
    SetThreadCount(0);
    EXPECT_EQ(one.counts, four.counts);
    EXPECT_EQ(one.mse, four.mse);
    EXPECT_LE(one.mse, 2e-3);
    // One sample less, the last one given, would not do: its gain is the least.
    const Allocation less = LeastError(v, 64, one.samples - 1, SampleDraw::kIndependent);
    EXPECT_GT(less.mse, 2e-3);
}

TEST(SampleOracle, RefusesWhatCannotBe) {
    const Image<double> v(2, 2, 0.1);
    const SampleDraw draw = SampleDraw::kIndependent;
    EXPECT_THROW(LeastSamples(v, 0, 0.1, draw), Error);
    EXPECT_THROW(LeastSamples(v, 256, 0.1, draw), Error);
    EXPECT_THROW(LeastSamples(v, 4, -1, draw), Error);
    EXPECT_THROW(LeastSamples(v, 4, std::nan(""), draw), Error);
    EXPECT_THROW(LeastSamples(Image<double>(1, 1, -0.1), 4, 0.1, draw), Error);
    EXPECT_THROW(LeastSamples(Image<double>(1, 1, std::nan("")), 4, 0.1, draw), Error);
    EXPECT_THROW(LeastError(v, 4, 3, draw), Error);
    EXPECT_THROW(LeastError(v, 4, 17, draw), Error);
    EXPECT_THROW(ExpectedMse(v, Image<std::uint8_t>(2, 2, 5), 4, draw), Error);
    EXPECT_THROW(ExpectedMse(v, Image<std::uint8_t>(2, 1, 1), 4, draw), Error);
    EXPECT_THROW(WindowVariances(Image<Rgb>(3, 2), 2), Error);
    const Allocation empty = LeastSamples({}, 4, 0, draw);
    EXPECT_TRUE(empty.reached);
    EXPECT_EQ(empty.samples, 0);
}

}  // namespace
}  // namespace plumb
