#include "screen_space/obscurance_pass.h"

#include <cassert>

#include "core/parallel.h"

namespace plumb {

Image<float> SampleObscurance(const GBuffer& gbuffer, const ZPyramid& pyramid,
                              const ObscuranceOptions& options, const PixelRect& where) {
    Image<float> A(gbuffer.z_m.Width(), gbuffer.z_m.Height(), 1.0f);
    ParallelFor(where.Height(), 4, [&](std::int64_t begin, std::int64_t end) {
        for (int y = where.y0 + int(begin); y < where.y0 + int(end); ++y) {
            for (int x = where.x0; x < where.x1; ++x) {
                A(x, y) = float(ObscuranceOfPixel(gbuffer, pyramid, options, x, y));
            }
        }
    });
    return A;
}

}  // namespace plumb
