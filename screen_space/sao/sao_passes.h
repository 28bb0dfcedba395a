// SAO from a G-buffer to the filtered picture, pass by pass; each pass can be left out.
//
//       (depth ->) z pyramid -> sample -> quads -> pack (to RGB8) or key -> blur x -> blur y
//
// By these names they are told to an observer. Without one, what several passes do to a tile is done
// while the tile is in the cache: the same bits in less time.
//
// Source   [McGuire12] section 2.
// Symbols  A obscurance in [0, 1]: 1 = open.
// Beware   A is computed where it is shown and as far beyond as the filters reach, if that was
//          drawn; the rest of the border has A = 1. The sky has A = 1 after every pass.
//          The filter along x stores RGB8 again, if packing is on; the last filter does not.
#pragma once

#include "core/image.h"
#include "screen_space/gbuffer.h"
#include "screen_space/pass_observer.h"
#include "screen_space/sao/bilateral_blur.h"
#include "screen_space/sao/depth_read.h"
#include "screen_space/sao/obscurance_pass.h"
#include "screen_space/sao/quad_filter.h"

namespace plumb {

/// One configuration of SAO. The passes that are off hand on what they got.
struct SaoOptions {
    DepthRead depth = DepthRead::kSurface;  ///< Format of the depth that RunSao reads.
    ObscuranceOptions sampling;
    bool quad_filter = true;
    double quad_threshold_m = kQuadThresholdM;  ///< (0, 1e7]
    bool pack_rgb8 = true;
    double z_min_m = -300;  ///< Depth of key 1. [-1e9, -1e-3]
    BlurOptions blur;
    bool blur_x = true, blur_y = true;
};

/// Throws Error, naming the first field that breaks its range.
void Validate(const SaoOptions& options);

/// The options that give the same A once each length of the scene is `scale` times as great.
SaoOptions InOtherUnit(const SaoOptions& options, double scale);

/// Where A has to be computed so that what is shown is filtered from computed pixels.
PixelRect ComputedRect(const View& view, const SaoOptions& options);

/// Memory that RunSao uses again, picture after picture.
struct SaoScratch {
    ZPyramid pyramid;
    Image<float> A, key, blurred;
};

/// The passes that are on, one after the other; the last picture is one of the scratch's, until its
/// next use. Throws Error where options or the depth are bad, or the images are not of the view's
/// size.
const Image<float>& RunSao(const GBuffer& gbuffer, const SaoOptions& options,
                           SaoScratch& scratch, const PassObserver& observer = {});

/// The passes from packing on, over the A that the scratch holds: any technique's.
const Image<float>& RunSaoFilter(const GBuffer& gbuffer, const SaoOptions& options,
                                 SaoScratch& scratch, const PassObserver& observer = {});

/// The last picture alone. Without a scratch the memory alone takes a third as long again.
inline const Image<float>& SaoObscurance(const GBuffer& gbuffer, const SaoOptions& options,
                                         SaoScratch& scratch) {
    return RunSao(gbuffer, options, scratch);
}
Image<float> SaoObscurance(const GBuffer& gbuffer, const SaoOptions& options);

// The first two passes, for whoever samples one pyramid again and again.

/// Throws as RunSao does.
ZPyramid BuildZPyramid(const GBuffer& gbuffer, const SaoOptions& options);
Image<float> SamplePass(const GBuffer& gbuffer, const ZPyramid& pyramid,
                        const SaoOptions& options);

}  // namespace plumb
