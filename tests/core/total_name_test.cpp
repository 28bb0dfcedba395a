#include "core/total_name.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace plumb {
namespace {

// By hand, from the definition.
TEST(TotalName, HasDigitsButNoDot) {
    EXPECT_EQ(TotalName(Albedo(0.5)), "E_rho0p5");
    EXPECT_EQ(TotalName(Albedo(0)), "E_rho0");
    EXPECT_EQ(TotalName(Albedo(1)), "E_rho1");
    EXPECT_EQ(TotalName(Albedo(1e-5)), "E_rho1em05");
}

// Law: no two albedos share a name, however near they are.
TEST(TotalName, TellsNeighboursApart) {
    std::set<std::string> names;
    for (double rho = 0.5; names.size() < 100; rho = std::nextafter(rho, 1)) {
        EXPECT_TRUE(names.insert(TotalName(Albedo(rho))).second) << rho;
    }
}

}  // namespace
}  // namespace plumb
