#include "jobs/light/albedo_light.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "formfactor/slice_links.h"
#include "jobs/light/surface.h"
#include "tests/closed_forms/analytic_fields.h"

namespace plumb {
namespace {

// Expected: the mean of the three corners, by the definition of a facet (heightfield/facet.h).
// Texel (i, j) has red 0.1 i + 0.01 j; facet 0 has the corners (0,0) (1,0) (1,1).
TEST(FacetAlbedos, AreTheMeanOfTheCorners) {
    const HeightField field = MakeFlat({.width_texels = 4, .height_texels = 3});
    Image<Rgb> albedo(4, 3);
    for (int j = 0; j < 3; ++j) {
        for (int i = 0; i < 4; ++i)
            albedo(i, j) = {0.1F * float(i) + 0.01F * float(j), 0.5F, 1};
    }
    const auto facets = FacetAlbedos(field, albedo);
    EXPECT_NEAR(facets[0][0], (0 + 0.1 + 0.11) / 3, 1e-7);
    EXPECT_NEAR(facets[0][1], (0 + 0.11 + 0.01) / 3, 1e-7);
    EXPECT_NEAR(facets[1][5], 0.5, 1e-7);
    EXPECT_EQ(facets[2][7], 1);
}

TEST(FacetAlbedos, RefuseAnotherSizeAndValuesOutsideTheRange) {
    const HeightField field = MakeFlat({.width_texels = 4, .height_texels = 3});
    EXPECT_THROW(FacetAlbedos(field, Image<Rgb>(3, 3)), Error);
    Image<Rgb> bright(4, 3);
    bright(2, 1)[1] = 1.5F;
    try {
        FacetAlbedos(field, bright);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "albedo map: pixel (2, 1) = 1.5, must be in [0, 1]");
    }
}

// Expected: a surface that reflects red saturates: E_red > E_green > E_blue >= V wherever light
// bounces at all, because E rises with the albedo.
TEST(ColouredLight, SaturatesInTheHollows) {
    const Surface wall = LoadSurface("make:bricks:24");
    const FacetPieces pieces(wall.field, {.extent_texels = 0.5});
    ASSERT_GT(pieces.Count(), pieces.Facets());
    const Links links = LinksBySlices(wall.field, pieces, {.slices = 8});
    const std::vector<double> V = pieces.FacetMeans(std::span<const double>(links.V));
    const std::size_t n = V.size();
    const auto E = ColouredLight(links, pieces,
                                 {std::vector<double>(n, 0.9), std::vector<double>(n, 0.5),
                                  std::vector<double>(n, 0.0)});
    int hollows = 0;
    for (std::size_t i = 0; i < n; ++i) {
        EXPECT_NEAR(E[2][i], V[i], 1e-7);  // The solver's residual.
        if (V[i] > 0.95) continue;
        EXPECT_GT(E[0][i], E[1][i]);
        EXPECT_GT(E[1][i], E[2][i]);
        ++hollows;
    }
    EXPECT_GT(hollows, 100);
}

}  // namespace
}  // namespace plumb
