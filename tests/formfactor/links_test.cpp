// Rows, blocks and products of links, apart from who makes them.
#include "formfactor/links.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "formfactor/make_links.h"
#include "formfactor/ray_links.h"
#include "formfactor/slice_links.h"
#include "tests/formfactor/fields.h"

namespace plumb {
namespace {

TEST(AppendRow, SortsMergesAndCloses) {
    LinkBlock block;
    LinkRow row = {{7, 0.125}, {2, 0.25}, {7, 0.0625}, {3, 0}};
    // Dyadic weights: nothing is rounded.
    EXPECT_EQ(AppendRow(row, block), 1 - 0.4375);
    EXPECT_EQ(block.facet, (std::vector<std::uint32_t>{2, 7}));
    EXPECT_EQ(block.weight, (std::vector<float>{0.25F, 0.1875F}));
    EXPECT_EQ(block.row_begin, (std::vector<std::uint32_t>{0, 2}));
    LinkRow none;
    EXPECT_EQ(AppendRow(none, block), 1);
    EXPECT_EQ(block.row_begin, (std::vector<std::uint32_t>{0, 2, 2}));
}

// Weights that sum to 1 in double but to more than 1 once each is rounded up to a float.
TEST(AppendRow, NeverLetsARowExceedOne) {
    for (int n = 2; n < 200; ++n) {
        LinkBlock block;
        LinkRow row;
        for (int k = 0; k < n; ++k) row.emplace_back(std::uint32_t(k), 1.0 / n);
        const double V = AppendRow(row, block);
        const double sum = std::accumulate(block.weight.begin(), block.weight.end(), 0.0);
        EXPECT_LE(sum, 1);
        EXPECT_EQ(V, 1 - sum);
        EXPECT_GE(V, 0);
        // Each weight may have been rounded by 2^-24 of itself.
        EXPECT_LE(V, kFloatRow);
    }
}

// Two blocks: rows on either side of the border between them, against a dense product.
TEST(Gather, IsTheProductOfTheMatrix) {
    struct Maker {
        FacetResult Make(std::int64_t i, LinkBlock& block) {
            LinkRow row;
            for (int k = 0; k < i % 4; ++k) {
                row.emplace_back(std::uint32_t((i * 31 + 7 * k) % 1500), 0.125 * (k + 1));
            }
            return {1, AppendRow(row, block), 0.5};
        }
    };
    const Links links = MakeLinks(
        1500, [] { return Maker(); }, SilentMonitor());
    EXPECT_EQ(links.blocks.size(), 2u);
    EXPECT_EQ(links.Facets(), 1500);
    // 0 + 1 + 2 + 3 links in four rows.
    EXPECT_EQ(links.Count(), 1500 / 4 * 6);
    EXPECT_GE(links.MemoryBytes(), std::size_t(links.Count()) * 8);
    EXPECT_DOUBLE_EQ(links.mean_cut_short, 0.5);
    std::vector<double> x(1500);
    for (std::size_t j = 0; j < x.size(); ++j) x[j] = double(j * j % 97);
    const std::vector<double> y = Gather(links, x);
    for (std::int64_t i = 0; i < 1500; ++i) {
        double expected = 0;  // Small multiples of 1/8: exact in any order.
        for (int k = 0; k < i % 4; ++k) {
            expected += 0.125 * (k + 1) * x[std::size_t((i * 31 + 7 * k) % 1500)];
        }
        EXPECT_EQ(y[std::size_t(i)], expected) << "row " << i;
    }
}

TEST(SliceOptions, AreRefusedByNameValueAndRule) {
    const auto with = [](auto change) {
        SliceOptions options;
        change(options);
        return MessageOf([&] { Validate(options); });
    };
    EXPECT_EQ(with([](auto&) {}), "no error");
    EXPECT_EQ(with([](auto& o) { o.slices = 3; }),
              "SliceOptions::slices = 3, must be in [4, 65536]");
    EXPECT_EQ(with([](auto& o) { o.slices = 65537; }),
              "SliceOptions::slices = 65537, must be in [4, 65536]");
    EXPECT_EQ(with([](auto& o) { o.links_per_slice = 0; }),
              "SliceOptions::links_per_slice = 0, must be >= 1");
    EXPECT_EQ(with([](auto& o) { o.horizon_tolerance_rad = 0; }),
              "SliceOptions::horizon_tolerance_rad = 0, must be in (0, 0.1]");
    EXPECT_EQ(with([](auto& o) { o.horizon_tolerance_rad = 0.2; }),
              "SliceOptions::horizon_tolerance_rad = 0.2, must be in (0, 0.1]");
    EXPECT_EQ(with([](auto& o) {
                  o.horizon_tolerance_rad = std::numeric_limits<double>::quiet_NaN();
              }),
              "SliceOptions::horizon_tolerance_rad = nan, must be in (0, 0.1]");
}

TEST(RayOptions, AreRefusedByNameValueAndRule) {
    RayOptions options;
    EXPECT_EQ(MessageOf([&] { Validate(options); }), "no error");
    options.rays = 0;
    EXPECT_EQ(MessageOf([&] { Validate(options); }),
              "RayOptions::rays = 0, must be in [1, 1048576]");
    options.rays = 1048577;
    EXPECT_EQ(MessageOf([&] { LinksByRays(RoughField(4, 4, 1), options); }),
              "RayOptions::rays = 1048577, must be in [1, 1048576]");
}

// Expected: 1/N of every uniform ray; 1/<n, d> of a cosine ray, and on the rim of the disc, where
// that is infinite, of the middle of a net's last cell: r = 1 - 2^-32, z = sqrt(1 - r^2).
TEST(SolidAngleWeight, IsFiniteOnTheRim) {
    EXPECT_EQ(SolidAngleWeight(RayDistribution::kUniform, 0), 1);
    EXPECT_EQ(SolidAngleWeight(RayDistribution::kCosine, 0.25), 4);
    const double r = 1 - std::exp2(-32);
    EXPECT_NEAR(SolidAngleWeight(RayDistribution::kCosine, 0), 1 / std::sqrt((1 - r) * (1 + r)),
                1e-5);
}

}  // namespace
}  // namespace plumb
