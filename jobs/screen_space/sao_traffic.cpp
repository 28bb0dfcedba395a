#include "jobs/screen_space/sao_traffic.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <numeric>

#include "core/parallel.h"

namespace plumb {
namespace {

constexpr double kFloatBytes = 4, kNormalBytes = 12;

double Pixels(const PixelRect& rect) {
    return double(rect.Width()) * rect.Height();
}

PassBytes PyramidBytes(const ZPyramid& pyramid, ZFilter filter) {
    const bool one_source =
        filter == ZFilter::kRotatedGrid || filter == ZFilter::kRotatedGridG3d10;
    PassBytes bytes{.name = "z pyramid"};
    for (int level = 0; level <= pyramid.Coarsest(); ++level) {
        const auto texels = [&](int at) {
            return kFloatBytes * pyramid.At(at).width * pyramid.At(at).height;
        };
        bytes.written += texels(level);
        // Level 0 is a copy. A mean reads all of the level below, the rotated grid a quarter.
        bytes.read += level == 0 || one_source ? texels(level) : texels(level - 1);
    }
    return bytes;
}

// One flag a texel of the pyramid.
class Touched {
  public:
    explicit Touched(const ZPyramid& pyramid) : pyramid_(pyramid) {
        for (int level = 0; level <= pyramid.Coarsest(); ++level) {
            first_.push_back(size_);
            size_ += std::size_t(pyramid.At(level).width) * pyramid.At(level).height;
        }
        flags_ = std::make_unique<std::atomic<bool>[]>(size_);
    }

    void Mark(int level, int i, int j) {
        flags_[first_[std::size_t(level)] + std::size_t(j) * pyramid_.At(level).width +
               std::size_t(i)]
            .store(true, std::memory_order_relaxed);
    }

    double Count() const {
        std::size_t count = 0;
        for (std::size_t k = 0; k < size_; ++k) {
            count += flags_[k].load(std::memory_order_relaxed);
        }
        return double(count);
    }

  private:
    const ZPyramid& pyramid_;
    std::vector<std::size_t> first_;
    std::size_t size_ = 0;
    std::unique_ptr<std::atomic<bool>[]> flags_;
};

// The neighbours of which depth_normal.h makes a normal: the quad's, or across from it at the sky.
void MarkNormal(const GBuffer& gbuffer, int x, int y, Touched& touched) {
    const auto mark = [&](int across, int down) {
        const int i = x + across, j = y + down;
        if (i < 0 || j < 0 || i >= gbuffer.z_m.Width() || j >= gbuffer.z_m.Height()) {
            return false;
        }
        touched.Mark(0, i, j);
        return std::isfinite(gbuffer.z_m(i, j));
    };
    const int dx = x % 2 == 0 ? 1 : -1, dy = y % 2 == 0 ? 1 : -1;
    if (!mark(dx, 0)) mark(-dx, 0);
    if (!mark(0, dy)) mark(0, -dy);
}

PassBytes SampleBytes(const GBuffer& gbuffer, const ZPyramid& pyramid,
                      const SaoOptions& options) {
    const PixelRect where = ComputedRect(gbuffer.view, options);
    const TapOptions& taps = options.sampling.taps;
    std::vector<UnitTap> unit;
    for (int i = 0; i < taps.samples; ++i) unit.push_back(TapOf(taps, i));
    Touched touched(pyramid);
    ForEachTile(where, [&](const PixelRect& tile) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                touched.Mark(0, x, y);
                const double z = gbuffer.z_m(x, y);
                if (!std::isfinite(z)) continue;
                if (options.sampling.normals == NormalSource::kDepth) {
                    MarkNormal(gbuffer, x, y, touched);
                }
                const double disc_px =
                    DiscRadiusPx(gbuffer.view, options.sampling.sao.radius_m, z);
                if (taps.min_radius_px > 0 && disc_px <= taps.min_radius_px) continue;
                const std::int64_t hash =
                    RotationHash(x + taps.hash_shift_px, y + taps.hash_shift_px, taps.hash);
                for (const UnitTap& tap : unit) {
                    const double theta = TurnedAngle(tap.angle_rad, hash, taps.phi);
                    const TapTexel texel = LookUpTap(
                        taps, pyramid, x, y, std::max(tap.alpha * disc_px, taps.min_tap_px),
                        {std::cos(theta), std::sin(theta)});
                    touched.Mark(texel.level, texel.i, texel.j);
                }
            }
        }
    });
    PassBytes bytes{.name = "sample",
                    .read = kFloatBytes * touched.Count(),
                    .written = kFloatBytes * Pixels(where)};
    if (options.sampling.normals != NormalSource::kDepth) {
        bytes.read += kNormalBytes * Pixels(where);
    }
    return bytes;
}

PassBytes BlurBytes(BlurAxis axis, const View& view, const SaoOptions& options) {
    const PixelRect where = ComputedRect(view, options);
    const int reach_px = options.blur.taps_each_side * options.blur.stride_px;
    PixelRect read = where;
    if (axis == BlurAxis::kX) {
        read.x0 = std::max(0, where.x0 - reach_px);
        read.x1 = std::min(view.DrawnWidth(), where.x1 + reach_px);
    } else {
        read.y0 = std::max(0, where.y0 - reach_px);
        read.y1 = std::min(view.DrawnHeight(), where.y1 + reach_px);
    }
    PassBytes bytes{.name = axis == BlurAxis::kX ? "blur x" : "blur y",
                    .read = 2 * kFloatBytes * Pixels(read) + kFloatBytes * Pixels(where),
                    .written = kFloatBytes * Pixels(where)};
    if (options.blur.normal_weight || options.blur.plane_weight) {
        bytes.read += kNormalBytes * Pixels(read);
    }
    return bytes;
}

}  // namespace

std::vector<PassBytes> SaoTraffic(const GBuffer& gbuffer, const SaoOptions& options) {
    const ZPyramid pyramid = BuildZPyramid(gbuffer, options);
    const double computed = kFloatBytes * Pixels(ComputedRect(gbuffer.view, options));
    std::vector<PassBytes> traffic{PyramidBytes(pyramid, options.sampling.taps.filter),
                                   SampleBytes(gbuffer, pyramid, options)};
    if (options.quad_filter) traffic.push_back({"quads", 2 * computed, computed});
    if (options.pack_rgb8) {
        traffic.push_back({"pack", 2 * computed, 2 * computed});
    } else {
        traffic.push_back({"key", computed, computed});
    }
    if (options.blur_x) traffic.push_back(BlurBytes(BlurAxis::kX, gbuffer.view, options));
    if (options.blur_y) traffic.push_back(BlurBytes(BlurAxis::kY, gbuffer.view, options));
    return traffic;
}

double TotalBytes(const std::vector<PassBytes>& traffic) {
    return std::accumulate(
        traffic.begin(), traffic.end(), 0.0,
        [](double sum, const PassBytes& pass) { return sum + pass.read + pass.written; });
}

}  // namespace plumb
