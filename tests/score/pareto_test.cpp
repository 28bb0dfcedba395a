#include "score/pareto.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<TimedError> kPoints{
    {"slow and good", 8, 0.1}, {"beaten in both", 5, 0.5}, {"fast and bad", 1, 0.4},
    {"middle", 4, 0.2},        {"as middle", 4, 0.2},      {"as slow, worse", 8, 0.15},
};

TEST(ParetoFront, ByHand) {
    EXPECT_THAT(ParetoFront(kPoints), ElementsAre(2, 3, 0));
}

TEST(ParetoFront, OfNothingIsEmpty) {
    EXPECT_THAT(ParetoFront({}), IsEmpty());
}

// The definition, on many points: on the front if and only if none beats it.
TEST(ParetoFront, HoldsWhatNoOtherBeats) {
    std::vector<TimedError> points;
    for (int k = 0; k < 60; ++k)
        points.push_back({"", double(k * 37 % 61), double((60 - k * 37 % 61) + k * k % 29)});
    const auto front = ParetoFront(points);
    int beaten_points = 0;
    for (std::size_t a = 0; a < points.size(); ++a) {
        bool beaten = false;
        for (const TimedError& b : points) {
            beaten = beaten || (b.time_s <= points[a].time_s && b.error <= points[a].error &&
                                (b.time_s < points[a].time_s || b.error < points[a].error));
        }
        beaten_points += beaten;
        EXPECT_EQ(std::count(front.begin(), front.end(), a), beaten ? 0 : 1) << a;
    }
    EXPECT_GT(beaten_points, 10);
    EXPECT_GT(front.size(), 2u);
}

TEST(CheapestWithin, ByHand) {
    EXPECT_EQ(CheapestWithin(kPoints, 0), 0u);
    EXPECT_EQ(CheapestWithin(kPoints, 1), 3u);  // 0.2 = 2 x 0.1
    EXPECT_EQ(CheapestWithin(kPoints, 3.5), 2u);
}

TEST(ParetoFront, NamesWhatIsNoNumber) {
    const std::vector<TimedError> points{{"SAO, 9 taps", 1, NAN}};
    try {
        ParetoFront(points);
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "SAO, 9 taps: error = nan, must be a number");
    }
}

}  // namespace
}  // namespace plumb
