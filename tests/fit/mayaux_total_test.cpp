#include "fit/models/mayaux_total.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plumb {
namespace {

double Published(PoleGuard guard, double alpha, double rho) {
    return Evaluate(kMayaux18, guard, UniformVisibility(alpha), Albedo(rho));
}

// Expected: [Mayaux18 eq. 8], summed term by term with F_k = tau^(k-1) F1.
// Tolerance: 2000 terms with |rho tau| < 0.9 leave 0.9^2000; 2000 roundings of 1.
TEST(MayauxTotal, IsTheSumOfItsBounces) {
    for (double alpha : {0.05, 0.2, 0.5, 0.7})
        for (double rho : {0.2, 0.5, 0.9}) {
            const UniformVisibility at(alpha);
            const double F0 = Evaluate(kMayaux18.F0, at), F1 = Evaluate(kMayaux18.F1, at);
            double E = F0, bounce = rho * F1;
            for (int k = 1; k <= 2000; ++k, bounce *= rho * BounceRatio(F0, F1)) E += bounce;
            EXPECT_NEAR(Published(PoleGuard::kNone, alpha, rho), E, 1e-13)
                << alpha << " " << rho;
        }
}

// Expected: [Mayaux18 eq. 9] is made for E(1) = 1; rho = 0 leaves F0.
TEST(MayauxTotal, IsOneAtAlbedoOneAndF0AtAlbedoZero) {
    for (double alpha : {0.05, 0.2, 0.5, 0.7, 0.9}) {
        EXPECT_NEAR(Published(PoleGuard::kNone, alpha, 1), 1, 1e-14);
        EXPECT_EQ(Published(PoleGuard::kNone, alpha, 0),
                  Evaluate(kMayaux18.F0, UniformVisibility(alpha)));
    }
}

// Expected: scored for the exact 60 degree wedge (alpha = 1/3) and 90 degree wedge (alpha =
// 1/2) at rho = 0.8 by an independent program, four digits given: 0.8612 and 0.9193.
TEST(MayauxTotal, PublishedConstantsOnTheWedges) {
    EXPECT_NEAR(Published(PoleGuard::kNone, 1.0 / 3, 0.8), 0.8612, 5e-5);
    EXPECT_NEAR(Published(PoleGuard::kNone, 0.5, 0.8), 0.9193, 5e-5);
}

// Expected: open ground is 1. As printed it is 0 / 0; every guard mends that. The port keeps
// alpha at 0.999, where F0 = 0.999 (1 + 0.5 * 0.001^0.75) = 1.0018 and F1 is under 1e-4.
TEST(MayauxTotal, OpenGroundNeedsAGuard) {
    EXPECT_TRUE(std::isnan(Published(PoleGuard::kNone, 1, 0.5)));
    EXPECT_EQ(Published(PoleGuard::kDemo, 1, 0.5), 1);
    EXPECT_NEAR(Published(PoleGuard::kPort, 1, 0.5), 1.0018, 1e-4);
}

// Expected: away from the pole the port's guards do not bind; the demo's 0.01 always does, and
// lowers F1 / (1 - F0), so raises tau and E. Hand: 1 - tau = F1 / (0.01 + 1 - F0).
TEST(MayauxTotal, GuardsAtHalfOpen) {
    EXPECT_EQ(Published(PoleGuard::kPort, 0.5, 0.7), Published(PoleGuard::kNone, 0.5, 0.7));
    const UniformVisibility half(0.5);
    const double F0 = Evaluate(kMayaux18.F0, half), F1 = Evaluate(kMayaux18.F1, half);
    const double escape = F1 / (1.01 - F0);
    EXPECT_NEAR(Published(PoleGuard::kDemo, 0.5, 0.7), F0 + 0.7 * F1 / (0.3 + 0.7 * escape),
                1e-15);
}

TEST(MayauxTotal, HalfAlbedoGuardStopsAtHalf) {
    EXPECT_EQ(Published(PoleGuard::kPortHalfAlbedo, 0.3, 0.9),
              Published(PoleGuard::kPort, 0.3, 0.5));
    EXPECT_EQ(Published(PoleGuard::kPortHalfAlbedo, 0.3, 0.4),
              Published(PoleGuard::kPort, 0.3, 0.4));
}

}  // namespace
}  // namespace plumb
