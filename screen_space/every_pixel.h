// An image of one number a pixel, each from its slices; rows in chunks on all cores.
#pragma once

#include <cstdint>

#include "core/image.h"
#include "core/parallel.h"
#include "screen_space/slice_march.h"

namespace plumb {

/// `of_pixel(march, x, y)` for every pixel of the drawn picture; a march for each chunk of
/// rows.
template <class OfPixel>
Image<float> EveryPixel(const GBuffer& gbuffer, const SliceSampling& sampling,
                        const OfPixel& of_pixel) {
    Image<float> A(gbuffer.z_m.Width(), gbuffer.z_m.Height());
    const SliceMarch start(gbuffer, sampling);
    constexpr std::int64_t kRows = 4;
    ParallelFor(A.Height(), kRows, [&](std::int64_t begin, std::int64_t end) {
        SliceMarch march = start;
        for (int y = int(begin); y < int(end); ++y) {
            for (int x = 0; x < A.Width(); ++x) A(x, y) = float(of_pixel(march, x, y));
        }
    });
    return A;
}

}  // namespace plumb
