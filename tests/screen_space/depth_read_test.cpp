#include "screen_space/sao/depth_read.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenes/catalogue.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/sao/sao_presets.h"

namespace plumb {
namespace {

// Expected: n = 1, f infinite, z = -4: d = 3/4, of 65535 steps 49151.25, so 49151 is stored and
// z' = -1 / (1 - 49151/65535) = -65535/16384. In float 1 - d loses 2^-25 of 1/4.
TEST(DepthAsRead, ByHand) {
    const Image<float> read =
        DepthAsRead(Image<float>(1, 1, -4), {.near_m = 1}, DepthRead::kD16);
    EXPECT_NEAR(read(0, 0), -65535.0 / 16384, 4 * 4 * 0x1p-24);
}

TEST(DepthAsRead, SkyStaysAndTooFarBecomesSky) {
    Image<float> z_m(3, 1, GBuffer::kSkyZ);
    z_m(1, 0) = -1e6f;
    z_m(2, 0) = -0.5f;  // nearer than the near plane
    const Image<float> read = DepthAsRead(z_m, {.near_m = 1}, DepthRead::kD16);
    EXPECT_EQ(read(0, 0), GBuffer::kSkyZ);
    EXPECT_EQ(read(1, 0), GBuffer::kSkyZ);
    EXPECT_EQ(read(2, 0), -1);
    // A reversed float is as precise far away as near.
    const Image<float> reversed = DepthAsRead(z_m, {.near_m = 1}, DepthRead::kD32FReversed);
    EXPECT_NEAR(reversed(1, 0), -1e6, 1e6 * 0x1p-22);
}

struct Drawn {
    Scene scene = SceneKindNamed("cornell_box").make();
    GBuffer With(RasterOptions options) const {
        Camera camera = scene.cameras.front();
        camera.width_px = 64;
        camera.height_px = 48;
        options.range.near_m = 0.05;
        return DrawGBuffer(scene, camera, options);
    }
};

// Expected: the rasterizer's own buffer of that format, which it rounds from a float e: off by at most
// one step of it, and by 2^-24 (1 - d) of the float in which both are read back.
TEST(DepthAsRead, IsWhatTheRasterizerStores) {
    const Drawn drawn;
    for (const auto& [read, format] : {std::pair{DepthRead::kD16, DepthFormat::kD16},
                                       std::pair{DepthRead::kD24, DepthFormat::kD24}}) {
        const double step = format == DepthFormat::kD16 ? 1.0 / 65535 : 1.0 / 16777215;
        const GBuffer surface = drawn.With({.depth = format});
        const GBuffer stored = drawn.With({.depth = format, .z = ZSource::kStored});
        const Image<float> z_m = DepthAsRead(surface.z_m, surface.range, read);
        const DepthCurve curve(surface.range);
        int moved = 0, seen = 0;
        for (std::size_t p = 0; p < z_m.Pixels().size(); ++p) {
            if (surface.z_m.Pixels()[p] == GBuffer::kSkyZ) continue;
            const double e = curve.E(-z_m.Pixels()[p]),
                         expected = curve.E(-stored.z_m.Pixels()[p]);
            ASSERT_NEAR(e, expected, step + 0x1p-23) << p;
            moved += z_m.Pixels()[p] != surface.z_m.Pixels()[p];
            ++seen;
        }
        EXPECT_GT(moved, seen / 2);
    }
}

// Expected: SAO over a G-buffer whose depth was replaced by hand; the picture is another one.
TEST(DepthAsRead, IsWhatSaoReads) {
    const GBuffer surface = Drawn().With({});
    SaoOptions options = SaoSupplement2012();
    options.sampling.sao.radius_m = 0.3;
    options.depth = DepthRead::kD16;
    GBuffer rounded = surface;
    for (float& z : rounded.z_m.Pixels()) {
        const double d = std::round((1 - 0.05 / -double(z)) * 65535) / 65535;
        z = ReconstructZ(DepthFormat::kD16, surface.range, float(d));
    }
    const Image<float> A = SaoObscurance(surface, options);
    options.depth = DepthRead::kSurface;
    EXPECT_EQ(A.Pixels(), SaoObscurance(rounded, options).Pixels());
    EXPECT_NE(A.Pixels(), SaoObscurance(surface, options).Pixels());
}

}  // namespace
}  // namespace plumb
