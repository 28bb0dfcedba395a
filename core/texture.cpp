#include "core/texture.h"

#include <cmath>

namespace plumb {
namespace {

// The two texels along one axis that surround a place, and the share of the second.
struct Neighbours {
    int first, second;
    float share;
};

// `place` counts in lengths of the picture, from its left or top border.
Neighbours Around(double place, int texels) {
    const double x = (place - std::floor(place)) * texels - 0.5;
    const double low = std::floor(x);
    int first = int(low);                // -1 ... texels - 1; rounding may give `texels`.
    const float share = float(x - low);  // In double: no texel border is misplaced.
    if (first < 0) first += texels;
    if (first >= texels) first -= texels;
    return {first, first + 1 == texels ? 0 : first + 1, share};
}

struct Quad {
    Neighbours x, y;
};

template <class T>
Quad Surrounding(const Image<T>& image, const Vec2f& uv) {
    return {Around(uv.x(), image.Width()), Around(1 - double(uv.y()), image.Height())};
}

float Mix(float a, float b, float share) {
    return a + (b - a) * share;
}

}  // namespace

Rgb SampleAlbedo(const Texture& texture, const Vec2f& uv) {
    const auto [x, y] = Surrounding(texture.albedo, uv);
    const Rgb& a = texture.albedo(x.first, y.first);
    const Rgb& b = texture.albedo(x.second, y.first);
    const Rgb& c = texture.albedo(x.first, y.second);
    const Rgb& d = texture.albedo(x.second, y.second);
    Rgb out;
    for (std::size_t k = 0; k < 3; ++k) {
        out[k] = Mix(Mix(a[k], b[k], x.share), Mix(c[k], d[k], x.share), y.share);
    }
    return out;
}

float SampleOpacity(const Texture& texture, const Vec2f& uv) {
    if (texture.opacity.Empty()) return 1;
    const Image<float>& o = texture.opacity;
    const auto [x, y] = Surrounding(o, uv);
    return Mix(Mix(o(x.first, y.first), o(x.second, y.first), x.share),
               Mix(o(x.first, y.second), o(x.second, y.second), x.share), y.share);
}

}  // namespace plumb
