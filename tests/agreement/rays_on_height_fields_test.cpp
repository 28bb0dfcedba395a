// The maximum mip-map's rays against Embree's on the same triangles. They share no line but core/.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

#include "core/clock.h"
#include "core/conventions.h"
#include "core/random.h"
#include "core/time_in_turns.h"
#include "heightfield/facet.h"
#include "heightfield/procedural/catalogue.h"
#include "heightfield/relief/pyramid_cast.h"
#include "rays/embree/embree_caster.h"

namespace plumb {
namespace {

// Points on facets and cosine-distributed directions about their normals, as both casters take
// them.
struct HemisphereRays {
    static constexpr int kDirections = 256;

    std::vector<FieldRay> points;
    std::vector<Ray> raised;
    std::vector<Vec3f> directions;

    HemisphereRays(const HeightField& field, int count) {
        const double s = field.SpacingXM();
        for (int p = 0; p < count; ++p) {
            const auto facet = std::int64_t(RandomUnit(1, p, 0, 0) * double(field.Facets()));
            const Facet f = FacetOf(field, facet);
            points.push_back({facet, f.CentroidM() - Vec3(s / 2, s / 2, 0), f.normal});
            // Embree has no facet to leave out: its rays start off the surface.
            Ray ray;
            ray.origin_m = (f.CentroidM() + 1e-4 * s * f.normal).cast<float>();
            raised.push_back(ray);
            const Vec3 x = f.normal.unitOrthogonal(), y = f.normal.cross(x);
            for (int d = 0; d < kDirections; ++d) {
                const double r = std::sqrt(RandomUnit(2, p, d, 0));
                const double phi = 2 * kPi * RandomUnit(2, p, d, 1);
                const Vec3 w = r * std::cos(phi) * x + r * std::sin(phi) * y +
                               std::sqrt(1 - r * r) * f.normal;
                directions.push_back(w.cast<float>());
            }
        }
    }
};

HeightField OpenField(const char* name, int n, double amplitude) {
    const ProceduralKind& kind = ProceduralKindNamed(name);
    const HeightField made = kind.make(1, AdvisedTile(kind, n, n));
    const HeightField open(made.HeightsM(), made.SpacingXM(), made.SpacingYM(),
                           Boundary::kOpen);
    return WithAmplitude(open, amplitude * open.WidthM());
}

// Which directions meet anything: differences where a ray passes an edge within rounding, or
// Embree's origin stands off the surface. Places: the same to a thousandth of a texel for all but
// rays that skim.
TEST(RaysOnHeightFields, ThePyramidAndEmbreeMeetTheSame) {
    for (const char* name : {"stone_wall", "terrain", "bricks"}) {
        for (const double amplitude : {0.01, 0.1, 0.45}) {
            SCOPED_TRACE(name);
            SCOPED_TRACE(amplitude);
            const HeightField field = OpenField(name, 256, amplitude);
            const HeightPyramid<float> pyramid(field);
            const EmbreeCaster embree(ToMesh(field));
            const HemisphereRays rays(field, 200);
            std::vector<FieldRay> ours;
            std::vector<Ray> theirs;
            for (std::size_t p = 0; p < rays.points.size(); ++p) {
                for (int d = 0; d < HemisphereRays::kDirections; ++d) {
                    const Vec3f& w = rays.directions[p * HemisphereRays::kDirections + d];
                    ours.push_back(rays.points[p]);
                    ours.back().direction = w.cast<double>();
                    theirs.push_back(rays.raised[p]);
                    theirs.back().direction = w;
                }
            }
            std::vector<FieldHit> hits(ours.size());
            std::vector<Hit> expected(theirs.size());
            CastRays(pyramid, ReliefSurface::kTriangles, ours, hits);
            embree.Closest(theirs, expected);
            int differ = 0, apart = 0, met = 0;
            for (std::size_t k = 0; k < hits.size(); ++k) {
                const bool both = hits[k].facet >= 0 && expected[k].Met();
                differ += (hits[k].facet >= 0) != expected[k].Met();
                met += both;
                apart += both && std::abs(hits[k].t - expected[k].t) > 0.1 * field.SpacingXM();
            }
            EXPECT_LE(differ, int(hits.size() / 5000));
            EXPECT_LE(apart, int(hits.size() / 500));
            EXPECT_GE(met, amplitude > 0.05 ? 1000 : 40);
        }
    }
}

// A measurement: rays a second of one core, in turns, in processor time.
TEST(RaysOnHeightFields, DISABLED_RaysASecondACore) {
    const Clock processor = [] { return double(std::clock()) / CLOCKS_PER_SEC; };
    for (const char* name : {"stone_wall", "terrain"}) {
        for (const double amplitude : {0.01, 0.1, 0.45}) {
            const HeightField field = OpenField(name, 1024, amplitude);
            const HeightPyramid<float> pyramid(field);
            const HeightPyramid<double> fine(field);
            const EmbreeCaster embree(ToMesh(field));
            const HemisphereRays rays(field, 1500);
            constexpr int kDirections = HemisphereRays::kDirections;
            std::vector<std::uint64_t> met(kDirections / 64);
            const auto each = [&](auto ask) {
                return Turn{.run = [&, ask] {
                    for (std::size_t p = 0; p < rays.points.size(); ++p) {
                        ask(p,
                            std::span(rays.directions).subspan(p * kDirections, kDirections));
                    }
                }};
            };
            const TurnTimes times = TimeInTurns(
                {each([&](std::size_t p, auto w) {
                     MeetFromPoint(pyramid, ReliefSurface::kTriangles, rays.points[p], w, met);
                 }),
                 each([&](std::size_t p, auto w) {
                     MeetFromPoint(fine, ReliefSurface::kTriangles, rays.points[p], w, met);
                 }),
                 each([&](std::size_t p, auto w) {
                     MeetFromPoint(pyramid, ReliefSurface::kBilinear, rays.points[p], w, met);
                 }),
                 each([&](std::size_t p, auto w) {
                     embree.AnyFromPoint(rays.raised[p], w, met);
                 })},
                5, processor);
            const double millions = double(rays.directions.size()) / 1e6;
            std::printf(
                "%-10s %4.2f of its width: float %5.1f, double %4.1f, bilinear %5.1f, "
                "Embree %4.1f million rays a second; %.2f times Embree\n",
                name, amplitude, times.Rate(0, millions).value, times.Rate(1, millions).value,
                times.Rate(2, millions).value, times.Rate(3, millions).value,
                times.Ratio(3, 0).value);
        }
    }
}

}  // namespace
}  // namespace plumb
