#include "screen_space/sao_passes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/pack_ao_z.h"

namespace plumb {
namespace {

void CheckSize(const char* image, int width, int height, const View& view) {
    if (width != view.DrawnWidth() || height != view.DrawnHeight()) {
        throw Error(std::string("GBuffer::") + image + " has " + std::to_string(width) + " x " +
                    std::to_string(height) + " pixels, must have the view's " +
                    std::to_string(view.DrawnWidth()) + " x " +
                    std::to_string(view.DrawnHeight()));
    }
}

bool NeedsSurfaces(const SaoOptions& options) {
    return (options.blur_x || options.blur_y) &&
           (options.blur.normal_weight || options.blur.plane_weight);
}

const Image<Vec3f>& NormalImage(const GBuffer& gbuffer, const SaoOptions& options) {
    return options.sampling.normals == NormalSource::kFace ? gbuffer.face_normal
                                                           : gbuffer.shading_normal;
}

void CheckInput(const GBuffer& gbuffer, const SaoOptions& options) {
    Validate(options);
    const View& view = gbuffer.view;
    if (view.width_px < 1 || view.height_px < 1 || view.guard_px < 0 ||
        std::max(view.DrawnWidth(), view.DrawnHeight()) > 16384) {
        throw Error("GBuffer::view has " + std::to_string(view.DrawnWidth()) + " x " +
                    std::to_string(view.DrawnHeight()) + " pixels, must be in [1, 16384]");
    }
    for (const double tan : {view.tan_half_width, view.tan_half_height}) {
        if (!(tan >= 1e-6 && tan <= 1e6)) {
            throw Error(MustBe("GBuffer::view.tan_half", tan, "in [1e-6, 1e6]"));
        }
    }
    CheckSize("z_m", gbuffer.z_m.Width(), gbuffer.z_m.Height(), view);
    if (options.sampling.normals != NormalSource::kDepth || NeedsSurfaces(options)) {
        const Image<Vec3f>& normals = NormalImage(gbuffer, options);
        CheckSize("normal", normals.Width(), normals.Height(), view);
    }
}

/// A texture of 8 bits keeps of A.
void KeepBytesOf(Image<float>& A, const PixelRect& where) {
    ParallelFor(where.Height(), 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = where.y0 + int(begin); y < where.y0 + int(end); ++y) {
            float* row = &A(0, y);
            for (int x = where.x0; x < where.x1; ++x) row[x] = float(ToByte(row[x])) / 255;
        }
    });
}

/// A packed key does not tell the sky from what is far, so a filter mixes them.
void OpenTheSky(Image<float>& A, const Image<float>& z_m, const PixelRect& where) {
    ParallelFor(where.Height(), 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = where.y0 + int(begin); y < where.y0 + int(end); ++y) {
            float* row = &A(0, y);
            const float* z = &z_m(0, y);
            for (int x = where.x0; x < where.x1; ++x) {
                row[x] = z[x] == GBuffer::kSkyZ ? 1.0f : row[x];
            }
        }
    });
}

}  // namespace

void Validate(const SaoOptions& options) {
    Validate(options.sampling);
    Validate(options.blur);
    if (!(options.quad_threshold_m > 0 && options.quad_threshold_m <= 1e7)) {
        throw Error(
            MustBe("SaoOptions::quad_threshold_m", options.quad_threshold_m, "in (0, 1e7]"));
    }
    if (!(options.z_min_m >= -1e9 && options.z_min_m <= -1e-3)) {
        throw Error(MustBe("SaoOptions::z_min_m", options.z_min_m, "in [-1e9, -1e-3]"));
    }
}

SaoOptions InOtherUnit(const SaoOptions& options, double scale) {
    SaoOptions scaled = options;
    scaled.sampling.sao = InOtherUnit(options.sampling.sao, scale);
    scaled.quad_threshold_m *= scale;
    scaled.z_min_m *= scale;
    scaled.blur.near_m2 *= scale * scale;
    return scaled;
}

PixelRect ComputedRect(const View& view, const SaoOptions& options) {
    const bool blurs = options.blur_x || options.blur_y;
    return ShownAndMargin(view,
                          blurs ? options.blur.taps_each_side * options.blur.stride_px : 0);
}

