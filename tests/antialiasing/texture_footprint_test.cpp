// Levels of textures, footprints and anisotropic filtering.
#include "screen_space/antialiasing/texture_footprint.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "screen_space/antialiasing/deferred_shader.h"
#include "tests/antialiasing/made_pictures.h"

namespace plumb {
namespace {

Texture Of(Image<Rgb> albedo) {
    Texture texture;
    texture.albedo = std::move(albedo);
    return texture;
}

Rgb Mean(const Image<Rgb>& image) {
    std::array<double, 3> sum{};
    for (const Rgb& pixel : image.Pixels()) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += pixel[c];
    }
    Rgb mean;
    for (std::size_t c = 0; c < 3; ++c) mean[c] = float(sum[c] / double(image.Pixels().size()));
    return mean;
}

// Sizes 13 x 6, 6 x 3, 3 x 1, 1 x 1. A level covers the whole one below, so the mean of an area-
// weighted level is that of the texture; a rounding of 6e-8 a level.
TEST(MipChain, KeepsTheMeanWhateverTheSize) {
    const Image<Rgb> noise = NoisePicture(13, 6, 1);
    const MipChain chain(Of(noise));
    ASSERT_EQ(chain.Levels(), 4);
    EXPECT_EQ(chain.Level(0), noise);
    EXPECT_EQ(chain.Level(1).Width(), 6);
    EXPECT_EQ(chain.Level(1).Height(), 3);
    EXPECT_EQ(chain.Level(2).Width(), 3);
    EXPECT_EQ(chain.Level(2).Height(), 1);
    for (int l = 0; l < 4; ++l) {
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(Mean(chain.Level(l))[c], Mean(noise)[c], 3e-7) << l;
        }
    }
}

TEST(MipChain, MixesLevels) {
    const Texture texture = Of(NoisePicture(8, 8, 2));
    const MipChain chain(texture);
    const Vec2f uv(0.3f, 0.81f);
    EXPECT_EQ(chain.Trilinear(uv, 0), SampleAlbedo(texture, uv));
    EXPECT_EQ(chain.Trilinear(uv, -3), SampleAlbedo(texture, uv));
    EXPECT_EQ(chain.Trilinear(uv, std::nan("")), SampleAlbedo(texture, uv));
    EXPECT_EQ(chain.Trilinear(uv, 100), chain.Level(3)(0, 0));
    const float a = chain.Trilinear(uv, 1)[0], b = chain.Trilinear(uv, 2)[0];
    EXPECT_NEAR(chain.Trilinear(uv, 1.25)[0], 0.75f * a + 0.25f * b, 1e-6);
}

Footprint Along(double per_x_u, double per_y_v) {
    return {.per_x = {per_x_u, 0}, .per_y = {0, per_y_v}};
}

// A texel or less: no filter. The whole texture: its mean, from one tap at the last level.
TEST(SampleFootprint, NoneAndAll) {
    const Texture texture = Of(NoisePicture(16, 16, 3));
    const MipChain chain(texture);
    const Vec2f uv(0.41f, 0.17f);
    EXPECT_EQ(SampleFootprint(chain, uv, {}, 16), SampleAlbedo(texture, uv));
    EXPECT_EQ(SampleFootprint(chain, uv, Along(1 / 16.0, 1 / 20.0), 16),
              SampleAlbedo(texture, uv));
    EXPECT_EQ(SampleFootprint(chain, uv, Along(std::nan(""), 0.1), 16),
              SampleAlbedo(texture, uv));
    for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(SampleFootprint(chain, uv, Along(1, 1), 16)[c], Mean(texture.albedo)[c],
                    1e-6);
    }
}

