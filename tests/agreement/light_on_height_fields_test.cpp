// The light simulation of formfactor/ against the path-traced truth, facet by facet. They share
// the facets and core/ and nothing else.
//
// Truth measures the mean of E_k over a facet. formfactor/ computes V and alpha of it without
// discretization, and lets the bounces of light be constant on a facet j:
//
//       E_{k+1,i} = Sum_j Int_j K_i(y) E_k(y) dy,       formfactor: E_k(y) = mean over j
//
// so its error obeys |e_{k+1}| <= F (|e_k| + delta_k), e_0 = 0, with delta_kj the most that E_k
// departs from its mean on facet j: the bound used here, with delta from the truth at the
// corners. On a grid twice as fine delta, being a slope times a length, halves; the error falls
// faster, since what is too much on one side of a facet is too little on the other.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/distributions.h"
#include "core/intervals.h"
#include "core/statistics.h"
#include "formfactor/bounces.h"
#include "formfactor/slice_links.h"
#include "rays/embree/embree_caster.h"
#include "tests/agreement/surfaces.h"
#include "tests/closed_forms/analytic_fields.h"
#include "truth/escape_walk.h"
#include "truth/open_sky.h"

namespace plumb {
namespace {

constexpr int kBounces = 10;
constexpr int kNets = 32;
constexpr std::int64_t kPoints = 128;
constexpr int kSeeds = 3;  // Of formfactor/, whose scatter is its own error.

// P(false alarm) = 1e-3 for the program: 4 surfaces of about 500 facets and 12 quantities.
const double kZ = StudentQuantile(1 - SidakLevel(1e-3, 4 * 500 * 12) / 2, kNets - 1);

struct Value {
    double value = 0, standard_error = 0;
};
using Values = std::vector<Value>;  // One a facet.

// What formfactor/ says: means over seeds, and over the facets of a coarser grid.
struct Judged {
    Values alpha;
    std::vector<Values> E;  // [k]
};

Judged Simulate(const HeightField& field, const std::vector<std::int64_t>& coarse_facet,
                std::int64_t coarse_facets) {
    const double share = double(coarse_facets) / double(field.Facets());
    const auto gather = [&](std::span<const double> fine) {
        std::vector<double> coarse(std::size_t(coarse_facets), 0.0);
        for (std::size_t f = 0; f < fine.size(); ++f) {
            coarse[std::size_t(coarse_facet[f])] += share * fine[f];
        }
        return coarse;
    };
    const std::size_t quantities = kBounces + 2;  // E_0 ... E_K, alpha.
    std::vector<std::vector<Moments>> moments(quantities,
                                              std::vector<Moments>(std::size_t(coarse_facets)));
    for (int seed = 1; seed <= kSeeds; ++seed) {
        const Links links = LinksBySlices(
            field, {.slices = 128, .seed = std::uint64_t(seed), .links_per_slice = 64});
        const auto add = [&](std::size_t quantity, std::span<const double> fine) {
            const std::vector<double> coarse = gather(fine);
            for (std::size_t i = 0; i < coarse.size(); ++i) moments[quantity][i].Add(coarse[i]);
        };
        ForEachBounce(links, kBounces,
                      [&](int k, std::span<const double> E_k) { add(std::size_t(k), E_k); });
        add(kBounces + 1, links.alpha);
    }
    Judged judged;
    for (const std::vector<Moments>& of_facets : moments) {
        Values values;
        double variance = 0;  // Pooled: of three seeds one facet's own says little.
        for (const Moments& m : of_facets) variance += m.Variance() / double(coarse_facets);
        for (const Moments& m : of_facets) {
            values.push_back({m.Mean(), std::sqrt(std::max(variance, m.Variance()) / kSeeds)});
        }
        judged.E.push_back(values);
    }
    judged.alpha = judged.E.back();
    judged.E.pop_back();
    return judged;
}

std::vector<std::int64_t> Same(const HeightField& field) {
    std::vector<std::int64_t> out(std::size_t(field.Facets()));
    for (std::size_t f = 0; f < out.size(); ++f) out[f] = std::int64_t(f);
    return out;
}

struct Truth {
    Values alpha;
    std::vector<Values> E;                   // [k]
    std::vector<std::vector<double>> delta;  // [k][facet]
};

Truth Measure(const HeightField& field, int tiles) {
    const Mesh mesh = ToMesh(field, tiles);
    const EmbreeCaster caster(mesh);
    const std::vector<Receiver> facets = FacetReceivers(field, mesh, tiles);
    const WalkOptions options{.sampling = {.replicates = kNets, .points = kPoints},
                              .bounces = kBounces,
                              .sky = Sky::kAbove,
                              .two_sided = false};
    const auto values = [](std::int64_t count, const auto& measured) {
        Values out;
        for (std::int64_t i = 0; i < count; ++i) {
            const Measured m = measured(i);
            out.push_back({m.value, m.standard_error});
        }
        return out;
    };
    Truth truth;
    const EscapeCounts walks = WalkToTheSky(caster, mesh, facets, options);
    EXPECT_EQ(walks.lost.All(), 0);
    for (int k = 0; k <= kBounces; ++k) {
        truth.E.push_back(
            values(walks.Receivers(), [&](std::int64_t i) { return walks.Bounce(i, k); }));
    }
    const OpenCounts open =
        CountOpenSky(caster, mesh, facets,
                     {.sampling = {.replicates = kNets, .points = kPoints, .seed = 2},
                      .weighting = HemisphereWeight::kUniform,
                      .sky = Sky::kAbove});
    truth.alpha = values(open.Receivers(), [&](std::int64_t i) { return open.Of(i); });

    // delta from the facet's corners, a hundredth inside.
    std::vector<Receiver> corners;
    for (const Receiver& facet : facets) {
        for (const Vec2& b : {Vec2(0.01, 0.01), Vec2(0.98, 0.01), Vec2(0.01, 0.98)}) {
            corners.push_back(
                {.triangle = facet.triangle, .spread = false, .b_1 = b.x(), .b_2 = b.y()});
        }
    }
    WalkOptions few = options;
    few.sampling = {.replicates = 8, .points = 128, .seed = 3};
    const EscapeCounts at_corners = WalkToTheSky(caster, mesh, corners, few);
    for (int k = 0; k <= kBounces; ++k) {
        std::vector<double> delta(facets.size(), 0.0);
        for (std::size_t c = 0; c < corners.size(); ++c) {
            const double off = at_corners.Bounce(std::int64_t(c), k).value -
                               truth.E[std::size_t(k)][c / 3].value;
            delta[c / 3] = std::max(delta[c / 3], std::abs(off));
        }
        truth.delta.push_back(delta);
    }
    return truth;
}

// bound[k][i] on |e_k| of the header, for a grid `m` times as fine.
std::vector<std::vector<double>> Bounds(const HeightField& field, const Truth& truth, int m) {
    const Links links = LinksBySlices(field, {.slices = 128});
    std::vector<std::vector<double>> bounds{std::vector<double>(truth.alpha.size(), 0.0)};
    for (int k = 0; k < kBounces; ++k) {
        std::vector<double> before = bounds.back();
        for (std::size_t i = 0; i < before.size(); ++i) {
            before[i] += truth.delta[std::size_t(k)][i] / m;
        }
        bounds.push_back(Gather(links, before));
    }
    return bounds;
}

// Every facet within combined errors and `bounds`.
void ExpectEveryFacetAgrees(const Values& judged, const Values& truth,
                            const std::vector<double>& bounds, const std::string& what) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double error = std::hypot(judged[i].standard_error, truth[i].standard_error);
        ASSERT_LT(error, 0.02) << what << ", facet " << i << ": too unsure to fail";
        ASSERT_NEAR(judged[i].value, truth[i].value, kZ * error + bounds[i])
            << what << ", facet " << i;
    }
}

