// Index matrices and adaptive shading.
#include "screen_space/antialiasing/adaptive_shading.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <limits>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/index_matrix.h"
#include "tests/antialiasing/made_pictures.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

// Figure 3 of [Hollander13].
TEST(IndexMatrix, IsThatOfThePaper) {
    EXPECT_THAT(IndexMatrix(1), ElementsAre(0));
    EXPECT_THAT(IndexMatrix(2), ElementsAre(0, 2,  //
                                            3, 1));
    EXPECT_THAT(IndexMatrix(3), ElementsAre(2, 6, 3,  //
                                            5, 0, 8,  //
                                            1, 7, 4));
    EXPECT_THAT(IndexMatrix(4), ElementsAre(1, 8, 2, 10,   //
                                            12, 4, 14, 6,  //
                                            3, 11, 0, 9,   //
                                            15, 7, 13, 5));
}

// Bayer's matrix of 8, as it stands in textbooks, its first two numbers exchanged.
TEST(IndexMatrix, OfEightIsBayersWithTheFirstTwoExchanged) {
    std::vector<int> bayer{0,  32, 8,  40, 2,  34, 10, 42, 48, 16, 56, 24, 50, 18, 58, 26,  //
                           12, 44, 4,  36, 14, 46, 6,  38, 60, 28, 52, 20, 62, 30, 54, 22,  //
                           3,  35, 11, 43, 1,  33, 9,  41, 51, 19, 59, 27, 49, 17, 57, 25,  //
                           15, 47, 7,  39, 13, 45, 5,  37, 63, 31, 55, 23, 61, 29, 53, 21};
    std::swap(bayer[0], bayer[4 * 8 + 4]);
    EXPECT_THAT(IndexMatrix(8), ElementsAreArray(bayer));
}

TEST(IndexMatrix, HoldsEveryNumberOnce) {
    for (int m = 1; m <= 8; ++m) {
        std::vector<int> numbers = IndexMatrix(m);
        std::sort(numbers.begin(), numbers.end());
        ASSERT_EQ(numbers.size(), std::size_t(m) * m);
        for (int k = 0; k < m * m; ++k) EXPECT_EQ(numbers[std::size_t(k)], k);
        const std::vector<SamplePlace> order = SampleOrder(m);
        for (int k = 0; k < m * m; ++k) {
            const SamplePlace& at = order[std::size_t(k)];
            EXPECT_EQ(IndexMatrix(m)[std::size_t(at.j * m + at.i)], k);
        }
    }
    EXPECT_THROW(IndexMatrix(0), Error);
    EXPECT_THROW(IndexMatrix(9), Error);
}

// The rule that the matrix of 3 obeys as printed, and 5 and 7 by construction: no place that is free
// is farther from all places taken than the next one.
TEST(IndexMatrix, OfOddSizeTakesTheFarthestPlaceNext) {
    for (const int m : {3, 5, 7}) {
        const std::vector<SamplePlace> order = SampleOrder(m);
        EXPECT_EQ(order[0], (SamplePlace{m / 2, m / 2}));
        const auto nearest = [&](const SamplePlace& place, std::size_t taken) {
            int least = std::numeric_limits<int>::max();
            for (std::size_t k = 0; k < taken; ++k) {
                const int di = place.i - order[k].i, dj = place.j - order[k].j;
                least = std::min(least, di * di + dj * dj);
            }
            return least;
        };
        for (std::size_t k = 1; k < order.size(); ++k) {
            for (std::size_t later = k + 1; later < order.size(); ++later) {
                EXPECT_GE(nearest(order[k], k), nearest(order[later], k)) << m << " " << k;
            }
        }
    }
}

// A good prefix is even: of the even sizes, each quarter of the window has one of the first four
// numbers; so has each quadrant of m = 6.
TEST(IndexMatrix, FirstFourNumbersLieInFourQuadrants) {
    for (const int m : {2, 4, 6, 8}) {
        const std::vector<SamplePlace> order = SampleOrder(m);
        int seen[2][2] = {};
        for (std::size_t k = 0; k < 4; ++k) ++seen[order[k].j / (m / 2)][order[k].i / (m / 2)];
        for (const auto& row : seen) EXPECT_THAT(row, ElementsAre(1, 1));
    }
}

