#include "reports/text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plumb {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(ExactText, ReadsBackToTheSameDouble) {
    for (const double x : {0.1, 1 / 3.0, 0.1 + 0.2, 1e-310, 27.576937094210385, -2e300})
        EXPECT_EQ(std::strtod(Exact(x).c_str(), nullptr), x);
    EXPECT_EQ(Exact(0.1), "0.1");  // And is the shortest that does.
}

TEST(ExactText, IsEmptyWithoutANumber) {
    EXPECT_EQ(Exact(kNan), "");
    EXPECT_EQ(Exact(-kInfinity), "");
}

// Rounded by hand.
TEST(DigitsText, KeepsSignificantDigits) {
    EXPECT_EQ(Digits(0.012345), "0.0123");
    EXPECT_EQ(Digits(0.01), "0.0100");
    EXPECT_EQ(Digits(9.996), "10.0");
    EXPECT_EQ(Digits(27.576937, 5), "27.577");
    EXPECT_EQ(Digits(-0.5, 2), "-0.50");
    EXPECT_EQ(Digits(0), "0");
    EXPECT_EQ(Digits(1.25e-9), "1.25e-09");
    EXPECT_EQ(Digits(1234567), "1234567");
    EXPECT_EQ(Digits(kNan), "–");
}

TEST(WithErrorText, EndsAtTheSecondDigitOfTheError) {
    EXPECT_EQ(WithError(27.5769, 0.1234), "27.58 ± 0.12");
    EXPECT_EQ(WithError(27.5769, 0.0996), "27.58 ± 0.10");
    EXPECT_EQ(WithError(12345.6, 120), "12346 ± 120");
    EXPECT_EQ(WithError(0.5, 0), "0.50000");
    EXPECT_EQ(WithError(0.5, kInfinity), "0.50000");
    EXPECT_EQ(WithError(kNan, 1), "–");
}

TEST(CountText, GroupsThousands) {
    EXPECT_EQ(Count(0), "0");
    EXPECT_EQ(Count(999), "999");
    EXPECT_EQ(Count(1234567), "1,234,567");
    EXPECT_EQ(Count(-1000), "-1,000");
}

TEST(RoundedNumber, KeepsSoManyDigits) {
    EXPECT_EQ(Rounded(0.123456789, 6), 0.123457);
    EXPECT_EQ(Rounded(-123456.7, 2), -120000);
    EXPECT_EQ(Rounded(0, 6), 0);
    EXPECT_TRUE(std::isnan(Rounded(kNan, 6)));
}

TEST(HtmlText, LeavesNothingThatMarksUp) {
    EXPECT_EQ(Html("<b a='1'>\"x\" & y</b>"),
              "&lt;b a=&#39;1&#39;&gt;&quot;x&quot; &amp; y&lt;/b&gt;");
}

// [RFC 4180] 2.5 to 2.7; the leading ' is ours, against formulas in spreadsheets.
TEST(CsvText, QuotesWhatMustBe) {
    EXPECT_EQ(Csv("plain name"), "plain name");
    EXPECT_EQ(Csv("a,b"), "\"a,b\"");
    EXPECT_EQ(Csv("say \"x\""), "\"say \"\"x\"\"\"");
    EXPECT_EQ(Csv("two\nlines"), "\"two\nlines\"");
    EXPECT_EQ(Csv("=1+1"), "'=1+1");
}

TEST(PaddedText, CountsCharactersNotBytes) {
    EXPECT_EQ(Right("±1", 4), "  ±1");
    EXPECT_EQ(Left("α", 3), "α  ");
    EXPECT_EQ(Left("too long", 3), "too long");
}

TEST(ListedText, SaysAndBeforeTheLast) {
    EXPECT_EQ(Listed({}), "");
    EXPECT_EQ(Listed({"a"}), "a");
    EXPECT_EQ(Listed({"a", "b"}), "a and b");
    EXPECT_EQ(Listed({"a", "b", "c"}), "a, b and c");
}

}  // namespace
}  // namespace plumb
