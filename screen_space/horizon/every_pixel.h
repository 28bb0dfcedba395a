// An image of one number a pixel, tile by tile on all cores.
#pragma once

#include "core/image.h"
#include "screen_space/horizon/slice_march.h"
#include "screen_space/horizon/slice_tile.h"
#include "screen_space/pixel_rect.h"

namespace plumb {

/// of_tile(task, tile, A) for all tiles of `where`; 1 elsewhere.
template <class OfTile>
Image<float> EveryTile(const GBuffer& gbuffer, const SliceSampling& sampling,
                       const PixelRect& where, const OfTile& of_tile) {
    Image<float> A(gbuffer.z_m.Width(), gbuffer.z_m.Height(), 1.0f);
    const SliceTask task(gbuffer, sampling);
    ForEachTile(where, [&](const PixelRect& tile) { of_tile(task, tile, A); });
    return A;
}

/// of_pixel(march, x, y) for every pixel of `where`, one at a time; 1 elsewhere.
template <class OfPixel>
Image<float> EveryPixel(const GBuffer& gbuffer, const SliceSampling& sampling,
                        const PixelRect& where, const OfPixel& of_pixel) {
    Image<float> A(gbuffer.z_m.Width(), gbuffer.z_m.Height(), 1.0f);
    const SliceMarch start(gbuffer, sampling);
    ForEachTile(where, [&](const PixelRect& tile) {
        SliceMarch march = start;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) A(x, y) = float(of_pixel(march, x, y));
        }
    });
    return A;
}

}  // namespace plumb
