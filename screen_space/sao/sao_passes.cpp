#include "screen_space/sao/sao_passes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/sao/blur_rows.h"
#include "screen_space/sao/obscurance_tile.h"
#include "screen_space/sao/pack_rows.h"

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

/// What the filters' texture holds of the A and the key of a tile.
void PackTile(const GBuffer& gbuffer, const SaoOptions& options, const PixelRect& tile,
              Image<float>& A, Image<float>& key) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        KeysOfRow(&gbuffer.z_m(tile.x0, y), options.z_min_m, tile.Width(), &key(tile.x0, y));
        if (options.pack_rgb8) KeepRgb8OfRow(tile.Width(), &A(tile.x0, y), &key(tile.x0, y));
    }
}

/// One filter within `where`, from A to `to`.
void Blur(BlurAxis axis, const GBuffer& gbuffer, const SaoOptions& options,
          const BlurGuide& guide, const Image<float>& A, Image<float>& to) {
    const PixelRect where = ComputedRect(guide.view, options);
    const bool keep_bytes = axis == BlurAxis::kX && options.pack_rgb8;
    ParallelFor(where.Height(), 8, [&](std::int64_t begin, std::int64_t end) {
        for (int y = where.y0 + int(begin); y < where.y0 + int(end); ++y) {
            BlurRow(axis, A, guide, options.blur, y, where.x0, where.x1, &to(0, y));
            FinishRow(&gbuffer.z_m(where.x0, y), keep_bytes, where.Width(), &to(where.x0, y));
        }
    });
}

BlurGuide GuideOf(const GBuffer& gbuffer, const SaoOptions& options, Image<float> key) {
    return {.key = std::move(key),
            .normal = NeedsSurfaces(options) ? &NormalImage(gbuffer, options) : nullptr,
            .view = gbuffer.view,
            .z_min_m = options.z_min_m};
}

bool IsOn(BlurAxis axis, const SaoOptions& options) {
    return options.blur.taps_each_side > 0 &&
           (axis == BlurAxis::kX ? options.blur_x : options.blur_y);
}

/// A picture of the drawn size: the one given, if it is.
void Resize(Image<float>& image, const View& view, float value) {
    if (image.Width() != view.DrawnWidth() || image.Height() != view.DrawnHeight()) {
        image = Image<float>(view.DrawnWidth(), view.DrawnHeight(), value);
    }
}

/// `value` outside of `where`.
void FillOutside(Image<float>& image, const PixelRect& where, float value) {
    for (int y = 0; y < image.Height(); ++y) {
        float *row = &image(0, y), *end = row + image.Width();
        if (y < where.y0 || y >= where.y1) {
            std::fill(row, end, value);
        } else {
            std::fill(row, row + where.x0, value);
            std::fill(row + where.x1, end, value);
        }
    }
}

/// Room for what is computed, with what lies around it: 1 for A, 0 for the key.
void ReadyScratch(const View& view, const SaoOptions& options, SaoScratch& scratch) {
    const PixelRect where = ComputedRect(view, options);
    // New memory costs as much as a pass, so all cores fetch it.
    Image<float>* const images[] = {&scratch.A, &scratch.blurred, &scratch.key};
    ParallelFor(3, 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k) {
            const float outside = images[k] == &scratch.key ? 0 : 1;
            Resize(*images[k], view, outside);
            FillOutside(*images[k], where, outside);
        }
    });
}

/// A pass that needs of other tiles nothing.
struct TilePass {
    const char* name;
    std::function<void(const PixelRect&)> run;
};

TilePass Pack(const GBuffer& gbuffer, const SaoOptions& options, SaoScratch& scratch) {
    return {options.pack_rgb8 ? "pack" : "key", [&](const PixelRect& tile) {
                PackTile(gbuffer, options, tile, scratch.A, scratch.key);
            }};
}

/// One after the other over the whole picture where each is told, else all of them tile by tile.
void RunTilePasses(const PixelRect& where, const std::vector<TilePass>& passes,
                   const Image<float>& A, const PassObserver& observer) {
    if (!observer) {
        ForEachTile(where, [&](const PixelRect& tile) {
            for (const TilePass& pass : passes) pass.run(tile);
        });
        return;
    }
    for (const TilePass& pass : passes) {
        ForEachTile(where, pass.run);
        observer(pass.name, A);
    }
}

const Image<float>& BlurAll(const GBuffer& gbuffer, const SaoOptions& options,
                            SaoScratch& scratch, const PassObserver& observer) {
    BlurGuide guide = GuideOf(gbuffer, options, std::move(scratch.key));
    for (const BlurAxis axis : {BlurAxis::kX, BlurAxis::kY}) {
        if (!IsOn(axis, options)) continue;
        Blur(axis, gbuffer, options, guide, scratch.A, scratch.blurred);
        std::swap(scratch.A, scratch.blurred);
        if (observer) observer(axis == BlurAxis::kX ? "blur x" : "blur y", scratch.A);
    }
    scratch.key = std::move(guide.key);
    return scratch.A;
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

const Image<float>& RunSao(const GBuffer& gbuffer, const SaoOptions& options,
                           SaoScratch& scratch, const PassObserver& observer) {
    CheckInput(gbuffer, options);
    if (options.depth != DepthRead::kSurface) {
        GBuffer as_read = gbuffer;
        as_read.z_m = DepthAsRead(gbuffer.z_m, gbuffer.range, options.depth);
        if (observer) observer("depth", {});
        SaoOptions others = options;
        others.depth = DepthRead::kSurface;
        return RunSao(as_read, others, scratch, observer);
    }
    const TapOptions& taps = options.sampling.taps;
    scratch.pyramid.Build(gbuffer.z_m, taps.filter, taps.coarsest_level);
    if (observer) observer("z pyramid", {});
    ReadyScratch(gbuffer.view, options, scratch);
    const ObscuranceTask task(gbuffer, scratch.pyramid, options.sampling);
    std::vector<TilePass> passes{
        {"sample", [&](const PixelRect& tile) { ObscureTile(task, tile, scratch.A); }}};
    if (options.quad_filter) {
        passes.push_back({"quads", [&](const PixelRect& tile) {
                              FilterQuads(scratch.A, gbuffer.z_m, options.quad_threshold_m,
                                          tile);
                          }});
    }
    passes.push_back(Pack(gbuffer, options, scratch));
    RunTilePasses(ComputedRect(gbuffer.view, options), passes, scratch.A, observer);
    return BlurAll(gbuffer, options, scratch, observer);
}

const Image<float>& RunSaoFilter(const GBuffer& gbuffer, const SaoOptions& options,
                                 SaoScratch& scratch, const PassObserver& observer) {
    CheckInput(gbuffer, options);
    CheckSize("A", scratch.A.Width(), scratch.A.Height(), gbuffer.view);
    ReadyScratch(gbuffer.view, options, scratch);
    const std::vector<TilePass> passes{Pack(gbuffer, options, scratch)};
    RunTilePasses(ComputedRect(gbuffer.view, options), passes, scratch.A, observer);
    return BlurAll(gbuffer, options, scratch, observer);
}

Image<float> SaoObscurance(const GBuffer& gbuffer, const SaoOptions& options) {
    SaoScratch scratch;
    RunSao(gbuffer, options, scratch);
    return std::move(scratch.A);
}

}  // namespace plumb
