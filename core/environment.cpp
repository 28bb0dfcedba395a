#include "core/environment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/conventions.h"

namespace plumb {

Rgb RadianceFrom(const Environment& environment, const Vec3& w) {
    const Image<Rgb>& image = environment.radiance;
    if (image.Empty()) return {1, 1, 1};
    const int W = image.Width(), H = image.Height();
    const double x_s = 0.5 + (std::atan2(w.x(), w.y()) - environment.turn_rad) / (2 * kPi);
    const double y_s = std::atan2(std::hypot(w.x(), w.y()), w.z()) / kPi;
    const double x = (x_s - std::floor(x_s)) * W - 0.5, y = y_s * H - 0.5;
    const int left = int(std::floor(x)), above = int(std::floor(y));
    const double right_share = x - left, below_share = y - above;
    Rgb out{};
    for (const int j : {0, 1}) {
        for (const int i : {0, 1}) {
            const Rgb& texel = image((left + i + W) % W, std::clamp(above + j, 0, H - 1));
            const double share = (i == 1 ? right_share : 1 - right_share) *
                                 (j == 1 ? below_share : 1 - below_share);
            for (std::size_t c = 0; c < 3; ++c) out[c] += float(share * texel[c]);
        }
    }
    return out;
}

Rgb MeanRadiance(const Environment& environment) {
    const Image<Rgb>& image = environment.radiance;
    if (image.Empty()) return {1, 1, 1};
    const int W = image.Width(), H = image.Height();
    std::array<double, 3> sum{};
    for (int j = 0; j < H; ++j) {
        const double share = (std::cos(kPi * j / H) - std::cos(kPi * (j + 1) / H)) / 2 / W;
        for (int i = 0; i < W; ++i) {
            for (std::size_t c = 0; c < 3; ++c) sum[c] += share * image(i, j)[c];
        }
    }
    return {float(sum[0]), float(sum[1]), float(sum[2])};
}

}  // namespace plumb
