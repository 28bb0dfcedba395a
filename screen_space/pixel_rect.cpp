#include "screen_space/pixel_rect.h"

#include "core/parallel.h"

namespace plumb {

void ForEachTile(const PixelRect& where, const std::function<void(const PixelRect&)>& each) {
    const int wide = 128, high = 32;
    const std::int64_t columns = (where.Width() + wide - 1) / wide;
    const std::int64_t rows = (where.Height() + high - 1) / high;
    ParallelFor(columns * rows, 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t tile = begin; tile < end; ++tile) {
            const int x = where.x0 + int(tile % columns) * wide;
            const int y = where.y0 + int(tile / columns) * high;
            each({x, y, std::min(x + wide, where.x1), std::min(y + high, where.y1)});
        }
    });
}

}  // namespace plumb
