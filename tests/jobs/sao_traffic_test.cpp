// The bytes that passes touch, counted by hand where taps go nowhere, and the laws of counting.
#include "jobs/screen_space/sao_traffic.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "jobs/screen_space/technique.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "tests/jobs/made_scenes.h"

namespace plumb {
namespace {

const PassBytes& Of(const std::vector<PassBytes>& traffic, const std::string& name) {
    return *std::ranges::find(traffic, name, &PassBytes::name);
}

// 32 x 16 px shown, 16 px of border: 64 x 48 drawn. The filter reaches 8 px: 48 x 32 are computed.
GBuffer Drawn() {
    const Scene scene = FloorAndWall(32, 16);
    return DrawGBuffer(scene, scene.cameras.front(), {.guard_px = 16});
}

// Discs of less than a pixel: taps meet the pixel itself. By hand, of 1536 computed pixels:
// sample z and normal in, A out; blurs read 8 px more on both sides of their axis.
TEST(SaoTraffic, IsCountedByHandWhereTapsGoNowhere) {
    SaoOptions sao = SaoWith("supplement2012", {.radius_m = 0.001});
    sao.sampling.normals = NormalSource::kFace;
    const std::vector<PassBytes> traffic = SaoTraffic(Drawn(), sao);
    ASSERT_EQ(traffic.size(), 6u);
    const double computed = 48 * 32;
    // Levels of 64 x 48, 32 x 24, 16 x 12, 8 x 6, 4 x 3, 2 x 2; the rotated grid has one source.
    EXPECT_EQ(Of(traffic, "z pyramid").written, 4 * (3072 + 768 + 192 + 48 + 12 + 4));
    EXPECT_EQ(Of(traffic, "z pyramid").read, 4 * (3072 + 768 + 192 + 48 + 12 + 4));
    EXPECT_EQ(Of(traffic, "sample").read, 16 * computed);
    EXPECT_EQ(Of(traffic, "sample").written, 4 * computed);
    EXPECT_EQ(Of(traffic, "quads").read, 8 * computed);
    EXPECT_EQ(Of(traffic, "quads").written, 4 * computed);
    EXPECT_EQ(Of(traffic, "pack").read, 8 * computed);
    EXPECT_EQ(Of(traffic, "pack").written, 8 * computed);
    EXPECT_EQ(Of(traffic, "blur x").read, 8 * 64 * 32 + 4 * computed);
    EXPECT_EQ(Of(traffic, "blur x").written, 4 * computed);
    EXPECT_EQ(Of(traffic, "blur y").read, 8 * 48 * 48 + 4 * computed);
    double total = 0;
    for (const PassBytes& pass : traffic) total += pass.read + pass.written;
    EXPECT_EQ(TotalBytes(traffic), total);

    sao.sampling.taps.filter = ZFilter::kMean;  // Reads the whole of the level below.
    EXPECT_EQ(Of(SaoTraffic(Drawn(), sao), "z pyramid").read,
              4 * (3072 + 3072 + 768 + 192 + 48 + 12));
}

// Expected: AlchemyAO has no pyramid but its copy of z, no quads, no packing.
TEST(SaoTraffic, ChargesAlchemyNoPyramid) {
    const std::vector<PassBytes> traffic =
        SaoTraffic(Drawn(), SaoWith("alchemy", {.radius_m = 0.5}));
    std::vector<std::string> names;
    for (const PassBytes& pass : traffic) names.push_back(pass.name);
    EXPECT_EQ(names,
              (std::vector<std::string>{"z pyramid", "sample", "key", "blur x", "blur y"}));
    EXPECT_EQ(Of(traffic, "z pyramid").read, 4 * 3072);
    EXPECT_EQ(Of(traffic, "z pyramid").written, 4 * 3072);
}

// Expected: the set of texels that the taps of every computed pixel meet, made here; normals given.
TEST(SaoTraffic, CountsEachTexelThatTapsMeetOnce) {
    const GBuffer gbuffer = Drawn();
    SaoOptions sao = SaoWith("supplement2012", {.radius_m = 2});
    sao.sampling.normals = NormalSource::kShading;
    const ZPyramid pyramid = BuildZPyramid(gbuffer, sao);
    std::set<std::tuple<int, int, int>> met;
    bool coarse = false;
    for (int y = 8; y < 40; ++y) {
        for (int x = 8; x < 56; ++x) {
            met.insert({0, x, y});
            if (gbuffer.triangle(x, y) == GBuffer::kSky) continue;
            const TapOptions& taps = sao.sampling.taps;
            const double disc_px = DiscRadiusPx(gbuffer.view, 2, gbuffer.z_m(x, y));
            for (int i = 0; i < taps.samples; ++i) {
                const UnitTap tap = TapOf(taps, i);
                const double theta =
                    TurnedAngle(tap.angle_rad, RotationHash(x, y, taps.hash), taps.phi);
                const TapTexel texel = LookUpTap(taps, pyramid, x, y, tap.alpha * disc_px,
                                                 {std::cos(theta), std::sin(theta)});
                met.insert({texel.level, texel.i, texel.j});
                coarse = coarse || texel.level > 0;
            }
        }
    }
    EXPECT_TRUE(coarse);
    EXPECT_EQ(Of(SaoTraffic(gbuffer, sao), "sample").read,
              4 * double(met.size()) + 12 * 48 * 32);
    // Normals made from depth read no normals, and of z only the other pixels of a quad, which
    // taps or the pass itself read anyway but at the rim of what is computed.
    sao.sampling.normals = NormalSource::kDepth;
    const double from_depth = Of(SaoTraffic(gbuffer, sao), "sample").read;
    EXPECT_GE(from_depth, 4 * double(met.size()));
    EXPECT_LE(from_depth, 4 * double(met.size() + 2 * (48 + 32)));
}

// Discs of less than a pixel whose taps are held 3 px off. Expected: the texels at that distance, made
// here.
TEST(SaoTraffic, CountsTapsWhereTheirLeastDistancePutsThem) {
    const GBuffer gbuffer = Drawn();
    SaoOptions sao = SaoWith("supplement2012", {.radius_m = 0.001});
    sao.sampling.normals = NormalSource::kShading;
    sao.sampling.taps.min_tap_px = 3;
    const TapOptions& taps = sao.sampling.taps;
    const ZPyramid pyramid = BuildZPyramid(gbuffer, sao);
    std::set<std::tuple<int, int, int>> met;
    for (int y = 8; y < 40; ++y) {
        for (int x = 8; x < 56; ++x) {
            met.insert({0, x, y});
            if (gbuffer.triangle(x, y) == GBuffer::kSky) continue;
            for (int i = 0; i < taps.samples; ++i) {
                const double theta = TurnedAngle(TapOf(taps, i).angle_rad,
                                                 RotationHash(x, y, taps.hash), taps.phi);
                const TapTexel texel =
                    LookUpTap(taps, pyramid, x, y, 3, {std::cos(theta), std::sin(theta)});
                met.insert({texel.level, texel.i, texel.j});
            }
        }
    }
    EXPECT_GT(met.size(), 48u * 32);  // Beyond what is computed.
    EXPECT_EQ(Of(SaoTraffic(gbuffer, sao), "sample").read,
              4 * double(met.size()) + 12 * 48 * 32);
}

}  // namespace
}  // namespace plumb
