// Rows of pixels against single windows.
#include "screen_space/antialiasing/metric_rows.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/random.h"
#include "screen_space/antialiasing/windows.h"
#include "screen_space/gbuffer.h"

namespace plumb {
namespace {

/// Depths and normals of all kinds, sky among them; some windows flat, some all sky.
struct MadeSamples {
    Image<float> z;
    Image<Vec3f> normals;

    MadeSamples(int W, int H, int m) : z(W * m, H * m), normals(W * m, H * m, Vec3f(0, 0, 0)) {
        for (int Y = 0; Y < H * m; ++Y) {
            for (int X = 0; X < W * m; ++X) {
                const auto unit = [&](std::uint64_t k) {
                    return RandomUnit(6, std::uint64_t(Y * W * m + X), k, 0);
                };
                const std::uint64_t kind = std::uint64_t(X / m + 3 * (Y / m)) % 5;
                const bool sky = kind == 0 || (kind == 1 && unit(0) < 0.3);
                z(X, Y) =
                    sky ? GBuffer::kSkyZ : float(-0.05 - (kind == 2 ? 3 : 1500 * unit(1)));
                const Vec3 n(unit(2) - 0.5, unit(3) - 0.5, unit(4) - 0.5);
                if (!sky)
                    normals(X, Y) =
                        kind == 3 ? Vec3f(0, 1, 0) : Vec3f(n.normalized().cast<float>());
            }
        }
        z(W * m - 1, 0) = std::nanf("");
    }
};

// Rows of pixels are computed many at once. Expected: the same bits as one window at a time, for
// every width that leaves lanes over.
TEST(MetricRows, AreThoseOfOneWindowAtATimeToTheBit) {
    for (const int m : {1, 2, 3, 4, 5, 8}) {
        for (const int W : {1, 2, 5, 8, 19}) {
            const MadeSamples made(W, 4, m);
            const std::size_t n = std::size_t(m) * m;
            for (const DepthEncoding encoding :
                 {DepthEncoding::kMetres, DepthEncoding::kLinear, DepthEncoding::kDevice}) {
                DepthMetric metric{.c = 3.7, .encoding = encoding};
                metric.bits = encoding == DepthEncoding::kLinear ? 16 : 0;
                const Image<float> k_d = DepthSamples(made.z, m, metric);
                for (int at = 0; at < 4 * W; ++at) {
                    std::array<float, kMaxSamples> d;
                    ReadWindow(made.z, m, at % W, at / W, d);
                    for (float& of : d) of = EncodedDepth(metric, of);
                    const double v = WindowVariance(MetricForm::kStable, {d.data(), n});
                    EXPECT_EQ(k_d.Pixels()[std::size_t(at)], float(3.7 * v)) << m << " " << W;
                }
            }
            for (const MeanNormal mean : {MeanNormal::kRaw, MeanNormal::kUnit}) {
                const Image<float> k_n =
                    NormalSamples(made.normals, m, {.c = 3.7, .mean = mean});
                for (int at = 0; at < 4 * W; ++at) {
                    std::array<Vec3f, kMaxSamples> of;
                    ReadWindow(made.normals, m, at % W, at / W, of);
                    const double spread =
                        NormalSpread({of.data(), n}, mean, MetricForm::kStable);
                    EXPECT_EQ(k_n.Pixels()[std::size_t(at)], float(3.7 * spread))
                        << m << " " << W;
                }
            }
        }
    }
}

}  // namespace
}  // namespace plumb
