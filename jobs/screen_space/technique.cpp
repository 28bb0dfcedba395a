#include "jobs/screen_space/technique.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "jobs/screen_space/ray_traced_visibility.h"
#include "screen_space/peers/gtao.h"
#include "screen_space/peers/hbao.h"
#include "screen_space/peers/visibility_bitmask.h"
#include "screen_space/sao/sao_presets.h"

namespace plumb {
namespace {

const std::vector<std::string> kSaoNames{"paper", "supplement2012", "g3d10"};
constexpr int kRayCounts[] = {1, 2, 4, 8};

// Takes the time of passes one after the other.
class Passes {
  public:
    explicit Passes(const PassClock& clock) : clock_(clock), last_s_(clock()) {}

    /// The pass since the last one has this name.
    void Ended(std::string name, Image<float> A = {}) {
        const double now_s = clock_();
        passes_.push_back({std::move(name), std::move(A), now_s - last_s_});
        last_s_ = clock_();
    }

    std::vector<Pass> Take() { return std::move(passes_); }

  private:
    const PassClock& clock_;
    double last_s_;
    std::vector<Pass> passes_;
};

// The filter passes of SAO, from packing on, over any A.
Image<float> Filter(const GBuffer& gbuffer, const SaoOptions& options, Image<float> A,
                    Passes& passes) {
    PackedPass packed = PackPass(gbuffer, options, std::move(A));
    passes.Ended(options.pack_rgb8 ? "pack" : "key", packed.A);
    A = std::move(packed.A);
    if (options.blur_x) {
        A = BlurPass(BlurAxis::kX, gbuffer, options, packed.guide, std::move(A));
        passes.Ended("blur x", A);
    }
    if (options.blur_y) {
        A = BlurPass(BlurAxis::kY, gbuffer, options, packed.guide, std::move(A));
        passes.Ended("blur y", A);
    }
    return A;
}

std::vector<Pass> RunSaoPasses(const GBuffer& gbuffer, const SaoOptions& options,
                               const PassClock& clock) {
    Validate(options);
    Passes passes(clock);
    const ZPyramid pyramid = BuildZPyramid(gbuffer, options);
    passes.Ended("z pyramid");
    Image<float> A = SamplePass(gbuffer, pyramid, options);
    passes.Ended("sample", A);
    if (options.quad_filter) {
        A = QuadPass(gbuffer, options, std::move(A));
        passes.Ended("quads", A);
    }
    Filter(gbuffer, options, std::move(A), passes);
    return passes.Take();
}

// Slices for about `samples` lookups at the given steps a side.
void SetSamples(SliceSampling& sampling, const TechniqueSettings& settings) {
    sampling.radius_m = settings.radius_m;
    if (settings.samples > 0) {
        const double wanted = settings.samples / 2.0;
        sampling.steps = std::max(1, int(std::lround(std::sqrt(wanted))));
        sampling.slices = std::max(1, int(std::lround(wanted / sampling.steps)));
    }
}

int SamplesOf(const SliceSampling& sampling) {
    return 2 * sampling.slices * sampling.steps;
}

// The filter that every technique but SAO's own gets: SAO's, on unpacked numbers.
SaoOptions CommonFilter(bool filter) {
    SaoOptions options = SaoSupplement2012();
    options.pack_rgb8 = false;
    options.blur_x = options.blur_y = filter;
    return options;
}

// What is shown, and as far beyond as that filter reads.
PixelRect WhereSampled(const TechniqueInput& in) {
    const BlurOptions& blur = CommonFilter(true).blur;
    return ShownAndMargin(in.gbuffer.view, blur.taps_each_side * blur.stride_px);
}

template <class Make>
Technique Sampled(std::string name, Falloff falloff, int samples, bool filter, Make make) {
    return {std::move(name), falloff, samples,
            [make, filter](const TechniqueInput& in, const PassClock& clock) {
                Passes passes(clock);
                Image<float> A = make(in);
                passes.Ended("sample", A);
                if (filter) Filter(in.gbuffer, CommonFilter(filter), std::move(A), passes);
                return passes.Take();
            }};
}

Technique RayTraced(int rays, const TechniqueSettings& settings) {
    const RayTracedOptions options{.radius_m = settings.radius_m, .rays = rays};
    return Sampled("rays-" + std::to_string(rays), Falloff::kHard, rays, settings.filter,
                   [options](const TechniqueInput& in) {
                       return RayTracedVisibility(in.caster, in.scene, in.camera, in.gbuffer,
                                                  options);
                   });
}

BitmaskOptions Bitmask(SectorMeasure measure, SectorRounding rounding,
                       const TechniqueSettings& settings) {
    BitmaskOptions options{.measure = measure, .rounding = rounding};
    SetSamples(options.sampling, settings);
    return options;
}

}  // namespace

void Validate(const TechniqueSettings& s) {
    if (!(s.radius_m > 0 && std::isfinite(s.radius_m))) {
        throw Error(MustBe("radius_m", s.radius_m, "in (0, infinity)"));
    }
    if (s.samples < 0 || s.samples > 4096) {
        throw Error(MustBe("samples", s.samples, "in [0, 4096]"));
    }
}

std::vector<std::string> TechniqueNames() {
    std::vector<std::string> names;
    for (const std::string& preset : kSaoNames) names.push_back("sao-" + preset);
    for (const char* name :
         {"alchemy", "hbao", "gtao", "gtao-hard", "bitmask", "bitmask-cosine"}) {
        names.push_back(name);
    }
    for (const int rays : kRayCounts) names.push_back("rays-" + std::to_string(rays));
    return names;
}

Falloff FalloffOf(SaoFalloffKind kind) {
    switch (kind) {
        case SaoFalloffKind::kSmooth:
            return Falloff::kSao;
        case SaoFalloffKind::kNoDivision:
        case SaoFalloffKind::kHighQuality:
            return Falloff::kQuadratic;
        case SaoFalloffKind::kEquation1:
        case SaoFalloffKind::kHpg12:
        case SaoFalloffKind::kLowContrast:
            break;
    }
    return Falloff::kHard;
}

SaoOptions SaoWith(const std::string& preset, const TechniqueSettings& settings) {
    SaoOptions options = SaoPresetNamed(preset);
    options.sampling.sao.radius_m = settings.radius_m;
    if (settings.samples > 0) {
        options.sampling.taps.samples = settings.samples;
        options.sampling.taps.turns = 0;
    }
    if (!settings.filter) options.blur_x = options.blur_y = false;
    return options;
}

Technique SaoTechnique(std::string name, const SaoOptions& options) {
    return {std::move(name), FalloffOf(options.sampling.sao.falloff),
            options.sampling.taps.samples,
            [options](const TechniqueInput& in, const PassClock& clock) {
                return RunSaoPasses(in.gbuffer, options, clock);
            }};
}

Technique TechniqueNamed(const std::string& name, const TechniqueSettings& settings) {
    Validate(settings);
    for (const std::string& preset : kSaoNames) {
        if (name == "sao-" + preset) return SaoTechnique(name, SaoWith(preset, settings));
    }
    if (name == "alchemy") return SaoTechnique(name, SaoWith("alchemy", settings));
    if (name == "hbao") {
        HbaoOptions options;
        SetSamples(options.sampling, settings);
        return Sampled(name, Falloff::kQuadratic, SamplesOf(options.sampling), settings.filter,
                       [options](const TechniqueInput& in) {
                           return Hbao(in.gbuffer, options, WhereSampled(in));
                       });
    }
    if (name == "gtao" || name == "gtao-hard") {
        GtaoOptions options;
        SetSamples(options.sampling, settings);
        if (name == "gtao-hard") {
            options.falloff_start = 1;
            options.normalize = true;
        }
        return Sampled(name, name == "gtao" ? Falloff::kFarEnd : Falloff::kHard,
                       SamplesOf(options.sampling), settings.filter,
                       [options](const TechniqueInput& in) {
                           return Gtao(in.gbuffer, options, WhereSampled(in));
                       });
    }
    if (name == "bitmask" || name == "bitmask-cosine") {
        const BitmaskOptions options =
            name == "bitmask"
                ? Bitmask(SectorMeasure::kUniform, SectorRounding::kCeil, settings)
                : Bitmask(SectorMeasure::kCosine, SectorRounding::kRound, settings);
        return Sampled(name, Falloff::kHard, SamplesOf(options.sampling), settings.filter,
                       [options](const TechniqueInput& in) {
                           return VisibilityBitmask(in.gbuffer, options, WhereSampled(in));
                       });
    }
    for (const int rays : kRayCounts) {
        if (name == "rays-" + std::to_string(rays)) {
            return RayTraced(settings.samples > 0 ? settings.samples : rays, settings);
        }
    }
    std::string names;
    for (const std::string& known : TechniqueNames()) {
        names += (names.empty() ? "" : ", ") + known;
    }
    throw Error("technique = " + name + ", must be one of: " + names);
}

TechniqueSettings SettingsOf(const LoadedScene& loaded, const std::string& name,
                             TechniqueSettings otherwise) {
    for (const TechniqueEntry& entry : loaded.techniques) {
        TechniqueNamed(entry.name);
        if (entry.name != name) continue;
        otherwise.radius_m = entry.radius_m.value_or(otherwise.radius_m);
        otherwise.samples = entry.samples.value_or(otherwise.samples);
        otherwise.filter = entry.filter.value_or(otherwise.filter);
    }
    return otherwise;
}

double TotalSeconds(const std::vector<Pass>& passes) {
    double seconds = 0;
    for (const Pass& pass : passes) seconds += pass.seconds;
    return seconds;
}

}  // namespace plumb
