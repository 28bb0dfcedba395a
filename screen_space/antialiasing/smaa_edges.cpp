#include "screen_space/antialiasing/smaa_edges.h"

#include <cmath>

#include "core/parallel.h"
#include "screen_space/antialiasing/luma.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 8;

float Difference(float a, float b) {
    return std::abs(a - b);
}

float Difference(const Rgb& a, const Rgb& b) {
    return std::max(std::max(Difference(a[0], b[0]), Difference(a[1], b[1])),
                    Difference(a[2], b[2]));
}

/// The edges of one row of pixels of type T: luma or colours.
template <class T>
void FindInRow(const Image<T>& L, const SmaaOptions& options, int y,
               Image<std::uint8_t>& bits) {
    const float t = float(options.threshold), c = float(options.local_contrast_factor);
    const bool far_from_centre = options.edges == SmaaEdgeKind::kColourAsPublished;
    const int W = L.Width(), H = L.Height();
    const int above = std::max(y - 1, 0), above2 = std::max(y - 2, 0),
              below = std::min(y + 1, H - 1);
    for (int x = 0; x < W; ++x) {
        const int left = std::max(x - 1, 0);
        const float delta_left = Difference(L(x, y), L(left, y));
        const float delta_top = Difference(L(x, y), L(x, above));
        if (!(delta_left >= t) && !(delta_top >= t)) continue;
        const int left2 = std::max(x - 2, 0), right = std::min(x + 1, W - 1);
        float m = std::max(delta_left, delta_top);
        m = std::max(m, Difference(L(x, y), L(right, y)));
        m = std::max(m, Difference(L(x, y), L(x, below)));
        m = std::max(m, Difference(far_from_centre ? L(x, y) : L(left, y), L(left2, y)));
        m = std::max(m, Difference(far_from_centre ? L(x, y) : L(x, above), L(x, above2)));
        if (delta_left >= t && c * delta_left >= m && x > 0) bits(x, y) |= SmaaEdges::kLeft;
        if (delta_top >= t && c * delta_top >= m && y > 0) bits(x, y) |= SmaaEdges::kTop;
    }
}

template <class T>
Image<std::uint8_t> Find(const Image<T>& L, const SmaaOptions& options) {
    Image<std::uint8_t> bits(L.Width(), L.Height(), 0);
    ParallelFor(L.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end); ++y) FindInRow(L, options, y, bits);
    });
    return bits;
}

Image<float> LumaOf(const Image<Rgb>& picture) {
    Image<float> luma(picture.Width(), picture.Height());
    ParallelFor(picture.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            for (int x = 0; x < picture.Width(); ++x) {
                luma(x, y) = Luma(LumaWeights::kRec709, picture(x, y));
            }
        }
    });
    return luma;
}

}  // namespace

SmaaEdges FindSmaaEdges(const Image<Rgb>& encoded, const SmaaOptions& options) {
    return SmaaEdges(options.edges == SmaaEdgeKind::kLuma ? Find(LumaOf(encoded), options)
                                                          : Find(encoded, options));
}

}  // namespace plumb
