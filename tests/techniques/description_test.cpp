// Values of knobs as text: domains word by word, and every value back to the same bits.
#include "core/description.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/error.h"

namespace plumb {
namespace {

Knob Share() {
    return {.name = "share", .low = 0, .high = 1, .high_is_out = true, .published = 0.385};
}

Knob Count() {
    return {.name = "count", .kind = Knob::Kind::kWhole, .low = 1, .high = 64, .published = 8};
}

Knob Shape() {
    return {.name = "shape", .kind = Knob::Kind::kChoice, .choices = {"round", "square"}};
}

Knob Filter() {
    return {.name = "filter", .kind = Knob::Kind::kSwitch, .choices = {"off", "on"}};
}

Knob Thickness() {
    return {.name = "thickness",
            .low = 0,
            .high = std::numeric_limits<double>::infinity(),
            .low_is_out = true};
}

std::string Complaint(const Knob& knob, const std::string& text) {
    try {
        ValueOfText(knob, text, "--set x." + knob.name);
    } catch (const Error& error) {
        return error.what();
    }
    return "none";
}

TEST(Knob, SaysItsDomain) {
    EXPECT_EQ(RuleOf(Share()), "in [0, 1)");
    EXPECT_EQ(RuleOf(Count()), "a whole number in [1, 64]");
    EXPECT_EQ(RuleOf(Shape()), "one of round, square");
    EXPECT_EQ(RuleOf(Filter()), "one of off, on");
    EXPECT_EQ(RuleOf(Thickness()), "in (0, infinity]");
    EXPECT_EQ(RuleOf({.name = "r", .low = 1e-4, .high = 1e7}), "in [1e-4, 1e7]");
    EXPECT_EQ(RuleOf({.name = "r", .low = -1e-10, .high = 1e20}), "in [-1e-10, 1e20]");
}

TEST(Knob, RefusesWhatIsOutsideOfItNamingWhereValueAndRule) {
    EXPECT_EQ(Complaint(Share(), "0"), "none");
    EXPECT_EQ(Complaint(Share(), "1"), "--set x.share = 1, must be in [0, 1)");
    EXPECT_EQ(Complaint(Share(), "-1e-300"), "--set x.share = -1e-300, must be in [0, 1)");
    EXPECT_EQ(Complaint(Share(), "nan"), "--set x.share = nan, must be in [0, 1)");
    EXPECT_EQ(Complaint(Share(), ""), "--set x.share = , must be in [0, 1)");
    EXPECT_EQ(Complaint(Share(), "0.5m"), "--set x.share = 0.5m, must be in [0, 1)");
    EXPECT_EQ(Complaint(Count(), "64"), "none");
    EXPECT_EQ(Complaint(Count(), "65"),
              "--set x.count = 65, must be a whole number in [1, 64]");
    EXPECT_EQ(Complaint(Count(), "1.5"),
              "--set x.count = 1.5, must be a whole number in [1, 64]");
    EXPECT_EQ(Complaint(Shape(), "sqare"),
              "--set x.shape = sqare, must be one of round, square; did you mean square?");
    EXPECT_EQ(Complaint(Filter(), "yes"), "--set x.filter = yes, must be one of off, on");
    EXPECT_EQ(Complaint(Thickness(), "inf"), "none");
    EXPECT_EQ(Complaint(Thickness(), "0"), "--set x.thickness = 0, must be in (0, infinity]");
}

TEST(Knob, TextReadsBackToTheSameBits) {
    for (const double value :
         {0.0, 0.1, 1.0 / 3, 1e-4, 1e-10, 5e-324, 1.5e-7, 0.999999999999999889}) {
        EXPECT_EQ(ValueOfText(Share(), TextOf(Share(), value), ""), value);
    }
    EXPECT_EQ(TextOf(Filter(), 0), "off");
    EXPECT_EQ(TextOf(Filter(), 1), "on");
    EXPECT_EQ(TextOf(Shape(), 1), "square");
    EXPECT_EQ(ValueOfText(Shape(), "square", ""), 1);
    EXPECT_EQ(TextOf(Thickness(), std::numeric_limits<double>::infinity()), "inf");
}

TEST(KnobValues, OfTheUpperWin) {
    const Description description{.name = "x", .knobs = {Share(), Count()}};
    const KnobValues file{{"share", 0.25}, {"count", 4}}, line{{"count", 5}};
    const KnobValues both = Merged(description, file, line);
    EXPECT_EQ(ValueOf(description, both, "share"), 0.25);
    EXPECT_EQ(ValueOf(description, both, "count"), 5);
    EXPECT_EQ(ValueOf(description, {}, "share"), 0.385);
    EXPECT_THROW(KnobNamed(description, "shade", "here"), Error);
}

// A knob that sets others too wins over what a lower place says of those, not over a higher one.
TEST(KnobValues, OfACoveringKnobWinOverWhatItCovers) {
    Knob all = Count();
    all.name = "all";
    all.covers = {"count"};
    const Description description{.name = "x", .knobs = {all, Count()}};
    const KnobValues count{{"count", 4}}, covering{{"all", 9}};
    EXPECT_EQ(Merged(description, count, covering), covering);
    EXPECT_EQ(Merged(description, covering, count), (KnobValues{{"all", 9}, {"count", 4}}));
}

TEST(KnobValues, OfTextsNameWhereTheyStand) {
    const Description description{.name = "x", .knobs = {Share(), Filter()}};
    EXPECT_EQ(ValuesOfTexts(description, {{"share", "0.5"}, {"filter", "on"}}, "a.json"),
              (KnobValues{{"share", 0.5}, {"filter", 1}}));
    const auto complaint = [&](const std::string& knob, const std::string& text) {
        try {
            ValuesOfTexts(description, {{knob, text}}, "a.json: techniques[0]");
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    EXPECT_EQ(complaint("share", "2"), "a.json: techniques[0].share = 2, must be in [0, 1)");
    EXPECT_EQ(complaint("shares", "0"),
              "a.json: techniques[0]: x has no shares, must be one of share, filter; did you "
              "mean share?");
}

}  // namespace
}  // namespace plumb