// Where nothing is discretized the differences must look like their errors: their mean square
// in standard errors is (R - 1) / (R - 3) = 1.07 for Student's t and at most 5 sqrt(2 / facets)
// more (less where facets see all of the sky: those are exact), and their mean is 0.
void ExpectOnlyNoise(const Values& judged, const Values& truth, const std::string& what) {
    double squares = 0, sum = 0, variance = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        const double off = judged[i].value - truth[i].value;
        const double error2 =
            std::pow(judged[i].standard_error, 2) + std::pow(truth[i].standard_error, 2);
        squares += off * off / error2;
        sum += off;
        variance += error2;
    }
    const double n = double(truth.size());
    EXPECT_LE(squares / n, (kNets - 1.0) / (kNets - 3.0) + 5 * std::sqrt(2 / n)) << what;
    EXPECT_LT(std::abs(sum), 5 * std::sqrt(variance)) << what << ": mean off by " << sum / n;
}

double MeanOff(const Values& judged, const Values& truth) {
    double off = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) off += judged[i].value - truth[i].value;
    return off / double(truth.size());
}

void ExpectAgreement(const HeightField& field, int tiles, const std::string& name) {
    const Truth truth = Measure(field, tiles);
    const std::vector<std::vector<double>> bounds = Bounds(field, truth, 1);
    const Judged judged = Simulate(field, Same(field), field.Facets());
    const std::vector<double> none(truth.alpha.size(), 0.0);
    ExpectEveryFacetAgrees(judged.alpha, truth.alpha, none, name + " alpha");
    ExpectOnlyNoise(judged.alpha, truth.alpha, name + " alpha");
    ExpectOnlyNoise(judged.E[0], truth.E[0], name + " V");
    for (int k = 0; k <= kBounces; ++k) {
        ExpectEveryFacetAgrees(judged.E[std::size_t(k)], truth.E[std::size_t(k)],
                               bounds[std::size_t(k)], name + " E_" + std::to_string(k));
    }
}