// Stripes of 4 texels along u, constant along v. A footprint that is long along v and a texel wide
// keeps them; an isotropic filter of the same length does not; one that is long along u does not.
TEST(SampleFootprint, KeepsStripesAlongTheLongerAxis) {
    Image<Rgb> stripes(64, 64);
    for (int y = 0; y < 64; ++y) {
        for (int x = 0; x < 64; ++x) stripes(x, y) = {x / 4 % 2 ? 1.f : 0.f, 0, 0};
    }
    const MipChain chain(Of(stripes));
    const Vec2f in_white(6 / 64.f, 0.5f);  // The middle of texels 4 to 7.
    EXPECT_EQ(SampleFootprint(chain, in_white, Along(1 / 64.0, 16 / 64.0), 16)[0], 1);
    EXPECT_LT(SampleFootprint(chain, in_white, Along(1 / 64.0, 16 / 64.0), 1)[0], 0.7);
    EXPECT_NEAR(SampleFootprint(chain, in_white, Along(16 / 64.0, 1 / 64.0), 16)[0], 0.5, 0.1);
}

// A wave sin(2 pi u), whose mean over a length l of u is sinc(l) times it, sinc = sin(pi l)/(pi l).
// N taps at i / (N + 1) - 1/2 lie within N - 1 of N + 1 parts of l only, so they see less of it: as
// published; their mean is known too: (1/N) Sum cos(2 pi l (i/(N+1) - 1/2)). The level's own filter
// is a texel of l / N, hardly a smoothing here. Tolerance: bilinear texels of 1/256: pi^2/2 / 256^2.
TEST(SampleFootprint, IsTheMeanOfItsTaps) {
    Image<Rgb> wave(256, 4);
    for (int y = 0; y < 4; ++y) {
        for (int x = 0; x < 256; ++x) {
            const double u = (x + 0.5) / 256;
            wave(x, y) = {float(0.5 + 0.5 * std::sin(2 * std::numbers::pi * u)), 0, 0};
        }
    }
    const MipChain chain(Of(wave));
    const double l = 8.0 / 256;
    double taps = 0;
    for (int i = 1; i <= 8; ++i)
        taps += std::cos(2 * std::numbers::pi * l * (i / 9.0 - 0.5)) / 8;
    const double expected = 0.5 + 0.5 * std::sin(2 * std::numbers::pi * 0.2) * taps;
    EXPECT_NEAR(SampleFootprint(chain, {0.2f, 0.5f}, Along(l, 1 / 1024.0), 8)[0], expected,
                8e-5);
}

TEST(SampleSpacing, IsTheEdgeOfASamplesShareOfThePixel) {
    EXPECT_EQ(SampleSpacing(4, 1), 4);
    EXPECT_EQ(SampleSpacing(4, 16), 1);
    EXPECT_EQ(SampleSpacing(4, 4), 2);
}

/// Two boards beside each other, facing the viewer: u, v in metres on the left one; far elsewhere
/// in the texture on the right one, whose material is another.
Scene TwoBoards() {
    Scene scene;
    scene.mesh.vertices_m = {{-2, -2, 0},   {0.1f, -2, 0}, {0.1f, 2, 0}, {-2, 2, 0},
                             {0.1f, -2, 0}, {2, -2, 0},    {2, 2, 0},    {0.1f, 2, 0}};
    scene.mesh.uvs = {{-2, -2},  {0.1f, -2}, {0.1f, 2}, {-2, 2},
                      {7.1f, 5}, {9, 5},     {9, 9},    {7.1f, 9}};
    scene.mesh.quads = {{0, 1, 2, 3}, {4, 5, 6, 7}};
    scene.material_of_face = {0, 1};
    scene.textures = {Of(NoisePicture(8, 8, 4))};
    scene.materials = {{.name = "left", .albedo = {1, 1, 1}, .texture = 0},
                       {.name = "right", .albedo = {1, 1, 1}, .texture = 0}};
    return scene;
}

Camera FromAbove(int n) {
    return {.position_m = {0, 0, 1},
            .target_m = {0, 0, 0},
            .up = {0, 1, 0},
            .fov_rad = std::numbers::pi / 2,
            .width_px = n,
            .height_px = n};
}

