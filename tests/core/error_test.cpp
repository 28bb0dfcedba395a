#include "core/error.h"

#include <gtest/gtest.h>

#include <limits>

namespace plumb {
namespace {

// The form of every message about a value: thing, value with the fewest digits that read back
// to the same double, rule.
TEST(MustBe, NamesThingValueAndRule) {
    EXPECT_EQ(MustBe("SaoParams::radius_m", -1, "> 0"),
              "SaoParams::radius_m = -1, must be > 0");
    EXPECT_EQ(MustBe("sponza.json: cameras[0].fov_deg", 190, "in (0, 180)"),
              "sponza.json: cameras[0].fov_deg = 190, must be in (0, 180)");
}

TEST(MustBe, WritesTheShortestDigitsThatReadBack) {
    EXPECT_EQ(MustBe("x", 0.1, "0"), "x = 0.1, must be 0");
    EXPECT_EQ(MustBe("x", 1.0 / 3, "0"), "x = 0.3333333333333333, must be 0");
    EXPECT_EQ(MustBe("x", 1e300, "0"), "x = 1e+300, must be 0");
    EXPECT_EQ(MustBe("x", -0.0, "> 0"), "x = -0, must be > 0");
}

TEST(MustBe, WritesWhatIsNotANumber) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(MustBe("x", nan, "finite"), "x = nan, must be finite");
    EXPECT_EQ(MustBe("x", -nan, "finite"), "x = nan, must be finite");
    EXPECT_EQ(MustBe("x", -std::numeric_limits<double>::infinity(), "finite"),
              "x = -inf, must be finite");
}

}  // namespace
}  // namespace plumb