ZPyramid BuildZPyramid(const GBuffer& gbuffer, const SaoOptions& options) {
    CheckInput(gbuffer, options);
    return ZPyramid(gbuffer.z_m, options.sampling.taps.filter,
                    options.sampling.taps.coarsest_level);
}

Image<float> SamplePass(const GBuffer& gbuffer, const ZPyramid& pyramid,
                        const SaoOptions& options) {
    return SampleObscurance(gbuffer, pyramid, options.sampling,
                            ComputedRect(gbuffer.view, options));
}

Image<float> QuadPass(const GBuffer& gbuffer, const SaoOptions& options, Image<float> A) {
    if (!options.quad_filter) return A;
    return QuadFiltered(std::move(A), gbuffer.z_m, options.quad_threshold_m,
                        ComputedRect(gbuffer.view, options));
}

PackedPass PackPass(const GBuffer& gbuffer, const SaoOptions& options, Image<float> A) {
    PackedPass packed{.A = std::move(A),
                      .guide = {.key = Image<float>(gbuffer.z_m.Width(), gbuffer.z_m.Height()),
                                .normal = nullptr,
                                .view = gbuffer.view,
                                .z_min_m = options.z_min_m}};
    if (NeedsSurfaces(options)) packed.guide.normal = &NormalImage(gbuffer, options);
    const PixelRect where = ComputedRect(gbuffer.view, options);
    if (options.pack_rgb8) KeepBytesOf(packed.A, where);
    const float per_z = float(1 / options.z_min_m);
    ParallelFor(where.Height(), 16, [&](std::int64_t begin, std::int64_t end) {
        for (int y = where.y0 + int(begin); y < where.y0 + int(end); ++y) {
            const float* z = &gbuffer.z_m(0, y);
            float* key = &packed.guide.key(0, y);
            for (int x = where.x0; x < where.x1; ++x) {
                key[x] = std::min(z[x] * per_z, 1.0f);
                if (options.pack_rgb8) key[x] = UnpackKey<float>(PackAoZ(0.0f, key[x]));
            }
        }
    });
    return packed;
}

Image<float> BlurPass(BlurAxis axis, const GBuffer& gbuffer, const SaoOptions& options,
                      const BlurGuide& guide, Image<float> A) {
    if (!(axis == BlurAxis::kX ? options.blur_x : options.blur_y)) return A;
    const PixelRect where = ComputedRect(guide.view, options);
    Image<float> blurred = BlurredAlong(axis, A, guide, options.blur, where);
    if (axis == BlurAxis::kX && options.pack_rgb8) KeepBytesOf(blurred, where);
    OpenTheSky(blurred, gbuffer.z_m, where);
    return blurred;
}

SaoPasses RunSao(const GBuffer& gbuffer, const SaoOptions& options) {
    const ZPyramid pyramid = BuildZPyramid(gbuffer, options);
    SaoPasses passes;
    passes.raw = SamplePass(gbuffer, pyramid, options);
    passes.quad = QuadPass(gbuffer, options, passes.raw);
    PackedPass packed = PackPass(gbuffer, options, passes.quad);
    passes.packed = std::move(packed.A);
    passes.blur_x = BlurPass(BlurAxis::kX, gbuffer, options, packed.guide, passes.packed);
    passes.blur_y = BlurPass(BlurAxis::kY, gbuffer, options, packed.guide, passes.blur_x);
    return passes;
}

Image<float> SaoObscurance(const GBuffer& gbuffer, const SaoOptions& options) {
    const ZPyramid pyramid = BuildZPyramid(gbuffer, options);
    PackedPass packed = PackPass(
        gbuffer, options, QuadPass(gbuffer, options, SamplePass(gbuffer, pyramid, options)));
    Image<float> A =
        BlurPass(BlurAxis::kX, gbuffer, options, packed.guide, std::move(packed.A));
    return BlurPass(BlurAxis::kY, gbuffer, options, packed.guide, std::move(A));
}

}  // namespace plumb
