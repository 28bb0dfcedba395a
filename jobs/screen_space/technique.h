// The techniques that a report compares, all called alike: a G-buffer in, A out, pass by pass.
//
//       sao-paper, sao-supplement2012, sao-g3d10     [McGuire12], three generations of constants
//       alchemy                                      its baseline
//       hbao, gtao, bitmask                          peers on the same G-buffer, as shipped
//       gtao-hard                                    GTAO cut off hard at r, each pixel normalized
//       bitmask-cosine                               sectors even in cosine, ends rounded alike
//       rays-1, rays-2, rays-4, rays-8               ray-traced V within r
//
// All but the baseline's and SAO's own are followed by one and the same filter, that of SAO's
// supplement on unpacked numbers, so that none wins by a better filter.
// Each has a falloff: how much less it counts what is farther away. The truth weighted by the
// same falloff is what the technique means to compute; V and V within r are what its user wants.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "jobs/truth/load_scene.h"
#include "screen_space/sao/sao_passes.h"
#include "techniques/sao.h"
#include "techniques/technique.h"
#include "truth/near_visibility.h"

namespace plumb {

struct Pass {
    std::string name;
    Image<float> A;      ///< Of the drawn size; empty for passes that make no picture.
    double seconds = 0;  ///< Wall clock, all threads.
};

struct Technique {
    std::string name;
    Falloff falloff = Falloff::kHard;
    int samples = 0;  ///< Depth lookups, or rays, a pixel.
    std::function<std::vector<Pass>(const TechniqueInput&, const Clock&)> run;
};

/// What a caller may change in a technique.
struct TechniqueSettings {
    double radius_m = 1.5;
    int samples = 0;        ///< Lookups or rays a pixel; 0 = the technique's own.
    bool filter = true;     ///< The bilateral passes.
    KnobValues knobs = {};  ///< All others that are given.
};

/// Throws Error, naming field, value and rule.
void Validate(const TechniqueSettings& settings);

/// Throws Error "radius_m = ..." where that technique does not take the radius.
void RequireRadius(const std::string& technique, double radius_m);

std::vector<std::string> TechniqueNames();

/// Throws Error, listing the names, if there is none of that name.
Technique TechniqueNamed(const std::string& name, const TechniqueSettings& settings = {});

/// A preset of SAO with that radius, and taps where settings name them.
SaoOptions SaoWith(const std::string& preset, const TechniqueSettings& settings);

/// The settings of that technique: what the scene's file says of it, else `otherwise`. Throws Error,
/// naming the file and the field, if the file names a technique or a knob that there is not, or a
/// value that is none.
TechniqueSettings SettingsOf(const LoadedScene& loaded, const std::string& name,
                             TechniqueSettings otherwise);

/// What the command line gives of each technique: --set NAME.KNOB=VALUE, the last one counts.
using ValuesByTechnique = std::map<std::string, KnobValues>;

/// Throws Error, naming what was given and the rule.
ValuesByTechnique ValuesOfSet(const std::vector<std::string>& set);

/// Throws Error if `set` turns a technique that is not among those that run.
void CheckSetIsOf(const ValuesByTechnique& set, const std::vector<std::string>& running);

/// The values over the settings: they win.
TechniqueSettings Over(TechniqueSettings settings, const std::string& technique,
                       const KnobValues& values);

/// The part of a drawn picture that is shown.
template <class T>
Image<T> Shown(const Image<T>& drawn, const View& view) {
    Image<T> shown(view.width_px, view.height_px, drawn(view.guard_px, view.guard_px));
    for (int j = 0; j < view.height_px; ++j) {
        for (int i = 0; i < view.width_px; ++i) {
            shown(i, j) = drawn(i + view.guard_px, j + view.guard_px);
        }
    }
    return shown;
}

}  // namespace plumb
