// Times of things in turns, by a clock whose times are known.
#include "core/time_in_turns.h"

#include <gtest/gtest.h>

#include <string>

#include "core/error.h"

namespace plumb {
namespace {

// A clock that a run sets on by as many seconds as it takes.
class MadeClock {
  public:
    Clock Get() {
        return [this] { return now_s_; };
    }
    void Pass(double seconds) { now_s_ += seconds; }

  private:
    double now_s_ = 100;
};

// Takes seconds[0] in its first run, seconds[1] in the next.
std::function<void()> Taking(MadeClock& clock, std::vector<double> seconds) {
    return [&clock, seconds = std::move(seconds), run = std::size_t{0}]() mutable {
        clock.Pass(seconds.at(run++));
    };
}

void ExpectIs(const Measured& m, double value, double low, double high) {
    EXPECT_DOUBLE_EQ(m.value, value);
    EXPECT_DOUBLE_EQ(m.interval.low, low);
    EXPECT_DOUBLE_EQ(m.interval.high, high);
}

// Expected, by hand: the first round (90 and 80 s) does not count. a: 1 2 4 8 16, b: 2 1 8 2 1
// have medians 4 and 2; a / b: 0.5 2 0.5 4 16 has the median 2, b / a: 2 0.5 2 0.25 0.0625 has
// the median 0.5.
TEST(TimeInTurns, MediansSpreadsAndPairedRatiosByHand) {
    MadeClock clock;
    const TurnTimes times = TimeInTurns({{.run = Taking(clock, {90, 1, 2, 4, 8, 16})},
                                         {.run = Taking(clock, {80, 2, 1, 8, 2, 1})}},
                                        5, clock.Get());
    ExpectIs(times.Seconds(0), 4, 1, 16);
    ExpectIs(times.Seconds(1), 2, 1, 8);
    ExpectIs(times.Ratio(0, 1), 2, 0.5, 16);
    ExpectIs(times.Ratio(1, 0), 0.5, 0.0625, 2);
    ExpectIs(times.Rate(0, 32), 8, 2, 32);
}

// Expected, by hand: medians 1 and 9 have the ratio 1 / 9, but pair by pair 1/9 3/1 1/2 have 1/2.
TEST(TimeInTurns, RatiosAreOfTheSameRound) {
    MadeClock clock;
    const TurnTimes times = TimeInTurns(
        {{.run = Taking(clock, {0, 1, 3, 1})}, {.run = Taking(clock, {0, 9, 1, 2})}}, 3,
        clock.Get());
    ExpectIs(times.Ratio(0, 1), 0.5, 1.0 / 9, 3);
}

TEST(TimeInTurns, AnEvenNumberOfRoundsHasTheMeanOfTheMiddleTwo) {
    MadeClock clock;
    const TurnTimes times =
        TimeInTurns({{.run = Taking(clock, {0, 1, 5, 3, 8})}}, 4, clock.Get());
    ExpectIs(times.Seconds(0), 4, 1, 8);
}

TEST(TimeInTurns, RunsInTurnsAndPreparesOutsideTheTime) {
    MadeClock clock;
    std::string order;
    const TurnTimes times = TimeInTurns({{.run =
                                              [&] {
                                                  order += 'a';
                                                  clock.Pass(1);
                                              }},
                                         {.run =
                                              [&] {
                                                  order += 'b';
                                                  clock.Pass(2);
                                              },
                                          .prepare =
                                              [&] {
                                                  order += 'p';
                                                  clock.Pass(50);
                                              }}},
                                        2, clock.Get());
    EXPECT_EQ(order, "apbapbapb");
    ExpectIs(times.Seconds(0), 1, 1, 1);
    ExpectIs(times.Seconds(1), 2, 2, 2);
}

// Expected, by hand: parts 1 2 3 and 10 30 20; sums 11 32 23.
TEST(TakeTurns, HasTheTimesOfPartsAndOfTheirSum) {
    int run = 0;
    const std::vector<std::vector<double>> seconds{{7, 7}, {1, 10}, {2, 30}, {3, 20}};
    const TurnTimes times = TakeTurns({[&] { return seconds.at(std::size_t(run++)); }}, 3);
    ExpectIs(times.SecondsOfPart(0, 0), 2, 1, 3);
    ExpectIs(times.SecondsOfPart(0, 1), 20, 10, 30);
    ExpectIs(times.Seconds(0), 23, 11, 32);
}

TEST(TimeInTurns, RefusesNoRoundsAndStopsBetweenTurns) {
    EXPECT_THROW(TimeInTurns({}, 0, [] { return 0.0; }), Error);
    struct After final : Monitor {
        int left = 3;
        void Progress(std::string_view, double) override {}
        bool Cancelled() const override { return left == 0; }
    } monitor;
    EXPECT_THROW(TimeInTurns(
                     {{.run = [&] { --monitor.left; }}}, 99, [] { return 0.0; }, monitor),
                 Interrupted);
    EXPECT_EQ(monitor.left, 0);
}

}  // namespace
}  // namespace plumb
