#include "core/warp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/conventions.h"
#include "core/random.h"
#include "tests/core/significance.h"

namespace plumb {
namespace {

constexpr int kSamples = 1 << 17;

Vec2 RandomPoint(std::uint64_t i) {
    return {RandomUnit(1, 0, i, 0), RandomUnit(1, 0, i, 1)};
}

/// A rectangle of the plane in which a warp's results are counted, with the expected share of
/// a cell: its density there times the area element, by an 8 x 8 midpoint rule (exact for all
/// densities here, which are linear in each coordinate).
struct Chart {
    double width, height;
    std::function<Vec2(const Vec2& u)> sample;         ///< Sample(u) in chart coordinates.
    std::function<double(double a, double b)> weight;  ///< Pdf times the area element.

    double Share(double a, double b, double da, double db) const {
        double sum = 0;
        for (int i = 0; i < 8; ++i) {
            for (int j = 0; j < 8; ++j) {
                sum += weight(a + (i + 0.5) / 8 * da, b + (j + 0.5) / 8 * db);
            }
        }
        return sum / 64 * da * db;
    }
};

void ExpectSamplesFollowThePdf(const Chart& chart, int columns = 16, int rows = 32) {
    std::vector<int> counts(std::size_t(columns * rows));
    for (std::uint64_t i = 0; i < kSamples; ++i) {
        const Vec2 p = chart.sample(RandomPoint(i));
        // w_z = 0 and |p| = 1 are on the border and belong to the last column.
        const int column = std::min(int(p.x() / chart.width * columns), columns - 1);
        const int row = int(p.y() / chart.height * rows);
        ASSERT_TRUE(0 <= column && p.x() < 1 + 1e-15 && 0 <= row && row < rows) << p;
        ++counts[std::size_t(column * rows + row)];
    }
    std::vector<double> expected;
    const double da = chart.width / columns, db = chart.height / rows;
    double total = 0;
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            expected.push_back(kSamples * chart.Share(column * da, row * db, da, db));
            total += expected.back();
        }
    }
    EXPECT_NEAR(total / kSamples, 1, 1e-12);  // Int Pdf = 1; 512 cells of rounding
    EXPECT_GT(ChiSquarePValue(counts, expected), kLevel);
}

double Turn(double x, double y) {
    const double turn = std::atan2(y, x) / (2 * kPi);
    return turn < 0 ? turn + 1 : turn;
}

Vec3 Direction(double z, double turn) {
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(2 * kPi * turn), r * std::sin(2 * kPi * turn), z};
}

/// A hemisphere as (1 - z, turns): solid angle = 2 pi d(1 - z) d(turns).
Chart HemisphereChart(Vec3 (*sample)(const Vec2&), double (*pdf)(const Vec3&)) {
    return {.width = 1,
            .height = 1,
            .sample =
                [=](const Vec2& u) {
                    const Vec3 w = sample(u);
                    return Vec2(1 - w.z(), Turn(w.x(), w.y()));
                },
            .weight = [=](double a, double b) { return 2 * kPi * pdf(Direction(1 - a, b)); }};
}

TEST(UniformHemisphere, SamplesFollowThePdf) {
    ExpectSamplesFollowThePdf(HemisphereChart(SampleUniformHemisphere, PdfUniformHemisphere));
}

TEST(CosineHemisphere, SamplesFollowThePdf) {
    ExpectSamplesFollowThePdf(HemisphereChart(SampleCosineHemisphere, PdfCosineHemisphere));
}

TEST(Disk, SamplesFollowThePdf) {
    // As (radius, turns): area = 2 pi r dr d(turns).
    ExpectSamplesFollowThePdf(
        {.width = 1,
         .height = 1,
         .sample =
             [](const Vec2& u) {
                 const Vec2 p = SampleDisk(u);
                 return Vec2(p.norm(), Turn(p.x(), p.y()));
             },
         .weight =
             [](double r, double turn) {
                 const double phi = 2 * kPi * turn;
                 return 2 * kPi * r * PdfDisk(Vec2(r * std::cos(phi), r * std::sin(phi)));
             }});
}

// Expected: of n x n cells of the square (b_0, b_1) those below the diagonal lie wholly in the
// triangle and hold 2 / n^2 of its area, those on it half of that.
TEST(Triangle, SamplesFollowThePdf) {
    const int n = 24;
    std::vector<int> counts(n * n);
    for (std::uint64_t i = 0; i < kSamples; ++i) {
        const Vec2 b = SampleTriangle(RandomPoint(i));
        ++counts[std::size_t(b.x() * n) * n + std::size_t(b.y() * n)];
    }
    std::vector<int> inside;
    std::vector<double> expected;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n - i; ++j) {
            const Vec2 centre((i + 0.4) / n, (j + 0.4) / n);
            inside.push_back(counts[std::size_t(i * n + j)]);
            expected.push_back(PdfTriangle(centre) * kSamples / (n * n) /
                               (j == n - i - 1 ? 2 : 1));
        }
    }
    EXPECT_GT(ChiSquarePValue(inside, expected), kLevel);
    EXPECT_EQ(std::accumulate(inside.begin(), inside.end(), 0), kSamples);
    EXPECT_EQ(PdfTriangle(Vec2(0.6, 0.6)), 0);
    EXPECT_EQ(PdfTriangle(Vec2(-0.1, 0.6)), 0);
}

