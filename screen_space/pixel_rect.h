// A rectangle of pixels of the drawn picture, half open: [x0, x1) x [y0, y1).
#pragma once

#include <algorithm>
#include <functional>

#include "screen_space/view.h"

namespace plumb {

struct PixelRect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int Width() const { return x1 - x0; }
    int Height() const { return y1 - y0; }
    bool Contains(int x, int y) const { return x0 <= x && x < x1 && y0 <= y && y < y1; }
    friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

inline PixelRect Drawn(const View& view) {
    return {0, 0, view.DrawnWidth(), view.DrawnHeight()};
}

/// What is shown and `margin_px` more on each side, where that was drawn, out to whole quads.
inline PixelRect ShownAndMargin(const View& view, int margin_px) {
    const int low = std::max(0, view.guard_px - margin_px) / 2 * 2;
    const int more = view.guard_px + margin_px;
    return {low, low, std::min(view.DrawnWidth(), (view.width_px + more + 1) / 2 * 2),
            std::min(view.DrawnHeight(), (view.height_px + more + 1) / 2 * 2)};
}

/// `each(tile)` for the tiles of `where`, on all cores. They are small enough to stay in the cache,
/// and start at even pixels from its corner.
void ForEachTile(const PixelRect& where, const std::function<void(const PixelRect&)>& each);

}  // namespace plumb