// 2 m over n pixels of 2 x 2 samples: 1/n m a sample; v rises upward. The border at x = 0.1 is at
// sample 1.1 n: of n = 16 at 17.6, between the pairs 16, 17 and 18, 19; of n = 17 at 18.7, within the
// pair 18, 19. The boards are of two materials, or of one with a seam in its coordinates.
TEST(FootprintOf, DifferencesGoWrongAtABorderAndTheTestMendsIt) {
    for (const std::uint16_t right : {std::uint16_t(1), std::uint16_t(0)}) {
        for (const int n : {16, 17}) {
            Scene scene = TwoBoards();
            scene.material_of_face[1] = right;
            const WideGBuffer g = DrawWideGBuffer(scene, FromAbove(n), {.m = 2});
            int wrong = 0;
            for (int Y = 0; Y < 2 * n; ++Y) {
                for (int X = 0; X < 2 * n; ++X) {
                    const Footprint exact = FootprintOf(g, X, Y, FootprintSource::kSurface);
                    EXPECT_NEAR(exact.per_x.x(), 1.0 / n, 1e-5);
                    EXPECT_NEAR(exact.per_y.y(), -1.0 / n, 1e-5);
                    const Footprint pairs = FootprintOf(g, X, Y, FootprintSource::kDifferences);
                    const Footprint tested =
                        FootprintOf(g, X, Y, FootprintSource::kDifferencesTested);
                    wrong += (pairs.per_x - exact.per_x).norm() > 1;
                    EXPECT_LT((tested.per_x - exact.per_x).norm(), 1e-5) << X << " " << Y;
                    EXPECT_LT((tested.per_y - exact.per_y).norm(), 1e-5) << X << " " << Y;
                }
            }
            EXPECT_EQ(wrong, n == 16 ? 0 : 2 * 2 * n);
        }
    }
}

// Where the sky begins there is no neighbour: no filter; and the sky itself has no footprint.
TEST(FootprintOf, TheSkyHasNoneAndIsNoNeighbour) {
    const Scene scene = TwoBoards();
    Camera camera = FromAbove(8);
    camera.position_m = {0, 0, 3};  // +-3 m: sky around the boards.
    const WideGBuffer g = DrawWideGBuffer(scene, camera, {.m = 1});
    EXPECT_EQ(FootprintOf(g, 0, 0, FootprintSource::kDifferencesTested).per_x, Vec2(0, 0));
    for (int Y = 0; Y < 8; ++Y) {
        for (int X = 0; X < 8; ++X) {
            if (g.material(X, Y) == WideGBuffer::kNoMaterial) continue;
            const Footprint tested = FootprintOf(g, X, Y, FootprintSource::kDifferencesTested);
            EXPECT_NEAR(tested.per_x.x(), 6.0 / 8, 1e-5);
            EXPECT_NEAR(tested.per_y.y(), -6.0 / 8, 1e-5);
        }
    }
}

// Far away the texture repeats many times a pixel: with the filter a picture of one sample a pixel
// is near the texture's mean, without it is noise. The filter of a full grid is narrower: each sample
// stands for 1/16 of the pixel.
TEST(DeferredShader, FiltersAsWideAsItsSamplesAreFew) {
    Scene scene = TwoBoards();
    for (Vec2f& uv : scene.mesh.uvs) uv *= 17.3f;
    const int n = 16, m = 4;
    const WideGBuffer g = DrawWideGBuffer(scene, FromAbove(n), {.m = m});
    const auto spread = [&](const Image<Rgb>& picture) {
        double sum = 0;
        for (const Rgb& pixel : picture.Pixels()) {
            sum += std::pow(pixel[1] - Mean(scene.textures[0].albedo)[1], 2);
        }
        return std::sqrt(sum / double(picture.Pixels().size()));
    };
    DeferredOptions filtered;
    filtered.filter = TextureFilter::kAnisotropic;
    const SampleShader plain = DeferredShader(scene, FromAbove(n), g);
    const SampleShader with = DeferredShader(scene, FromAbove(n), g, filtered);
    EXPECT_GT(spread(ShadeFirst(n, n, m, plain)), 0.1);
    EXPECT_LT(spread(ShadeFirst(n, n, m, with)), 0.01);
    std::vector<Rgb> colours(2);
    const std::vector<SampleToShade> samples{{9, 9, 1}, {9, 9, 16}};
    with(samples, colours);
    EXPECT_NE(colours[0], colours[1]);
    filtered.most_taps = 0;
    EXPECT_THROW(DeferredShader(scene, FromAbove(n), g, filtered), Error);
}

}  // namespace
}  // namespace plumb
