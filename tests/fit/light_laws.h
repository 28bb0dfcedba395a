// The laws that every total E(rho) of ours must keep, asserted at one visibility.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace plumb {

// Two roundings of a number near 1.
inline constexpr double kRounding = 4e-16;

/// 0 and 1, both neighbourhoods to the last bit, and the middle.
inline std::vector<double> Shares() {
    std::vector<double> shares{0, 1e-300, 1e-17, 1e-9, 1 - 1e-9, std::nextafter(1.0, 0.0), 1};
    for (int i = 1; i < 32; ++i) shares.push_back(i / 32.0);
    return shares;
}

/// Every law of the family, at one point; `E` is a function of the albedo.
inline void ExpectLaws(const std::function<double(double)>& E, double V,
                       const std::string& where) {
    std::vector<double> albedos = Shares();
    std::sort(albedos.begin(), albedos.end());
    double last = 0;
    for (double rho : albedos) {
        const double value = E(rho);
        ASSERT_TRUE(std::isfinite(value)) << where << " rho " << rho;
        EXPECT_GE(value, 0) << where << " rho " << rho;
        EXPECT_LE(value, 1) << where << " rho " << rho;
        EXPECT_GE(value, V - kRounding) << where << " rho " << rho;
        EXPECT_GE(value, last - kRounding) << where << " rho " << rho;
        last = value;
    }
    EXPECT_NEAR(E(0), V, kRounding) << where;
    EXPECT_EQ(E(1), 1) << where;
}

}  // namespace plumb
