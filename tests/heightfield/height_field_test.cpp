// The surface that a grid of heights means: what is refused, which triangles there are, and
// that the mesh handed to truth/ is made of the very same ones.
#include "heightfield/height_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/random.h"
#include "heightfield/facet.h"

namespace plumb {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

std::string MessageOf(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

Image<double> RandomHeights(int width, int height, double amplitude_m, std::uint64_t seed) {
    Image<double> heights(width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            heights(i, j) = amplitude_m * RandomUnit(seed, std::uint64_t(j * width + i), 0, 0);
    return heights;
}

// Every boundary with either diagonal, rough, with unequal spacings.
std::vector<HeightField> AllKinds(int width = 7, int height = 5, double amplitude_m = 3) {
    std::vector<HeightField> fields;
    for (const Boundary boundary : {Boundary::kWrap, Boundary::kMirror, Boundary::kOpen}) {
        for (const Diagonal diagonal : {Diagonal::kRising, Diagonal::kFalling}) {
            fields.emplace_back(RandomHeights(width, height, amplitude_m, 11), 0.75, 1.25,
                                boundary, diagonal);
        }
    }
    return fields;
}

TEST(HeightField, RefusesLessThanTwoByTwoTexels) {
    const auto of_size = [](int width, int height) {
        return MessageOf([=] { HeightField(Image<double>(width, height), 1, 1); });
    };
    EXPECT_EQ(of_size(1, 1), "HeightField: 1 x 1 texels, must be at least 2 x 2");
    EXPECT_EQ(of_size(1, 7), "HeightField: 1 x 7 texels, must be at least 2 x 2");
    EXPECT_EQ(of_size(7, 1), "HeightField: 7 x 1 texels, must be at least 2 x 2");
    EXPECT_EQ(of_size(0, 0), "HeightField: 0 x 0 texels, must be at least 2 x 2");
    EXPECT_EQ(of_size(2, 2), "no error");
}

TEST(HeightField, RefusesSpacingsThatAreNotFiniteAndPositive) {
    const auto spaced = [](double s_x, double s_y) {
        return MessageOf([=] { HeightField(Image<double>(3, 3), s_x, s_y); });
    };
    EXPECT_EQ(spaced(0, 1),
              "HeightField: spacing along x in metres = 0, must be finite and > 0");
    EXPECT_EQ(spaced(-0.5, 1),
              "HeightField: spacing along x in metres = -0.5, must be finite and > 0");
    EXPECT_EQ(spaced(1, 0),
              "HeightField: spacing along y in metres = 0, must be finite and > 0");
    EXPECT_EQ(spaced(1, kNan),
              "HeightField: spacing along y in metres = nan, must be finite and > 0");
    EXPECT_EQ(spaced(kInf, 1),
              "HeightField: spacing along x in metres = inf, must be finite and > 0");
}

TEST(HeightField, NamesTheFirstTexelThatIsNotFinite) {
    Image<double> heights(4, 3);
    heights(3, 2) = kInf;
    EXPECT_EQ(MessageOf([&] { HeightField(heights, 1, 1); }),
              "HeightField: height at texel (3, 2) = inf, must be finite");
    heights(1, 2) = kNan;
    EXPECT_EQ(MessageOf([&] { HeightField(heights, 1, 1); }),
              "HeightField: height at texel (1, 2) = nan, must be finite");
    heights(2, 0) = -kInf;
    EXPECT_EQ(MessageOf([&] { HeightField(heights, 1, 1); }),
              "HeightField: height at texel (2, 0) = -inf, must be finite");
}

TEST(HeightField, CountsCellsByItsBoundary) {
    // n texels have n cells where the last joins the first, n - 1 where there is a border.
    for (const HeightField& field : AllKinds()) {
        const int lost = field.GetBoundary() == Boundary::kWrap ? 0 : 1;
        EXPECT_EQ(field.CellsX(), 7 - lost);
        EXPECT_EQ(field.CellsY(), 5 - lost);
        EXPECT_EQ(field.Facets(), 2 * (7 - lost) * (5 - lost));
        EXPECT_DOUBLE_EQ(field.WidthM(), 0.75 * (7 - lost));
        EXPECT_DOUBLE_EQ(field.HeightM(), 1.25 * (5 - lost));
    }
}

TEST(WithAmplitude, KeepsTheLowestAndStretchesTheRest) {
    const HeightField field = AllKinds().front();
    const HeightField tall = WithAmplitude(field, 12);
    EXPECT_EQ(tall.LowestM(), field.LowestM());
    // One rounding of a number below 16.
    EXPECT_NEAR(tall.HighestM() - tall.LowestM(), 12, 2e-15);
    const double scale = 12 / (field.HighestM() - field.LowestM());
    for (int j = 0; j < 5; ++j) {
        for (int i = 0; i < 7; ++i) {
            EXPECT_NEAR(tall.At(i, j) - tall.LowestM(),
                        scale * (field.At(i, j) - field.LowestM()), 1e-14);
        }
    }
    EXPECT_EQ(WithAmplitude(field, 0).HighestM(), field.LowestM());
}

// Expected: heights of 0, 1/2, 1 times an amplitude of 1e-20, to rounding. Next to a lowest height
// of 7 all of them would be 7.
TEST(WithAmplitude, DoesNotRoundAwayARelief) {
    Image<double> heights(2, 2, 7);
    heights(1, 0) = 8;
    heights(1, 1) = 9;
    const HeightField small = WithAmplitude(HeightField(heights, 1, 1, Boundary::kOpen), 1e-20);
    EXPECT_DOUBLE_EQ(small.At(1, 0) - small.At(0, 0), 5e-21);
    EXPECT_DOUBLE_EQ(small.HighestM() - small.LowestM(), 1e-20);
}

TEST(WithAmplitude, KeepsBoundaryDiagonalAndSpacing) {
    for (const HeightField& field : AllKinds()) {
        const HeightField tall = WithAmplitude(field, 2);
        EXPECT_EQ(tall.GetBoundary(), field.GetBoundary());
        EXPECT_EQ(tall.GetDiagonal(), field.GetDiagonal());
        EXPECT_EQ(tall.SpacingXM(), 0.75);
        EXPECT_EQ(tall.SpacingYM(), 1.25);
    }
}

TEST(WithAmplitude, RefusesNegativeAmplitudesAndFlatFields) {
    const HeightField field = AllKinds().front();
    const auto given = [&](double amplitude_m) {
        return MessageOf([&] { WithAmplitude(field, amplitude_m); });
    };
    EXPECT_EQ(given(-1), "amplitude in metres = -1, must be finite and >= 0");
    EXPECT_EQ(given(kNan), "amplitude in metres = nan, must be finite and >= 0");
    EXPECT_EQ(given(kInf), "amplitude in metres = inf, must be finite and >= 0");
    const HeightField flat(Image<double>(3, 3, 5.0), 1, 1);
    EXPECT_EQ(MessageOf([&] { WithAmplitude(flat, 1); }),
              "the height field is flat: no amplitude can be given to it");
}

TEST(Shifted, RefusesFieldsThatDoNotWrap) {
    for (const Boundary boundary : {Boundary::kMirror, Boundary::kOpen}) {
        const HeightField field(RandomHeights(4, 4, 1, 3), 1, 1, boundary);
        EXPECT_EQ(MessageOf([&] { Shifted(field, 1, 0); }),
                  "Shifted: the field must wrap, or its tile has an inside and an outside");
    }
}

TEST(Symmetries, MoveTexelsAsTheySay) {
    for (const HeightField& field : AllKinds()) {
        const HeightField mirrored = MirroredX(field), turned = QuarterTurned(field);
        EXPECT_NE(mirrored.GetDiagonal(), field.GetDiagonal());
        EXPECT_NE(turned.GetDiagonal(), field.GetDiagonal());
        EXPECT_EQ(turned.SpacingXM(), field.SpacingYM());
        EXPECT_EQ(turned.SpacingYM(), field.SpacingXM());
        for (int j = 0; j < 5; ++j) {
            for (int i = 0; i < 7; ++i) {
                EXPECT_EQ(mirrored.At(6 - i, j), field.At(i, j));
                // (x, y) -> (-y, x).
                EXPECT_EQ(turned.At(4 - j, i), field.At(i, j));
            }
        }
        if (field.GetBoundary() == Boundary::kWrap) {
            const HeightField shifted = Shifted(field, -9, 3);
            for (int j = 0; j < 5; ++j)
                for (int i = 0; i < 7; ++i)
                    EXPECT_EQ(shifted.At((i - 9 + 14) % 7, (j + 3) % 5), field.At(i, j));
        }
    }
}

TEST(Symmetries, AQuarterTurnFourTimesIsNothing) {
    const HeightField field = AllKinds().front();
    const HeightField same = QuarterTurned(QuarterTurned(QuarterTurned(QuarterTurned(field))));
    EXPECT_EQ(same.HeightsM(), field.HeightsM());
    EXPECT_EQ(same.GetDiagonal(), field.GetDiagonal());
}

// Texel (i, j) of the endless field, by walking there one texel at a time: the definition of
// the boundary, not its arithmetic.
int Steps(int i, int n, Boundary boundary) {
    int at = 0, step = i < 0 ? -1 : 1;
    for (int k = 0; k < std::abs(i); ++k) {
        if (boundary == Boundary::kWrap) {
            at = at + step == n ? 0 : (at + step < 0 ? n - 1 : at + step);
        } else {
            if (at + step == n || at + step < 0) step = -step;
            at += step;
        }
    }
    return at;
}

Vec3 TexelM(const HeightField& field, int i, int j) {
    return {(i + 0.5) * field.SpacingXM(), (j + 0.5) * field.SpacingYM(),
            field.At(Steps(i, field.Width(), field.GetBoundary()),
                     Steps(j, field.Height(), field.GetBoundary()))};
}

TEST(FacetOf, HasTheCornersOfTheFigure) {
    for (const HeightField& field : AllKinds()) {
        const bool rising = field.GetDiagonal() == Diagonal::kRising;
        for (int j = 0; j < field.CellsY(); ++j) {
            for (int i = 0; i < field.CellsX(); ++i) {
                const Vec3 a = TexelM(field, i, j), b = TexelM(field, i + 1, j);
                const Vec3 c = TexelM(field, i + 1, j + 1), d = TexelM(field, i, j + 1);
                const std::int64_t cell = std::int64_t(j) * field.CellsX() + i;
                const auto lower = FacetOf(field, 2 * cell).corners_m;
                const auto upper = FacetOf(field, 2 * cell + 1).corners_m;
                const std::array<Vec3, 3> lower_expected{a, b, rising ? c : d};
                const std::array<Vec3, 3> upper_expected{rising ? a : b, c, d};
                for (int k = 0; k < 3; ++k) {
                    EXPECT_EQ(lower[k], lower_expected[k]) << "cell " << i << ", " << j;
                    EXPECT_EQ(upper[k], upper_expected[k]) << "cell " << i << ", " << j;
                }
            }
        }
    }
}

TEST(FacetOf, NormalAndAreaAreThoseOfTheTriangle) {
    for (const HeightField& field : AllKinds()) {
        for (std::int64_t number = 0; number < field.Facets(); ++number) {
            const Facet f = FacetOf(field, number);
            const Vec3 e = f.corners_m[1] - f.corners_m[0], g = f.corners_m[2] - f.corners_m[0];
            // 1e-14: a few roundings of lengths below 10.
            EXPECT_NEAR(f.normal.norm(), 1, 1e-14);
            EXPECT_NEAR(f.normal.dot(e), 0, 1e-14);
            EXPECT_NEAR(f.normal.dot(g), 0, 1e-14);
            EXPECT_GT(f.normal.z(), 0);
            EXPECT_NEAR(f.area_m2 * f.normal.z(), 0.75 * 1.25 / 2, 1e-14);
            // Heron's formula knows lengths only.
            const double p = e.norm(), q = g.norm(), r = (e - g).norm(), s = (p + q + r) / 2;
            EXPECT_NEAR(f.area_m2, std::sqrt(s * (s - p) * (s - q) * (s - r)), 1e-12);
            EXPECT_NEAR((f.CentroidM() - f.corners_m[2]).dot(f.normal), 0, 1e-14);
        }
    }
}

// A triangle as its corners in metres, sorted, so that two may be compared however they begin.
using Triangle = std::array<std::array<float, 3>, 3>;

Triangle Sorted(const std::array<Vec3f, 3>& corners) {
    Triangle out;
    for (int k = 0; k < 3; ++k) out[k] = {corners[k].x(), corners[k].y(), corners[k].z()};
    std::sort(out.begin(), out.end());
    return out;
}

Triangle Sorted(const Facet& facet) {
    std::array<Vec3f, 3> corners;
    for (int k = 0; k < 3; ++k) corners[k] = facet.corners_m[k].cast<float>();
    return Sorted(corners);
}

// The two triangles of a quad as Embree cuts it: along b-d.
std::array<std::array<Vec3f, 3>, 2> Cut(const Mesh& mesh, std::size_t quad) {
    const auto [a, b, c, d] = mesh.quads[quad];
    const auto& v = mesh.vertices_m;
    return {std::array<Vec3f, 3>{v[a], v[b], v[d]}, std::array<Vec3f, 3>{v[c], v[d], v[b]}};
}

TEST(ToMesh, QuadCHoldsFacets2CAnd2CPlus1) {
    for (const HeightField& field : AllKinds()) {
        const Mesh mesh = ToMesh(field);
        ASSERT_EQ(std::int64_t(mesh.quads.size()), field.Facets() / 2);
        for (std::size_t c = 0; c < mesh.quads.size(); ++c) {
            const auto halves = Cut(mesh, c);
            EXPECT_EQ(Sorted(halves[0]), Sorted(FacetOf(field, 2 * std::int64_t(c))));
            EXPECT_EQ(Sorted(halves[1]), Sorted(FacetOf(field, 2 * std::int64_t(c) + 1)));
        }
    }
}

TEST(ToMesh, EveryTriangleLooksUp) {
    for (const HeightField& field : AllKinds()) {
        const int tiles = field.GetBoundary() == Boundary::kOpen ? 0 : 2;
        const Mesh mesh = ToMesh(field, tiles);
        for (std::size_t c = 0; c < mesh.quads.size(); ++c) {
            for (const auto& t : Cut(mesh, c)) {
                EXPECT_GT((t[1] - t[0]).cross(t[2] - t[0]).z(), 0);
            }
        }
    }
}

// Expected: where a tile is moved, so is every triangle; where it is mirrored, every triangle
// is. The image of facet corners is worked out here from the facets of the middle tile.
TEST(ToMesh, TilesAreTheMiddleOneMovedOrMirrored) {
    for (const HeightField& field : AllKinds()) {
        if (field.GetBoundary() == Boundary::kOpen) continue;
        const bool mirrors = field.GetBoundary() == Boundary::kMirror;
        const double w = field.WidthM(), h = field.HeightM();
        const double s_x = field.SpacingXM(), s_y = field.SpacingYM();
        std::vector<Triangle> expected;
        for (int tj = -2; tj <= 2; ++tj) {
            for (int ti = -2; ti <= 2; ++ti) {
                for (std::int64_t number = 0; number < field.Facets(); ++number) {
                    Facet f = FacetOf(field, number);
                    for (Vec3& p : f.corners_m) {
                        // From the corner of the tile; the mirror stands on its two ends.
                        double x = p.x() - 0.5 * s_x, y = p.y() - 0.5 * s_y;
                        if (mirrors && ti % 2 != 0) x = w - x;
                        if (mirrors && tj % 2 != 0) y = h - y;
                        p.x() = x + ti * w + 0.5 * s_x;
                        p.y() = y + tj * h + 0.5 * s_y;
                    }
                    expected.push_back(Sorted(f));
                }
            }
        }
        const Mesh mesh = ToMesh(field, 2);
        std::vector<Triangle> found;
        for (std::size_t c = 0; c < mesh.quads.size(); ++c) {
            for (const auto& t : Cut(mesh, c)) found.push_back(Sorted(t));
        }
        std::sort(expected.begin(), expected.end());
        std::sort(found.begin(), found.end());
        // Spacings are dyadic: no coordinate is rounded on the way to float or back.
        EXPECT_EQ(found, expected);
    }
}

TEST(ToMesh, DoesNotRepeatAnOpenField) {
    // Beyond the border of an open field there is nothing to repeat.
    const HeightField open(RandomHeights(4, 3, 1, 5), 1, 1, Boundary::kOpen);
    EXPECT_EQ(ToMesh(open, 3).quads.size(), 3u * 2u);
}

}  // namespace
}  // namespace plumb
