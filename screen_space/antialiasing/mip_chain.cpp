#include "screen_space/antialiasing/mip_chain.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace plumb {
namespace {

// The texels of `from` that texel i of `to` covers, and how much of each.
struct Covered {
    int first, last;
    double begin, end;  // In texels.

    Covered(int i, int to, int from)
        : begin(double(i) * from / to), end(double(i + 1) * from / to) {
        first = int(begin);
        last = std::min(from, int(std::ceil(end))) - 1;
    }

    double Share(int texel) const {
        return std::min(end, texel + 1.0) - std::max(begin, double(texel));
    }
};

Image<Rgb> Halved(const Image<Rgb>& from) {
    Image<Rgb> to(std::max(1, from.Width() / 2), std::max(1, from.Height() / 2));
    for (int j = 0; j < to.Height(); ++j) {
        const Covered rows(j, to.Height(), from.Height());
        for (int i = 0; i < to.Width(); ++i) {
            const Covered columns(i, to.Width(), from.Width());
            std::array<double, 3> sum{};
            double area = 0;
            for (int y = rows.first; y <= rows.last; ++y) {
                for (int x = columns.first; x <= columns.last; ++x) {
                    const double share = rows.Share(y) * columns.Share(x);
                    area += share;
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += share * from(x, y)[c];
                }
            }
            for (std::size_t c = 0; c < 3; ++c) to(i, j)[c] = float(sum[c] / area);
        }
    }
    return to;
}

}  // namespace

MipChain::MipChain(const Texture& texture) {
    levels_.push_back({.name = texture.name, .albedo = texture.albedo, .opacity = {}});
    while (levels_.back().albedo.Width() > 1 || levels_.back().albedo.Height() > 1) {
        levels_.push_back(
            {.name = texture.name, .albedo = Halved(levels_.back().albedo), .opacity = {}});
    }
}

Rgb MipChain::Trilinear(const Vec2f& uv, double level) const {
    // Written so that NaN ends at level 0.
    const double l = level > 0 ? std::min(level, double(Levels() - 1)) : 0;
    const std::size_t low = std::size_t(l);
    const Rgb a = SampleAlbedo(levels_[low], uv);
    const float share = float(l - double(low));
    if (share == 0) return a;
    const Rgb b = SampleAlbedo(levels_[low + 1], uv);
    Rgb out;
    for (std::size_t c = 0; c < 3; ++c) out[c] = a[c] + (b[c] - a[c]) * share;
    return out;
}

}  // namespace plumb
