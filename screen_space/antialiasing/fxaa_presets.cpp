#include "core/names.h"
#include "screen_space/antialiasing/fxaa.h"

namespace plumb {
namespace {

std::vector<double> Steps(std::vector<double> before, int twos, std::vector<double> after) {
    before.insert(before.end(), std::size_t(twos), 2.0);
    before.insert(before.end(), after.begin(), after.end());
    return before;
}

FxaaPreset Preset(int number, std::vector<double> steps_px) {
    FxaaPreset preset{.name = std::to_string(number), .options = {}};
    preset.options.steps_px = std::move(steps_px);
    return preset;
}

}  // namespace

std::vector<FxaaPreset> FxaaPresets() {
    std::vector<FxaaPreset> presets{
        // Made to be dithered.
        Preset(10, {1.5, 3, 12}), Preset(11, {1, 1.5, 3, 12}), Preset(12, {1, 1.5, 2, 4, 12}),
        Preset(13, Steps({1, 1.5}, 2, {4, 12})), Preset(14, Steps({1, 1.5}, 3, {4, 12})),
        Preset(15, Steps({1, 1.5}, 4, {4, 12})),
        // Less dither, dearer. 24 has the only step of 3.
        Preset(20, {1.5, 2, 8}), Preset(21, {1, 1.5, 2, 8}),
        Preset(22, Steps({1, 1.5}, 2, {8})), Preset(23, Steps({1, 1.5}, 3, {8})),
        Preset(24, Steps({1, 1.5}, 3, {3, 8}))};
    for (int number = 25; number <= 29; ++number) {
        presets.push_back(Preset(number, Steps({1, 1.5}, number - 21, {4, 8})));
    }
    presets.push_back(Preset(39, Steps({1, 1, 1, 1, 1, 1.5}, 4, {4, 8})));
    return presets;
}

FxaaOptions FxaaPresetNamed(const std::string& name) {
    const std::vector<FxaaPreset> presets = FxaaPresets();
    return FindNamed(
               presets, [](const FxaaPreset& preset) { return preset.name; }, name,
               "FXAA preset \"" + name + "\"")
        .options;
}

}  // namespace plumb
