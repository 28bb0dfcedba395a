#include "screen_space/sao/depth_read.h"

#include <algorithm>
#include <cassert>

#include "core/parallel.h"

namespace plumb {
namespace {

DepthFormat FormatOf(DepthRead read) {
    assert(read != DepthRead::kSurface);
    switch (read) {
        case DepthRead::kD16:
            return DepthFormat::kD16;
        case DepthRead::kD24:
            return DepthFormat::kD24;
        case DepthRead::kD32F:
            return DepthFormat::kD32F;
        case DepthRead::kSurface:
        case DepthRead::kD32FReversed:
            break;
    }
    return DepthFormat::kD32FReversed;
}

}  // namespace

Image<float> DepthAsRead(const Image<float>& z_m, const DepthRange& range, DepthRead read) {
    Validate(range);
    const DepthFormat format = FormatOf(read);
    const DepthCurve curve(range);
    const std::uint32_t empty = EncodeDepth(format, 0);
    Image<float> as_read(z_m.Width(), z_m.Height(), GBuffer::kSkyZ);
    ParallelFor(z_m.Height(), 8, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            for (int x = 0; x < z_m.Width(); ++x) {
                const float z = z_m(x, y);
                // NaN and what lies behind the eye stay, for whoever checks z.
                if (!(z < 0)) as_read(x, y) = z;
                if (!(z < 0) || z == GBuffer::kSkyZ) continue;
                const double e = std::clamp(curve.E(-double(z)), 0.0, 1.0);
                const std::uint32_t bits = EncodeDepth(format, e);
                if (bits == empty) continue;
                as_read(x, y) = ReconstructZ(format, range, float(DecodeDepth(format, bits)));
            }
        }
    });
    return as_read;
}

}  // namespace plumb
