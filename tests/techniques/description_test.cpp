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
    for (const double value : {0.0, 0.1, 1.0 / 3, 5e-324, 0.999999999999999889}) {
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
    const KnobValues both = Merged(file, line);
    EXPECT_EQ(ValueOf(description, both, "share"), 0.25);
    EXPECT_EQ(ValueOf(description, both, "count"), 5);
    EXPECT_EQ(ValueOf(description, {}, "share"), 0.385);
    EXPECT_THROW(KnobNamed(description, "shade", "here"), Error);
}

}  // namespace
}  // namespace plumb
