// An image of one number a pixel, rows in chunks on all cores.
#pragma once

#include <cstdint>

#include "core/image.h"
#include "core/parallel.h"
#include "screen_space/slice_march.h"
#include "screen_space/slice_rows.h"

namespace plumb {

/// rows(task, first, last, A) for all rows of the drawn picture.
template <class Rows>
Image<float> EveryRow(const GBuffer& gbuffer, const SliceSampling& sampling, const Rows& rows) {
    Image<float> A(gbuffer.z_m.Width(), gbuffer.z_m.Height());
    const SliceTask task(gbuffer, sampling);
    constexpr std::int64_t kRows = 8;
    ParallelFor(A.Height(), kRows, [&](std::int64_t begin, std::int64_t end) {
        rows(task, int(begin), int(end), A);
    });
    return A;
}

/// of_pixel(march, x, y) for every pixel, one at a time.
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