/// The colour of sample (X, Y) of a picture.
SampleShader Reader(const Image<Rgb>& picture) {
    return [&](std::span<const SampleToShade> samples, std::span<Rgb> colours) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            colours[i] = picture(samples[i].X, samples[i].Y);
        }
    };
}

Image<std::uint8_t> RandomCounts(int width, int height, int m, std::uint64_t seed) {
    Image<std::uint8_t> counts(width, height);
    for (std::uint64_t i = 0; i < counts.Pixels().size(); ++i) {
        counts.Pixels()[i] = std::uint8_t(1 + int(RandomUnit(seed, i, 0, 0) * m * m));
    }
    return counts;
}

// One pixel of m = 2: samples 1/4 (number 0), 1/2 (2), 1 (3), 0 (1).
TEST(ShadeRest, MeansTheFirstSamplesOfTheMatrix) {
    Image<Rgb> fine(2, 2);
    fine(0, 0) = {0.25f, 0, 0};
    fine(1, 0) = {0.5f, 0, 0};
    fine(0, 1) = {1, 0, 0};
    fine(1, 1) = {0, 1, 0};
    const SampleShader shader = Reader(fine);
    const Image<Rgb> S = ShadeFirst(1, 1, 2, shader);
    EXPECT_THAT(S(0, 0), ElementsAre(0.25f, 0, 0));
    const auto with = [&](int k) {
        return ShadeRest(S, Image<std::uint8_t>(1, 1, std::uint8_t(k)), 2, shader)(0, 0);
    };
    EXPECT_THAT(with(1), ElementsAre(0.25f, 0, 0));
    EXPECT_THAT(with(2), ElementsAre(0.125f, 0.5f, 0));
    EXPECT_THAT(with(3), ElementsAre(0.25f, float(1.0 / 3), 0));
    EXPECT_THAT(with(4), ElementsAre(1.75f / 4, 0.25f, 0));
}

TEST(ShadeRest, AllSamplesEverywhereAreTheFullGridToTheBit) {
    for (int m = 1; m <= 8; ++m) {
        const int W = 13, H = 7;
        const Image<Rgb> fine = NoisePicture(W * m, H * m, std::uint64_t(m));
        const SampleShader shader = Reader(fine);
        const Image<Rgb> full = ShadeAll(W, H, m, shader);
        const Image<std::uint8_t> all(W, H, std::uint8_t(m * m));
        const Image<Rgb> S = ShadeFirst(W, H, m, shader);
        for (const RestOrder order : {RestOrder::kOneLoop, RestOrder::kByCount}) {
            for (const FirstShade first : {FirstShade::kReused, FirstShade::kAgain}) {
                EXPECT_EQ(ShadeRest(S, all, m, shader, {order, first}), full) << m;
            }
        }
        // The mean of each window, by hand; 1e-7: one rounding to float.
        double sum = 0;
        for (int j = 0; j < m; ++j) {
            for (int i = 0; i < m; ++i) sum += fine(5 * m + i, 3 * m + j)[1];
        }
        EXPECT_NEAR(full(5, 3)[1], sum / (m * m), 1e-7);
    }
}