/// A grid with the borders of the square in it, but for u_x = 0, where the pole of a warp in
/// polar coordinates forgets u_y; the caller adds the points where its warp has none.
std::vector<Vec2> Grid() {
    std::vector<Vec2> grid;
    for (double x : {1e-9, 0.1, 0.25, 0.3, 0.5, 0.7, 0.75, 0.99, 1 - 0x1p-53}) {
        for (double y : {0.0, 1e-9, 0.1, 0.25, 0.5, 0.6, 0.75, 0.9, 1 - 0x1p-50}) {
            grid.push_back({x, y});
        }
    }
    return grid;
}

// Tolerance of the three inverses: each goes through a square root of 1 - z, whose rounding
// 1e-16 weighs most where u_x = 1e-9: relative 1e-16 / 1e-9 of an angle, absolute 1e-7 at the
// worst, and 1e-12 elsewhere.
double Tolerance(const Vec2& u) {
    return u.x() < 1e-6 ? 1e-7 : 1e-12;
}

TEST(UniformHemisphere, InvertUndoesSample) {
    for (const Vec2& u : Grid()) {
        const Vec3 w = SampleUniformHemisphere(u);
        EXPECT_NEAR(w.norm(), 1, 1e-15);
        EXPECT_NEAR((InvertUniformHemisphere(w) - u).norm(), 0, Tolerance(u)) << u.transpose();
    }
}

TEST(CosineHemisphere, InvertUndoesSample) {
    for (const Vec2& u : Grid()) {
        const Vec3 w = SampleCosineHemisphere(u);
        EXPECT_NEAR(w.norm(), 1, 1e-15);
        EXPECT_GE(w.z(), 0);
        EXPECT_NEAR((InvertCosineHemisphere(w) - u).norm(), 0, Tolerance(u)) << u.transpose();
    }
    EXPECT_EQ(SampleCosineHemisphere({0.5, 0.5}), Vec3(0, 0, 1));
    EXPECT_EQ(InvertCosineHemisphere(Vec3(0, 0, 1)), Vec2(0.5, 0.5));
}

TEST(Disk, InvertUndoesSample) {
    for (const Vec2& u : Grid()) {
        const Vec2 p = SampleDisk(u);
        EXPECT_LE(p.norm(), 1 + 1e-15);
        EXPECT_NEAR((InvertDisk(p) - u).norm(), 0, Tolerance(u)) << u.transpose();
    }
}

TEST(Triangle, InvertUndoesSample) {
    for (const Vec2& u : Grid()) {
        EXPECT_NEAR((InvertTriangle(SampleTriangle(u)) - u).norm(), 0, Tolerance(u));
    }
}

TEST(Pdf, IsZeroOutside) {
    EXPECT_EQ(PdfUniformHemisphere(Vec3(0.6, 0, -0.8)), 0);
    EXPECT_EQ(PdfCosineHemisphere(Vec3(0.6, 0, -0.8)), 0);
    EXPECT_EQ(PdfDisk(Vec2(0.8, 0.7)), 0);
}

// Every direction, both poles, the sign change at n_z = -0 and the neighbourhood of -z where
// older constructions break down.
TEST(Basis, IsRightHandedAndOrthonormal) {
    std::vector<Vec3> normals{{0, 0, 1},
                              {0, 0, -1},
                              {1, 0, 0},
                              {0, -1, 0},
                              {1, 0, -0.0},
                              Vec3(1e-9, 1e-9, -1).normalized(),
                              Vec3(-1e-5, 1e-4, -1).normalized()};
    for (std::uint64_t i = 0; i < 1000; ++i) {
        const Vec3 w = SampleUniformHemisphere(RandomPoint(i));
        normals.push_back(w);
        normals.push_back(-w);
    }
    for (const Vec3& n : normals) {
        const Basis basis(n);
        Eigen::Matrix3d frame;
        frame << basis.s, basis.t, basis.n;
        // Tolerance: products of three rounded numbers of size 1.
        EXPECT_NEAR((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 0, 4e-15)
            << n.transpose();
        EXPECT_NEAR(frame.determinant(), 1, 4e-15);
        const Vec3 v(0.3, -0.5, 0.7);
        EXPECT_NEAR((basis.ToLocal(basis.ToWorld(v)) - v).norm(), 0, 4e-15);
        EXPECT_NEAR((basis.ToWorld(Vec3(0, 0, 1)) - n).norm(), 0, 1e-15);
    }
}

}  // namespace
}  // namespace plumb
