// The pieces of steep facets: how many, how large, and points on them.
#include "heightfield/facet_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/random.h"

namespace plumb {
namespace {

HeightField Steps() {
    // Cells along x rise by 0, 1, 4 and 40 texels; one row of cells is tilted in y as well.
    Image<double> heights(5, 3);
    const double z[] = {0, 0, 1, 5, 45};
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 5; ++i) heights(i, j) = z[i] + (j == 2 ? 0.25 : 0);
    }
    return HeightField(std::move(heights), 2, 0.5, Boundary::kOpen);
}

TEST(FacetPieces, AreTheFacetsWhereNothingIsCut) {
    const HeightField field = Steps();
    for (const CutOptions& none : {CutOptions{}, CutOptions{.extent_texels = 100},
                                   CutOptions{.extent_texels = 1, .most_pieces = 1}}) {
        const FacetPieces pieces(field, none);
        ASSERT_EQ(pieces.Count(), field.Facets());
        for (std::int64_t f = 0; f < field.Facets(); ++f) {
            EXPECT_EQ(pieces.First(f), f);
            EXPECT_EQ(pieces.FacetOf(f), f);
            EXPECT_EQ(pieces.PiecesOf(f), 1);
            EXPECT_EQ(pieces.Share(f), 1);
            EXPECT_EQ(pieces.At(f, 3), f);
        }
    }
}

// Expected: ceil(rise / (1.5 texels of sqrt(2 x 0.5) = 1 m)), 8 at most, in the row of level
// lines.
TEST(FacetPieces, AreAsManyAsTheRiseNeeds) {
    const HeightField field = Steps();
    const FacetPieces pieces(field, {.extent_texels = 1.5});
    const int expected[] = {1, 1, 3, 8};
    std::int64_t next = 0;
    for (std::int64_t f = 0; f < field.Facets(); ++f) {
        if (f < 8) {
            EXPECT_EQ(pieces.PiecesOf(f), expected[f / 2]);
        }
        EXPECT_EQ(pieces.First(f), next);
        double shares = 0;
        for (int k = 0; k < pieces.PiecesOf(f); ++k, ++next) {
            EXPECT_EQ(pieces.FacetOf(next), f);
            EXPECT_GT(pieces.Share(next), 0);
            shares += pieces.Share(next);
        }
        EXPECT_NEAR(shares, 1, 1e-15);
    }
    EXPECT_EQ(pieces.Count(), next);
}

// A facet between heights 5 and 45 with a level edge: below z its share is ((z - 5) / 40)^2 if
// the edge is on top, 1 - ((45 - z) / 40)^2 if it is below.
TEST(FacetPieces, OfAFacetWithALevelEdgeHaveTheirClosedForm) {
    const HeightField field = Steps();
    const FacetPieces pieces(field, {.extent_texels = 1, .most_pieces = 4});
    for (const std::int64_t f : {6, 7}) {
        const Facet facet = FacetOf(field, f);
        int high = 0;
        for (const Vec3& p : facet.corners_m) high += p.z() == 45;
        for (int k = 0; k < 4; ++k) {
            const double a = k / 4.0, b = (k + 1) / 4.0;
            const std::int64_t piece = pieces.First(f) + k;
            EXPECT_NEAR(pieces.Share(piece),
                        high == 2 ? b * b - a * a : (1 - a) * (1 - a) - (1 - b) * (1 - b),
                        1e-15);
            EXPECT_EQ(pieces.LowM(piece), 5 + 40 * a);
            EXPECT_EQ(pieces.At(f, 5 + 40 * (a + b) / 2), piece);
        }
        EXPECT_EQ(pieces.At(f, -7), pieces.First(f));
        EXPECT_EQ(pieces.At(f, 99), pieces.First(f) + 3);
        EXPECT_NEAR(ShareBelow(facet, 25), high == 2 ? 0.25 : 0.75, 1e-15);
    }
}

// Expected: barycentric coordinates of uniform points are each 1/3 on average, with the second
// moment 1/6; u is the share below the point. On a midpoint grid of n x n the means are right to
// 1/n^2, and the square roots at the tips make it 1/n^1.5.
TEST(PointAboveShareM, IsUniformOverTheFacet) {
    const double heights[][3] = {{1, 4, 2}, {1, 1, 2}, {3, 1, 3}};
    const int n = 64;
    for (const auto& z : heights) {
        Facet facet;
        facet.corners_m = {Vec3(0, 0, z[0]), Vec3(1, 0, z[1]), Vec3(0.5, 1, z[2])};
        Eigen::Matrix3d corners;
        for (int c = 0; c < 3; ++c) corners.col(c) = facet.corners_m[std::size_t(c)];
        const Eigen::Matrix3d inverse = corners.inverse();
        Vec3 mean = Vec3::Zero(), square = Vec3::Zero();
        for (int a = 0; a < n; ++a) {
            for (int b = 0; b < n; ++b) {
                const double u = (a + 0.5) / n;
                const Vec3 x = PointAboveShareM(facet, u, (b + 0.5) / n);
                EXPECT_NEAR(ShareBelow(facet, x.z()), u, 1e-12);
                const Vec3 bary = inverse * x;
                EXPECT_GE(bary.minCoeff(), -1e-12);
                mean += bary / (n * n);
                square += bary.cwiseProduct(bary) / (n * n);
            }
        }
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(mean[c], 1 / 3.0, std::pow(n, -1.5));
            EXPECT_NEAR(square[c], 1 / 6.0, std::pow(n, -1.5));
        }
    }
}

// Expected: by hand, with the shares of a facet cut in two at half its height.
TEST(FacetPieces, MeansWeighByShare) {
    const HeightField field = Steps();
    const FacetPieces pieces(field, {.extent_texels = 1, .most_pieces = 2});
    std::vector<double> ones(std::size_t(pieces.Count()), 1.0), upper(ones.size(), 0.0);
    for (std::int64_t p = 0; p < pieces.Count(); ++p) {
        const std::int64_t f = pieces.FacetOf(p);
        upper[std::size_t(p)] = p == pieces.First(f) + pieces.PiecesOf(f) - 1;
    }
    for (const double mean : pieces.FacetMeans(std::span<const double>(ones))) {
        EXPECT_NEAR(mean, 1, 1e-15);
    }
    const std::vector<double> means = pieces.FacetMeans(std::span<const double>(upper));
    EXPECT_EQ(means[0], 1);                      // Level: one piece.
    EXPECT_NEAR(means[6] + means[7], 1, 1e-15);  // 1/4 and 3/4.
    EXPECT_NEAR(std::abs(means[6] - means[7]), 0.5, 1e-15);
}

TEST(FacetPieces, RefuseWhatMakesNoSense) {
    const auto message = [](const CutOptions& options) -> std::string {
        try {
            FacetPieces pieces(Steps(), options);
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    };
    EXPECT_EQ(message({.extent_texels = -1}),
              "CutOptions::extent_texels = -1, must be finite and >= 0");
    EXPECT_EQ(message({.most_pieces = 0}), "CutOptions::most_pieces = 0, must be in [1, 256]");
    EXPECT_EQ(message({.most_pieces = 257}),
              "CutOptions::most_pieces = 257, must be in [1, 256]");
    EXPECT_NE(message({.extent_texels = std::nan("")}), "no error");
}

}  // namespace
}  // namespace plumb