// A shader whose result depends on how many samples the pixel has, as a texture filter does.
TEST(ShadeRest, FirstSampleIsReusedOrShadedAgain) {
    const SampleShader shader = [](std::span<const SampleToShade> samples,
                                   std::span<Rgb> colours) {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            colours[i] = {float(samples[i].of_pixel), 0, 0};
        }
    };
    const Image<Rgb> S = ShadeFirst(2, 1, 2, shader);
    EXPECT_EQ(S(0, 0)[0], 1);
    Image<std::uint8_t> counts(2, 1);
    counts.Pixels() = {4, 1};
    const Image<Rgb> reused = ShadeRest(S, counts, 2, shader);
    EXPECT_EQ(reused(0, 0)[0], (1 + 3 * 4) / 4.f);
    EXPECT_EQ(reused(1, 0)[0], 1);
    const Image<Rgb> again =
        ShadeRest(S, counts, 2, shader, {RestOrder::kOneLoop, FirstShade::kAgain});
    EXPECT_EQ(again(0, 0)[0], 4);
    EXPECT_EQ(again(1, 0)[0], 1);
    EXPECT_EQ(ShadeAll(2, 1, 2, shader)(1, 0)[0], 4);
}

TEST(ShadeRest, ShadesNoSampleTwiceAndNoneTooMany) {
    const int m = 4, W = 21, H = 10;
    std::atomic<std::int64_t> shaded = 0;
    const SampleShader counting = [&](std::span<const SampleToShade> samples,
                                      std::span<Rgb> colours) {
        shaded += std::int64_t(samples.size());
        std::fill(colours.begin(), colours.end(), Rgb{});
    };
    const Image<std::uint8_t> counts = RandomCounts(W, H, m, 4);
    std::int64_t wanted = 0;
    for (const std::uint8_t k : counts.Pixels()) wanted += k;
    for (const RestOrder order : {RestOrder::kOneLoop, RestOrder::kByCount}) {
        shaded = 0;
        const Image<Rgb> S = ShadeFirst(W, H, m, counting);
        EXPECT_EQ(shaded, W * H);
        ShadeRest(S, counts, m, counting, {order, FirstShade::kReused});
        EXPECT_EQ(shaded, wanted);
    }
}

TEST(ShadeRest, IsTheSameInBothOrdersAndOnAnyNumberOfThreads) {
    const int m = 3, W = 61, H = 47;
    const Image<Rgb> fine = NoisePicture(W * m, H * m, 9);
    const SampleShader shader = Reader(fine);
    const Image<std::uint8_t> counts = RandomCounts(W, H, m, 5);
    SetThreadCount(1);
    const Image<Rgb> one = ShadeRest(ShadeFirst(W, H, m, shader), counts, m, shader);
    SetThreadCount(4);
    EXPECT_EQ(ShadeRest(ShadeFirst(W, H, m, shader), counts, m, shader), one);
    EXPECT_EQ(ShadeRest(ShadeFirst(W, H, m, shader), counts, m, shader,
                        {RestOrder::kByCount, FirstShade::kReused}),
              one);
    SetThreadCount(0);
}

TEST(ShadeRest, ConstantStaysToTheBit) {
    const Image<Rgb> flat(24, 16, Rgb{0.1f, 0.7f, 1.f / 3});
    for (const int m : {2, 4, 8}) {
        const Image<Rgb> S = ShadeFirst(24 / m, 16 / m, m, Reader(flat));
        const Image<Rgb> out =
            ShadeRest(S, RandomCounts(24 / m, 16 / m, m, 1), m, Reader(flat));
        for (const Rgb& pixel : out.Pixels()) EXPECT_EQ(pixel, flat(0, 0));
    }
}

TEST(ShadeRest, RefusesWhatCannotBe) {
    const Image<Rgb> S(2, 1);
    const SampleShader shader = Reader(S);
    EXPECT_THROW(ShadeRest(S, Image<std::uint8_t>(2, 1, 5), 2, shader), Error);
    EXPECT_THROW(ShadeRest(S, Image<std::uint8_t>(2, 1, 0), 2, shader), Error);
    EXPECT_THROW(ShadeRest(S, Image<std::uint8_t>(1, 1, 1), 2, shader), Error);
    EXPECT_THROW(ShadeAll(2, 2, 9, shader), Error);
    EXPECT_TRUE(ShadeAll(0, 0, 4, shader).Empty());
    EXPECT_TRUE(ShadeRest({}, {}, 4, shader, {RestOrder::kByCount}).Empty());
}

}  // namespace
}  // namespace plumb