TEST(LightOnHeightFields, NoiseAgrees) {
    ExpectAgreement(NoiseField(16), 0, "noise");
}

TEST(LightOnHeightFields, StoneWallAgrees) {
    ExpectAgreement(StoneField(16), 0, "stone wall");
}

// Wrapped: beyond its tile the bowl's ground is level, so one tile to each side is as good as
// all of them.
TEST(LightOnHeightFields, WrappedBowlAgrees) {
    const HeightField bowl = MakeBowl({.half_angle_rad = 1.3, .rim_texels = 6, .texels = 16});
    ExpectAgreement(bowl, 1, "bowl");
}

// On the same surface with 4 facets for each, bounds halve and must still hold; and the mean of
// E_1, which is too high (facets pass light on from where it is not), comes nearer by more than
// the bound does: a factor 4 is second order, 2.5 leaves room for the noise.
TEST(LightOnHeightFields, DisagreementShrinksWithTheFacets) {
    const HeightField field = NoiseField(16), fine = Refined(field, 2);
    const Truth truth = Measure(field, 0);
    const Judged coarse = Simulate(field, Same(field), field.Facets());
    const Judged refined = Simulate(fine, CoarseFacets(field, fine, 2), field.Facets());
    const std::vector<std::vector<double>> bounds = Bounds(field, truth, 2);
    for (int k = 0; k <= kBounces; ++k) {
        ExpectEveryFacetAgrees(refined.E[std::size_t(k)], truth.E[std::size_t(k)],
                               bounds[std::size_t(k)], "refined E_" + std::to_string(k));
    }
    const double off_1 = MeanOff(coarse.E[1], truth.E[1]);
    const double off_2 = MeanOff(refined.E[1], truth.E[1]);
    EXPECT_GT(off_1, 0.005);
    EXPECT_LT(std::abs(off_2), off_1 / 2.5);
}

}  // namespace
}  // namespace plumb
