// The judge against answers that are known exactly. Every comparison is a z-test at the level
// of tests/truth/significance.h, with the standard error that the judge states of itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/conventions.h"
#include "core/random.h"
#include "rays/embree/embree_caster.h"
#include "tests/truth/shapes.h"
#include "tests/truth/significance.h"
#include "tests/truth/trench_radiosity.h"
#include "truth/escape_walk.h"
#include "truth/open_sky.h"

namespace plumb {
namespace {

constexpr int kNets = 32;
constexpr std::int64_t kPoints = 2048;

// `slack` is what the mesh may be off from the shape that the exact value is of.
void ExpectMeasured(const Measured& measured, double exact, double slack,
                    const std::string& what) {
    EXPECT_NEAR(measured.value, exact, slack + Sigmas(kNets) * measured.standard_error) << what;
    EXPECT_LT(measured.standard_error, 2e-3) << what << ": too unsure to fail";
}

// The mean of two independent measurements.
Measured Mean(const Measured& a, const Measured& b) {
    return {.value = (a.value + b.value) / 2,
            .standard_error = std::hypot(a.standard_error, b.standard_error) / 2,
            .interval = {}};
}

struct Bench {
    explicit Bench(const Mesh& mesh_in) : mesh(mesh_in), caster(mesh) {}

    Measured V(const Receiver& receiver, double reach_m = 1e30) const {
        return Open(receiver, HemisphereWeight::kCosine, reach_m);
    }
    Measured Alpha(const Receiver& receiver, double reach_m = 1e30) const {
        return Open(receiver, HemisphereWeight::kUniform, reach_m);
    }
    Measured Open(const Receiver& receiver, HemisphereWeight weighting, double reach_m) const {
        return CountOpenSky(caster, mesh, std::span(&receiver, 1),
                            {.sampling = {.replicates = kNets, .points = kPoints},
                             .weighting = weighting,
                             .reach_m = reach_m})
            .Of(0);
    }
    EscapeCounts Walks(const Receiver& receiver, int bounces, Sky sky = Sky::kAllAround) const {
        return WalkToTheSky(caster, mesh, std::span(&receiver, 1),
                            {.sampling = {.replicates = kNets, .points = kPoints},
                             .bounces = bounces,
                             .sky = sky,
                             .two_sided = false});
    }

