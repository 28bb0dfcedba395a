// Light with albedos that vary, pictures of skies and lights, against closed forms.
#include "truth/irradiance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/conventions.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/shading.h"
#include "rays/embree/embree_caster.h"
#include "tests/truth/shapes.h"
#include "tests/truth/significance.h"
#include "truth/escape_walk.h"

namespace plumb {
namespace {

constexpr int kNets = 16;

Scene OfMesh(const Mesh& mesh, const Rgb& albedo) {
    Scene scene;
    scene.mesh = mesh;
    scene.material_of_face.assign(mesh.quads.size(), 0);
    scene.materials = {{.name = "all", .albedo = albedo}};
    return scene;
}

IrradianceSums Measure(const Scene& scene, std::span<const Receiver> receivers,
                       std::int64_t points, int roulette_from = 16) {
    Validate(scene);
    const EmbreeCaster caster(scene);
    return MeasureIrradiance(
        caster, scene, receivers,
        {.sampling = {.replicates = kNets, .points = points}, .roulette_from = roulette_from});
}

void ExpectMeasured(const Measured& measured, double exact, double slack,
                    const std::string& what) {
    EXPECT_NEAR(measured.value, exact, slack + Sigmas(kNets) * measured.standard_error) << what;
    EXPECT_LT(measured.standard_error, 4e-3 * exact + 1e-6) << what << ": too unsure to fail";
}

// A hemispherical bowl of radius 1 in level ground; (u, v) go `waves` times around and down.
Mesh Bowl(double waves) {
    Mesh mesh;
    constexpr int kRound = 256, kRings = 64;
    AddSheet(mesh, Steps(0, 2 * kPi, kRound), Steps(0, kPi / 2, kRings),
             [](double phi, double theta) {
                 return Vec3(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                             -std::cos(theta));
             });
    for (int j = 0; j <= kRings; ++j) {
        for (int i = 0; i <= kRound; ++i) {
            mesh.uvs.push_back({float(waves * i / kRound), float(j) / kRings});
        }
    }
    TurnInsideOut(mesh);
    return mesh;
}

// Expected: form factors on a sphere are constant, so what surfaces send reaches every point of
// the bowl alike: J = (1 - a) mean(rho E) with a = 1/2 of the hemisphere, E = a + J. The mean of
// the texture is the same over every ring, so E = a / (1 - (1 - a) mean(rho)), each colour by
// itself. Slack: as in tests/truth/closed_forms_test.cpp, d^2 / 4 with d = 2 pi / 256.
TEST(Irradiance, OfATexturedBowlFollowsItsMeanAlbedo) {
    Scene scene = OfMesh(Bowl(8), {1, 0.5f, 0.25f});
    Texture texture{.name = "", .albedo = Image<Rgb>(2, 1), .opacity = {}};
    texture.albedo(0, 0) = {0.2f, 0.2f, 1};
    texture.albedo(1, 0) = {1, 1, 0.2f};
    scene.textures = {texture};
    scene.materials[0].texture = 0;
    const double slack = std::pow(2 * kPi / 256, 2) / 4;
    for (const int roulette_from : {1, 16}) {
        const std::uint32_t face = 32 * 256 + 37;
        const std::vector<Receiver> receivers{{.triangle = 2 * face},
                                              {.triangle = 2 * face + 1}};
        const IrradianceSums sums = Measure(scene, receivers, 1024, roulette_from);
        EXPECT_EQ(sums.lost.All(), 0);
        EXPECT_EQ(sums.cut, 0);
        for (std::size_t c = 0; c < 3; ++c) {
            const double mean_rho = 0.6 * std::array{1.0, 0.5, 0.25}[c];
            const Measured one = sums.sums.Of(0, c), two = sums.sums.Of(1, c);
            const Measured both{
                .value = (one.value + two.value) / 2,
                .standard_error = std::hypot(one.standard_error, two.standard_error) / 2,
                .interval = {}};
            ExpectMeasured(
                both, 0.5 / (1 - 0.5 * mean_rho), slack,
                "colour " + std::to_string(c) + " roulette " + std::to_string(roulette_from));
        }
    }
}

// Law: at one albedo under a white sky these are the walks that truth/escape_walk.h counts, net
// by net: Sum_k rho^k (walks that escape at bounce k). Tolerance: rounding of float albedos
// (2^-24 a bounce) and of sums of 64; walks beyond bounce 200 carry 0.5^200.
TEST(Irradiance, IsTheEscapeHistogramWhereAlbedoIsOne) {
    Mesh mesh;
    for (int i = 0; i < 60; ++i) {
        const auto random = [&](std::uint64_t k) -> Vec3 {
            return {RandomUnit(5, std::uint64_t(i), k, 0),
                    RandomUnit(5, std::uint64_t(i), k, 1),
                    RandomUnit(5, std::uint64_t(i), k, 2)};
        };
        AddTriangle(mesh, random(0), random(1), random(2));
    }
    const Scene scene = OfMesh(mesh, {0.5f, 0.25f, 0});
    const EmbreeCaster caster(scene);
    const std::vector<Receiver> receivers{{.triangle = 4}, {.triangle = 20, .back = true}};
    const NetSampling sampling{.replicates = 4, .points = 64};
    const IrradianceSums sums = MeasureIrradiance(
        caster, scene, receivers, {.sampling = sampling, .roulette_from = 10000});
    const EscapeCounts walks =
        WalkToTheSky(caster, scene.mesh, receivers, {.sampling = sampling, .bounces = 200});
    std::int64_t bounced = 0;
    for (std::int64_t i = 0; i < 2; ++i) {
        for (int r = 0; r < 4; ++r) {
            std::array<double, 3> expected{};
            for (int k = 0; k <= 200; ++k) {
                const double escaped = walks.Row(i, r)[std::size_t(k)];
                expected[0] += std::pow(0.5, k) * escaped;
                expected[1] += std::pow(0.25, k) * escaped;
                expected[2] += k == 0 ? escaped : 0;
                bounced += k > 1 ? std::int64_t(escaped) : 0;
            }
            for (std::size_t c = 0; c < 3; ++c) {
                EXPECT_NEAR(sums.sums.sum[std::size_t(4 * i + r)][c], expected[c], 1e-9);
            }
        }
    }
    EXPECT_GT(bounced, 100);
}

// Definition: at albedo 1 under a sky of 1 every walk brings back exactly 1, roulette or not.
TEST(Irradiance, FurnaceIsOne) {
    const Scene scene = OfMesh(Bowl(1), {1, 1, 1});
    const Receiver receiver{.triangle = 2 * (20 * 256 + 3)};
    for (const int roulette_from : {1, 100}) {
        const IrradianceSums sums = Measure(scene, {&receiver, 1}, 256, roulette_from);
        EXPECT_EQ(sums.sums.Of(0, 0).value, 1);
        EXPECT_EQ(sums.cut, 0);
    }
}

// Expected: [pbrt's scene] a closed sphere of radius 1 and albedo rho with a point light at its
// centre whose irradiance at 1 m is 1: E = 1 / (1 - rho) everywhere. Slack: facets lie up to
// 1 - cos(pi / 128)^2 = 6e-4 inside, which is 1.2e-3 of 1 / d^2, and are tilted by less.
TEST(Irradiance, OfALampInAClosedSphere) {
    Mesh mesh;
    AddSphere(mesh, {0, 0, 0}, 1, 64);
    TurnInsideOut(mesh);
    Scene scene = OfMesh(mesh, {0.5f, 0.8f, 0});
    scene.light.sky = {0, 0, 0};
    scene.light.points = {{.position_m = {0, 0, 0}, .intensity = {1, 1, 3}}};
    const std::vector<Receiver> receivers{{.triangle = 2 * (30 * 128 + 5)},
                                          {.triangle = 2 * (50 * 128 + 90), .spread = false}};
    const IrradianceSums sums = Measure(scene, receivers, 256);
    for (std::int64_t i = 0; i < 2; ++i) {
        ExpectMeasured(sums.sums.Of(i, 0), 2, 1.2e-3 * 2, "rho .5");
        ExpectMeasured(sums.sums.Of(i, 1), 5, 1.2e-3 * 5, "rho .8");
        ExpectMeasured(sums.sums.Of(i, 2), 3, 1.2e-3 * 3, "rho 0");
    }
}

// By hand: of the light (0, 0.6, 0.8) level ground gets 0.8 of its irradiance; a wall at y = 1,
// 1 high, puts y > 1 - 0.6 / 0.8 = 1/4 into shadow. No sky, black surfaces.
TEST(Irradiance, LightsHaveShadows) {
    Mesh mesh;
    AddSheet(mesh, Steps(-1, 1, 1), Steps(-1, 1, 8),
             [](double x, double y) { return Vec3(x, y, 0); });
    AddQuad(mesh, {-9, 1, 0}, {9, 1, 0}, {9, 1, 1}, {-9, 1, 1});
    Scene scene = OfMesh(mesh, {0, 0, 0});
    scene.light.sky = {0, 0, 0};
    scene.light.directional = {{.towards = {0, 1.2, 1.6}, .irradiance = {1, 2, 3}}};
    std::vector<Receiver> receivers;
    for (std::uint32_t face = 0; face < 8; ++face) receivers.push_back({.triangle = 2 * face});
    const IrradianceSums sums = Measure(scene, receivers, 16);
    for (std::int64_t face = 0; face < 8; ++face) {
        const bool lit = face < 5;  // y up to 1/4.
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(sums.sums.Of(face, c).value, lit ? 0.8 * double(c + 1) : 0, 1e-6)
                << face;
        }
    }
}

// A sky of radiance 1 + c . w as a picture.
Environment Gradient(const Vec3& c, double turn_rad) {
    Environment sky;
    sky.radiance = Image<Rgb>(256, 128);
    for (int j = 0; j < 128; ++j) {
        for (int i = 0; i < 256; ++i) {
            const double theta = kPi * (j + 0.5) / 128, phi = 2 * kPi * ((i + 0.5) / 256 - 0.5);
            const Vec3 w(std::sin(theta) * std::sin(phi), std::sin(theta) * std::cos(phi),
                         std::cos(theta));
            const float L = float(1 + c.dot(w));
            sky.radiance(i, j) = {L, 2 * L, 0};
        }
    }
    sky.turn_rad = turn_rad;
    return sky;
}

// Expected: 1/pi Int (1 + c . w) <n, w> dw = 1 + 2/3 c . n over an open hemisphere, and a mean
// radiance of 1. Slack: between texels the bilinear sky is off by (pi / 128)^2 / 8 of |c| < 1.
TEST(Irradiance, OfASkyThatIsAPicture) {
    const double slack = std::pow(kPi / 128, 2) / 8;
    const Vec3 c(0.5, 0, 0.25), turned(0, 0.5, 0.25);
    for (const Vec3& tilt : {Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(-1, 2, 0.5)}) {
        const Basis frame(tilt.normalized());
        Mesh mesh;
        AddQuad(mesh, frame.ToWorld({-1, -1, 0}), frame.ToWorld({1, -1, 0}),
                frame.ToWorld({1, 1, 0}), frame.ToWorld({-1, 1, 0}));
        Scene scene = OfMesh(mesh, {0, 0, 0});
        const Receiver receiver{.triangle = 0};
        for (const bool turn : {false, true}) {
            scene.light.environment =
                turn ? Gradient(turned, kPi / 2) : Gradient(c, 0);  // +y is turned to +x.
            scene.light.sky = {1, 1, 1};
            const IrradianceSums sums = Measure(scene, {&receiver, 1}, 1024);
            const double exact = 1 + 2.0 / 3 * c.dot(frame.n);
            ExpectMeasured(sums.sums.Of(0, 0), exact, slack, turn ? "turned" : "as it is");
            ExpectMeasured(sums.sums.Of(0, 1), 2 * exact, 2 * slack, "green");
            EXPECT_EQ(sums.sums.Of(0, 2).value, 0);
            EXPECT_NEAR(MeanRadiance(scene.light.environment)[0], 1, slack);
        }
    }
}

// Expected: the mean of w_z^2 over all directions is 1/3. Slack: the texels' second order.
TEST(Environment, MeanCountsTexelsByTheirSolidAngle) {
    Environment sky;
    sky.radiance = Image<Rgb>(4, 128);
    for (int j = 0; j < 128; ++j) {
        const float z = float(std::cos(kPi * (j + 0.5) / 128));
        for (int i = 0; i < 4; ++i) sky.radiance(i, j) = {z * z, 1, 0};
    }
    EXPECT_NEAR(MeanRadiance(sky)[0], 1.0 / 3, std::pow(kPi / 128, 2));
    EXPECT_NEAR(MeanRadiance(sky)[1], 1, 1e-6);
    EXPECT_EQ(MeanRadiance({})[2], 1);
    EXPECT_EQ(RadianceFrom({}, {0, 0, -1}), (Rgb{1, 1, 1}));
}

TEST(Irradiance, SameBitsOnOneAndTwoThreads) {
    Scene scene = OfMesh(Bowl(1), {0.5f, 0.7f, 0.9f});
    scene.light.points = {{.position_m = {0, 0, 1}, .intensity = {1, 1, 1}}};
    std::vector<Receiver> receivers;
    for (std::uint32_t i = 0; i < 64; ++i) receivers.push_back({.triangle = 512 + 20 * i});
    SetThreadCount(1);
    const IrradianceSums one = Measure(scene, receivers, 32);
    SetThreadCount(2);
    const IrradianceSums two = Measure(scene, receivers, 32);
    SetThreadCount(0);
    EXPECT_EQ(one.sums.sum, two.sums.sum);
}

TEST(Irradiance, RefusesOptionsOutOfRange) {
    EXPECT_THROW(Validate(IrradianceOptions{.sampling = {}, .roulette_from = 0}), Error);
    EXPECT_THROW(
        Validate(IrradianceOptions{.sampling = {}, .roulette_from = 1, .max_bounces = 10001}),
        Error);
    EXPECT_THROW(Validate(IrradianceOptions{.sampling = {.replicates = 1}}), Error);
}

}  // namespace
}  // namespace plumb
