#include "core/visibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <type_traits>

namespace plumb {
namespace {

TEST(Visibility, TheTwoKindsDoNotConvert) {
    EXPECT_FALSE((std::is_convertible_v<UniformVisibility, CosineVisibility>));
    EXPECT_FALSE((std::is_constructible_v<CosineVisibility, UniformVisibility>));
    EXPECT_FALSE((std::is_constructible_v<UniformVisibility, CosineVisibility>));
    EXPECT_FALSE((std::is_convertible_v<double, CosineVisibility>));
}

// A cap of half-angle theta about the normal has alpha = 1 - cos(theta) and, from
// 1/pi Int cos dw, V = sin^2(theta). The band below it has the complements.
TEST(Visibility, CapsReachTheBounds) {
    const double theta_rad = 0.7;
    const UniformVisibility cap(1 - std::cos(theta_rad)), band(std::cos(theta_rad));
    const double V_cap = std::pow(std::sin(theta_rad), 2);
    // Tolerance: a few roundings of numbers below 1.
    EXPECT_NEAR(GreatestCosineVisibility(cap), V_cap, 1e-15);
    EXPECT_NEAR(LeastCosineVisibility(band), 1 - V_cap, 1e-15);
}

}  // namespace
}  // namespace plumb