    Mesh mesh;
    EmbreeCaster caster;
};

TEST(ClosedForms, APlaneSeesAllOfTheSkyExactly) {
    for (const Vec3& tilt : {Vec3(0, 0, 1), Vec3(0.4, -0.3, 0.5)}) {
        const Basis frame(tilt.normalized());
        Mesh mesh;
        AddSheet(mesh, Steps(-1, 1, 8), Steps(-1, 1, 8), [&](double u, double v) {
            return frame.ToWorld({u, v, 0});
        });
        const Bench bench(mesh);
        for (const bool spread : {false, true}) {
            const Receiver receiver{.triangle = 61, .spread = spread};
            EXPECT_EQ(bench.V(receiver).value, 1);
            EXPECT_EQ(bench.Alpha(receiver).value, 1);
            const EscapeCounts walks = bench.Walks(receiver, 3);
            EXPECT_EQ(walks.Bounce(0, 0).value, 1);
            EXPECT_EQ(walks.Total(0, Albedo(0.8)).value, 1);
        }
    }
}

// Expected: of a floor and a wall that meet at the angle beta and never end, every point sees
// the same: V = (1 - cos beta) / 2, alpha = beta / pi (both of the cross-section's open angle),
// and with F = 1 - V the light of all bounces is V / (1 - rho F), p_k = V F^k.
// Slack: they end at H = 1e8. A point at r from the corner sees r / (2 H) too much of the sky; a
// walk's next r has a density that falls with 1 / r^2, so its mean is r log(H / r): 20 r, and
// 4e-7 for each bounce from r = 4. (With H = 1e5 the test fails by 40 standard errors.)
TEST(ClosedForms, Wedge) {
    for (const double beta_deg : {60.0, 90.0, 120.0}) {
        const double beta = beta_deg * kPi / 180;
        Mesh mesh;
        const std::vector<double> out = GrowingStepsUp(1e-4, 1e8, 4);
        const std::vector<double> along = GrowingSteps(0.5, 1e8, 4);
        // The step from 1.6384 to 6.5536 and from y = 0 to 0.5.
        const std::uint32_t step = 8, middle = std::uint32_t(along.size() / 2);
        const std::uint32_t floor =
            AddSheet(mesh, out, along, [](double x, double y) { return Vec3(x, y, 0); });
        const std::uint32_t wall = AddSheet(mesh, along, out, [&](double y, double r) {
            return Vec3(r * std::cos(beta), y, r * std::sin(beta));
        });
        const Bench bench(mesh);
        const double V = (1 - std::cos(beta)) / 2, F = 1 - V;
        const std::uint32_t on_floor = floor + step + middle * std::uint32_t(out.size() - 1);
        const std::uint32_t on_wall = wall + middle + step * std::uint32_t(along.size() - 1);
        for (const std::uint32_t face : {on_floor, on_wall}) {
            const std::string what =
                (face == on_floor ? "floor " : "wall ") + std::to_string(beta_deg);
            const Receiver receiver{.triangle = 2 * face, .spread = false};
            ExpectMeasured(bench.V(receiver), V, 1e-6, what + " V");
            ExpectMeasured(bench.Alpha(receiver), beta / kPi, 1e-6, what + " alpha");
            const EscapeCounts walks = bench.Walks(receiver, 60);
            EXPECT_EQ(walks.lost.All(), 0);
            for (const int k : {0, 1, 2, 5}) {
                ExpectMeasured(walks.Bounce(0, k), V * std::pow(F, k), 1e-6, what + " p_k");
            }
            for (const double rho : {0.5, 0.8, 0.9}) {
                ExpectMeasured(walks.Total(0, Albedo(rho)), V / (1 - rho * F), 4e-6,
                               what + " E at " + std::to_string(rho));
            }
        }
    }
}

// Expected: V in closed form (tests/closed_forms/trench.h derives it); E(rho) for rho = 0.5 and 0.8 to
// 8 digits from a Gauss-Legendre Nystroem solution of the radiosity equation (n = 120 and 240
// agree), and for all of them from the strips of trench_radiosity.h.
// Slack: the trench ends 100 widths away, which opens less than d^2 / (pi 100^3) = 3e-7 a
// bounce; strips are held to 2e-5 against the 8 digits.
TEST(ClosedForms, Trench) {
    Mesh mesh;
    const std::vector<double> along = GrowingSteps(0.5, 100, 2);
    const std::uint32_t middle = std::uint32_t(along.size() / 2);
    const std::uint32_t floor = AddSheet(mesh, Steps(0, 1, 4), along,
                                         [](double x, double y) { return Vec3(x, y, -1); });
    const std::uint32_t left = AddSheet(mesh, along, Steps(0, 1, 2),
                                        [](double y, double s) { return Vec3(0, y, s - 1); });
    AddSheet(mesh, Steps(0, 1, 2), along, [](double s, double y) { return Vec3(1, y, s - 1); });
    const Bench bench(mesh);

    struct Place {
        const char* name;
        Receiver receiver;
        double V, E05, E08;
        bool on_floor;
        double at;
    };
    // Corners of the first half are (0, 1, 3) of the quad; b_2 = 1 puts the point on corner d,
    // at the middle of the trench's length within 1e-6 of an edge.
    const std::uint32_t floor_row = floor + middle * 4;
    const double e = 1e-6;
    const Place places[] = {
        {"floor centre",
         {.triangle = 2 * (floor_row + 2), .spread = false, .b_1 = e, .b_2 = e},
         .44721360,
         .57597784,
         .75336109,
         true,
         0.5},
        {"floor quarter",
         {.triangle = 2 * (floor_row + 1), .spread = false, .b_1 = e, .b_2 = e},
         .42126781,
         .55166829,
         .73759843,
         true,
         0.25},
        {"mid wall",
         {.triangle = 2 * (left + middle + std::uint32_t(along.size() - 1)),
          .spread = false,
          .b_1 = e,
          .b_2 = e},
         .27639320,
         .45740244,
         .68757829,
         false,
         0.5},
    };
    const TrenchRadiosity at_05(1, 0.5, 100), at_08(1, 0.8, 100), at_09(1, 0.9, 100);
    for (const Place& place : places) {
        const auto strips = [&](const TrenchRadiosity& light) {
            return place.on_floor ? light.AtFloor(place.at) : light.AtWall(place.at);
        };
        EXPECT_NEAR(strips(at_05), place.E05, 2e-5) << place.name;
        EXPECT_NEAR(strips(at_08), place.E08, 2e-5) << place.name;
        ExpectMeasured(bench.V(place.receiver), place.V, 1e-5, place.name);
        const EscapeCounts walks = bench.Walks(place.receiver, 100);
        EXPECT_EQ(walks.lost.All(), 0) << place.name;
        ExpectMeasured(walks.Total(0, Albedo(0)), place.V, 1e-5, place.name);
        ExpectMeasured(walks.Total(0, Albedo(0.5)), place.E05, 1e-5, place.name);
        ExpectMeasured(walks.Total(0, Albedo(0.8)), place.E08, 1e-5, place.name);
        ExpectMeasured(walks.Total(0, Albedo(0.9)), strips(at_09), 3e-5, place.name);
    }
}

// Expected: a cap of a sphere sunk into level ground, depth h: form factors on a sphere are
// constant, so at every point of it V = a = 1 - h / (2 R), p_k = a (1 - a)^k.
// Slack: facets d = 2 pi / 256 wide are chords: a point lies up to R d^2 / 8 inside and is
// tilted by up to d / 2 against the sphere, evenly to both sides over the facet, so V moves by
// the second order, at most (d / 2)^2.
TEST(ClosedForms, Bowl) {
    for (const double h : {0.5, 1.0}) {
        const double psi = std::acos(1 - h), a = 1 - h / 2, d = 2 * kPi / 256;
        Mesh mesh;
        const int rings = int(std::ceil(psi / d));
        AddSheet(mesh, Steps(0, 2 * kPi, 256), Steps(0, psi, rings),
                 [&](double phi, double theta) {
                     return Vec3(std::sin(theta) * std::cos(phi),
                                 std::sin(theta) * std::sin(phi), -std::cos(theta));
                 });
        TurnInsideOut(mesh);
        const Bench bench(mesh);
        for (const int ring : {rings / 4, rings / 2, rings - 2}) {
            // A triangle's tilts are even about the midpoint of its longest side, not about its
            // centroid; over both halves of a quad they are even.
            const std::uint32_t face = std::uint32_t(ring * 256 + 37);
            const EscapeCounts one = bench.Walks({.triangle = 2 * face}, 40);
            const EscapeCounts two = bench.Walks({.triangle = 2 * face + 1}, 40);
            const std::string what = "h " + std::to_string(h) + " ring " + std::to_string(ring);
            EXPECT_EQ(one.lost.All() + two.lost.All(), 0) << what;
            for (const int k : {0, 1, 2, 3, 6}) {
                ExpectMeasured(Mean(one.Bounce(0, k), two.Bounce(0, k)), a * std::pow(1 - a, k),
                               d * d / 4, what);
            }
            ExpectMeasured(Mean(one.Total(0, Albedo(0.8)), two.Total(0, Albedo(0.8))),
                           a / (1 - 0.8 * (1 - a)), d * d / 4, what);
        }
    }
}

// Expected: from the middle of a round pit's floor the sky is a cone: V = r^2 / (r^2 + d^2),
// alpha = 1 - d / sqrt(r^2 + d^2). Slack: a rim of 512 chords lies up to r (1 - cos(pi / 512))
// = 2e-5 r inside the circle.
TEST(ClosedForms, Pits) {
    for (const double r : {0.25, 0.5, 1.0, 2.0}) {
        Mesh mesh;
        AddQuad(mesh, {-3, -3, -1}, {3, -3, -1}, {3, 3, -1}, {-3, 3, -1});
        AddSheet(mesh, Steps(0, 2 * kPi, 512), Steps(-1, 0, 1), [&](double phi, double z) {
            return Vec3(r * std::cos(phi), r * std::sin(phi), z);
        });
        const Bench bench(mesh);
        const Receiver middle{.triangle = 0, .spread = false, .b_1 = 0.5, .b_2 = 0.5};
        const std::string what = "r " + std::to_string(r);
        ExpectMeasured(bench.V(middle), r * r / (r * r + 1), 2e-5, what + " V");
        ExpectMeasured(bench.Alpha(middle), 1 - 1 / std::hypot(r, 1), 2e-5, what + " alpha");
    }
}

// Expected: a ball of radius R over a level plane, its centre h above it at the distance x
// along the ground, hides h R^2 / (x^2 + h^2)^(3/2) of the cosine-weighted sky. The mesh lies
// between that ball and one smaller by 1 - cos(pi / 128)^2 = 6e-4: a share 1.2e-3 of what it
// hides.
TEST(ClosedForms, BallOverAPlane) {
    const double R = 0.8, h = 1;
    Mesh mesh;
    AddSheet(mesh, Steps(-0.1, 3.9, 10), Steps(-0.1, 0.1, 1),
             [](double x, double y) { return Vec3(x, y, 0); });
    AddSphere(mesh, {0, 0, h}, R, 128);
    const Bench bench(mesh);
    for (const std::uint32_t cell : {0u, 1u, 2u, 5u}) {
        const Receiver receiver{.triangle = 2 * cell, .spread = false, .b_1 = 0.25, .b_2 = 0.5};
        const double x = -0.1 + 0.4 * cell + 0.25 * 0.4;
        const double hidden = h * R * R / std::pow(x * x + h * h, 1.5);
        ExpectMeasured(bench.V(receiver), 1 - hidden, 1.2e-3 * hidden, std::to_string(cell));
    }
}

// Expected: of a wall at the distance x from a level floor that never ends, only w_x > x /
// reach lies within reach. In the cosine-weighted hemisphere (w_x, w_y) is uniform over the
// disk, so with c = x / reach a segment (acos c - c sqrt(1 - c^2)) / pi of it is hidden; of the
// solid angle, half a cap, (1 - c) / 2. Without limit and with the height h: V = (1 + cos
// atan(h/x))/2.
TEST(ClosedForms, WallAtADistanceWithAndWithoutReach) {
    const double x = 1;
    Mesh mesh;
    AddQuad(mesh, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    const std::vector<double> along = GrowingSteps(1, 1e5, 4), up = GrowingStepsUp(1, 1e5, 4);
    AddSheet(mesh, along, up, [&](double y, double z) { return Vec3(x, y, z); });
    const Bench endless(mesh);
    const Receiver middle{.triangle = 0, .spread = false, .b_1 = 0.5, .b_2 = 0.5};
    for (const double reach : {0.5, 1.1, 1.5, 3.0, 20.0}) {
        const double c = std::min(1.0, x / reach);
        const std::string what = "reach " + std::to_string(reach);
        ExpectMeasured(endless.V(middle, reach),
                       1 - (std::acos(c) - c * std::sqrt(1 - c * c)) / kPi, 1e-5, what);
        ExpectMeasured(endless.Alpha(middle, reach), 1 - (1 - c) / 2, 1e-5, what);
    }
    for (const double h : {0.5, 1.0, 4.0}) {
        Mesh low;
        AddQuad(low, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
        AddSheet(low, along, Steps(0, h, 1), [&](double y, double z) { return Vec3(x, y, z); });
        ExpectMeasured(Bench(low).V(middle), (1 + std::cos(std::atan(h / x))) / 2, 1e-5,
                       "height " + std::to_string(h));
    }
}

// Expected: F between unit squares, opposite at unit distance and sharing an edge at a right
// angle [Goral84]: 0.19982489569838732 and 0.20004377607540316. With nothing else in the scene
// the hidden share of the sky, averaged over the square, is F; the square's two halves are
// measured apart and averaged.
TEST(ClosedForms, FormFactorsOfUnitSquares) {
    const auto form_factor = [](const Mesh& mesh) {
        const Bench bench(mesh);
        Measured seen = Mean(bench.V({.triangle = 0}), bench.V({.triangle = 1}));
        seen.value = 1 - seen.value;
        return seen;
    };
    Mesh opposite, adjacent;
    for (Mesh* mesh : {&opposite, &adjacent}) {
        AddQuad(*mesh, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    }
    AddQuad(opposite, {0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1});
    AddQuad(adjacent, {0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1});
    ExpectMeasured(form_factor(opposite), .19982489569838732, 1e-5, "opposite");
    ExpectMeasured(form_factor(adjacent), .20004377607540316, 1e-5, "adjacent");
}

// Expected: in a closed room whose walls glow with Le and reflect rho, L = Le / (1 - rho)
// everywhere, whatever its shape; every surface that a walk meets adds Le rho^k, so all that is
// needed is that no walk ever leaves: exact in counts. The sphere is the scene of pbrt's tests.
TEST(ClosedForms, NothingLeavesAClosedRoom) {
    Mesh sphere;
    AddSphere(sphere, {0, 0, 0}, 1, 24);
    TurnInsideOut(sphere);
    Mesh box;
    AddQuad(box, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
    AddQuad(box, {0, 0, 2}, {0, 1, 2}, {1, 1, 2}, {1, 0, 2});
    AddQuad(box, {0, 0, 0}, {0, 1, 0}, {0, 1, 2}, {0, 0, 2});
    AddQuad(box, {1, 0, 0}, {1, 0, 2}, {1, 1, 2}, {1, 1, 0});
    AddQuad(box, {0, 0, 0}, {0, 0, 2}, {1, 0, 2}, {1, 0, 0});
    AddQuad(box, {0, 1, 0}, {1, 1, 0}, {1, 1, 2}, {0, 1, 2});
    for (const Mesh* mesh : {&sphere, &box}) {
        const Bench bench(*mesh);
        const int K = 15;
        const EscapeCounts walks = bench.Walks({.triangle = 4}, K, Sky::kNowhere);
        EXPECT_EQ(walks.lost.All(), 0);
        std::int64_t under_way = 0;
        for (int r = 0; r < kNets; ++r) under_way += walks.Row(0, r)[std::size_t(K) + 1];
        EXPECT_EQ(under_way, kNets * kPoints);
    }
}

// Expected: at rho = 1 every walk brings back 1, whatever the surface: what is missing leaked.
// A noisy field within a rim as high as its highest point lets no line of sight out sideways.
// Far from the origin of the coordinates rays start further from their triangles, and some get
// behind the next one: those must be noticed and find their way.
TEST(ClosedForms, AFurnaceOnANoisyFieldMissesNothing) {
    constexpr int kCells = 128;
    constexpr double kHeight = 0.04;  // Five cells: slopes up to 79 degrees.
    for (const bool far_off : {false, true}) {
        const Vec3 shift = far_off ? Vec3(2000, 1500, 0) : Vec3(0, 0, 0);
        Mesh mesh;
        AddSheet(mesh, Steps(0, 1, kCells), Steps(0, 1, kCells), [&](double u, double v) {
            const int i = int(std::lround(u * kCells)), j = int(std::lround(v * kCells));
            const bool rim = i == 0 || j == 0 || i == kCells || j == kCells;
            return Vec3(shift + Vec3(u, v, kHeight * (rim ? 1 : RandomUnit(9, i, j, 0))));
        });
        const EmbreeCaster caster(mesh);
        std::vector<Receiver> receivers;
        for (std::uint32_t i = 0; i < (far_off ? 50 : 250); ++i) {
            receivers.push_back(
                {.triangle = std::uint32_t(RandomBits(10, i, 0, 0) % (2 * mesh.quads.size()))});
        }
        const EscapeCounts walks = WalkToTheSky(caster, mesh, receivers,
                                                {.sampling = {.replicates = 8, .points = 512},
                                                 .bounces = 300,
                                                 .sky = Sky::kAbove,
                                                 .two_sided = false});
        EXPECT_EQ(walks.lost.not_a_number, 0);
        EXPECT_EQ(walks.lost.from_behind, 0);
        EXPECT_EQ(walks.lost.not_sky, 0);
        EXPECT_EQ(walks.lost.rescued > 0, far_off);
        std::int64_t all = 0, under_way = 0;
        for (std::int64_t i = 0; i < walks.Receivers(); ++i) {
            for (int r = 0; r < 8; ++r) {
                const std::span<const std::uint32_t> row = walks.Row(i, r);
                all += std::accumulate(row.begin(), row.end(), std::int64_t{0});
                under_way += row[301];
            }
        }
        EXPECT_EQ(all, walks.Receivers() * 8 * 512);  // 1 024 000 of the first.
        EXPECT_LT(under_way, 10);
    }
}

}  // namespace
}  // namespace plumb
