#include "jobs/screen_space/layered_obscurance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/camera.h"
#include "core/error.h"
#include "core/parallel.h"
#include "rays/ray_caster.h"
#include "screen_space/sao/rotation_hash.h"

namespace plumb {
namespace {

// Past a layer: a hit is known to a few roundings of its distance.
constexpr double kPastLayer = 1 + 0x1p-20;

class Layers {
  public:
    Layers(const TechniqueInput& in, const SaoOptions& options, int most_layers)
        : in_(in), options_(options), most_layers_(most_layers), frame_(in.camera) {}

    double AtPixel(int x, int y) {
        const GBuffer& gbuffer = in_.gbuffer;
        const View& view = gbuffer.view;
        const SaoParams& sao = options_.sampling.sao;
        const TapOptions& taps = options_.sampling.taps;
        const double z = gbuffer.z_m(x, y);
        const Vec3 C = view.Point(x + 0.5, y + 0.5, z);
        const Vec3 n = gbuffer.face_normal(x, y).cast<double>();
        const double disc_px = DiscRadiusPx(view, sao.radius_m, z);
        const std::int64_t hash =
            RotationHash(x + taps.hash_shift_px, y + taps.hash_shift_px, taps.hash);
        const std::size_t s = std::size_t(taps.samples);
        rays_.assign(s, {});
        hits_.assign(s, {});
        f_.assign(s, 0);
        const Vec3f eye = in_.camera.position_m.cast<float>();
        for (std::size_t i = 0; i < s; ++i) {
            const UnitTap tap = TapOf(taps, int(i));
            const double theta = TurnedAngle(tap.angle_rad, hash, PhiArithmetic::kExact);
            const double x_px = x + 0.5 + tap.alpha * disc_px * std::cos(theta);
            const double y_px = y + 0.5 + tap.alpha * disc_px * std::sin(theta);
            const Vec3 w =
                frame_.Direction(in_.camera, x_px - view.guard_px, y_px - view.guard_px);
            // t counts in depths: only what lies within r of C in depth can matter, and what is
            // nearer than the near plane is in no picture.
            rays_[i] = {.origin_m = eye,
                        .near = float(std::max(gbuffer.range.near_m, -z - sao.radius_m)),
                        .direction = w.cast<float>(),
                        .far = float(-z + sao.radius_m)};
        }
        for (int layer = 0; layer < most_layers_; ++layer) {
            in_.caster.Closest(rays_, hits_);
            bool any = false;
            for (std::size_t i = 0; i < s; ++i) {
                if (!hits_[i].Met()) {
                    rays_[i].far = rays_[i].near;  // Nothing more behind.
                    continue;
                }
                const double t = hits_[i].t;
                const Vec3 world = rays_[i].direction.cast<double>() * t;
                const Vec3 Q(world.dot(frame_.right), world.dot(frame_.up),
                             world.dot(frame_.backward));
                f_[i] = std::max(f_[i], SaoFalloff(Q - C, n, z, sao));
                rays_[i].near = float(t * kPastLayer);
                any = any || rays_[i].near < rays_[i].far;
            }
            if (!any) break;
        }
        double sum = 0;
        for (const double f : f_) sum += f;
        return SaoFromMean(sum / taps.samples, sao);
    }

  private:
    const TechniqueInput& in_;
    const SaoOptions& options_;
    int most_layers_;
    CameraFrame frame_;
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
    std::vector<double> f_;
};

}  // namespace

Image<float> LayeredObscurance(const TechniqueInput& in, const SaoOptions& options,
                               const LayeredOptions& layered, Monitor& monitor) {
    Validate(options);
    if (layered.stride_px < 1 || layered.stride_px > 4096) {
        throw Error(MustBe("LayeredOptions::stride_px", layered.stride_px, "in [1, 4096]"));
    }
    if (layered.most_layers < 1 || layered.most_layers > 4096) {
        throw Error(MustBe("LayeredOptions::most_layers", layered.most_layers, "in [1, 4096]"));
    }
    const View& view = in.gbuffer.view;
    Image<float> A(view.width_px, view.height_px, std::numeric_limits<float>::quiet_NaN());
    const int rows = (view.height_px + layered.stride_px - 1) / layered.stride_px;
    ParallelFor(
        rows, 1,
        [&](std::int64_t begin, std::int64_t end) {
            Layers layers(in, options, layered.most_layers);
            for (int row = int(begin); row < int(end); ++row) {
                const int j = row * layered.stride_px;
                for (int i = 0; i < view.width_px; i += layered.stride_px) {
                    const int x = i + view.guard_px, y = j + view.guard_px;
                    A(i, j) = in.gbuffer.triangle(x, y) == GBuffer::kSky
                                  ? 1
                                  : float(layers.AtPixel(x, y));
                }
            }
        },
        monitor, "all layers");
    return A;
}

}  // namespace plumb
