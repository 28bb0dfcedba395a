// Shades samples of an enlarged G-buffer by the model of core/shading.h.
//
//       x = P(X + 1/2, Y + 1/2, z),   rho = albedo of the material times its texture at (u, v)
//
// in the scene's own frame, sky as the light has it from there. Shadows are whatever the caller
// says of a light and a point: none by default.
//
// Source   [Hollander13] section 4.1; a shader made dearer: section 5, its "stalled" case.
// Beware   Without a filter textures are bilinear at the sample, whatever the number of samples of
//          its pixel; with it they are filtered as wide as that asks for (texture_footprint.h).
#pragma once

#include <functional>

#include "core/camera.h"
#include "core/scene.h"
#include "core/shading.h"
#include "screen_space/antialiasing/adaptive_shading.h"
#include "screen_space/antialiasing/texture_footprint.h"
#include "screen_space/antialiasing/wide_gbuffer.h"

namespace plumb {

/// Does the light reach point x_m of a surface with face normal `face`, both of the scene's frame?
/// Called from many threads.
using IsLit = std::function<bool(const LightAt& light, const Vec3& x_m, const Vec3& face)>;

/// How textures are read.
enum class TextureFilter { kNone, kAnisotropic };

struct DeferredOptions {
    IsLit is_lit;   ///< Empty: no shadows.
    int times = 1;  ///< How often each sample is shaded: what a dearer shader costs. >= 1
    TextureFilter filter = TextureFilter::kNone;
    FootprintSource footprint = FootprintSource::kSurface;
    int most_taps = 16;  ///< Of the filter; 16 is what GPUs have. [1, 64]
};

/// The shader of g's samples; scene and g must outlive it. Throws Error if an option is
/// out of range.
SampleShader DeferredShader(const Scene& scene, const Camera& camera, const WideGBuffer& g,
                            const DeferredOptions& options = {});

}  // namespace plumb
