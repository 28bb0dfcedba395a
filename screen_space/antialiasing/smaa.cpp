#include "screen_space/antialiasing/smaa.h"

#include <algorithm>
#include <cstdint>

#include "core/error.h"
#include "core/names.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/smaa_edges.h"
#include "screen_space/antialiasing/smaa_weights.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 8;
constexpr float kNoShare = 1e-5f;  // Of the shader: a sum below it changes nothing.

/// `a` moved by `share` of a pixel towards b.
Rgb Moved(const Rgb& a, const Rgb& b, float share) {
    Rgb out;
    for (std::size_t c = 0; c < 3; ++c) out[c] = a[c] + (b[c] - a[c]) * share;
    return out;
}

/// Blends the pixel with the two neighbours along an axis.
Rgb Blended(const Rgb& here, const Rgb& before, float share_before, const Rgb& after,
            float share_after) {
    const float sum = share_before + share_after;
    const Rgb a = Moved(here, before, share_before), b = Moved(here, after, share_after);
    return Moved(a, b, share_after / sum);
}

void BlendRow(const Image<Rgb>& picture, const Image<SmaaWeights>& weights, int y,
              Image<Rgb>& out) {
    const int W = picture.Width(), H = picture.Height();
    for (int x = 0; x < W; ++x) {
        const SmaaWeights& own = weights(x, y);
        const float up = own[0], left = own[2];
        const float down = y + 1 < H ? weights(x, y + 1)[1] : 0;
        const float right = x + 1 < W ? weights(x + 1, y)[3] : 0;
        if (up + left + down + right < kNoShare) {
            out(x, y) = picture(x, y);
        } else if (std::max(left, right) > std::max(up, down)) {
            out(x, y) = Blended(picture(x, y), picture(std::max(x - 1, 0), y), left,
                                picture(std::min(x + 1, W - 1), y), right);
        } else {
            out(x, y) = Blended(picture(x, y), picture(x, std::max(y - 1, 0)), up,
                                picture(x, std::min(y + 1, H - 1)), down);
        }
    }
}

SmaaPreset Preset(const char* name, double threshold, int search, int diagonal,
                  double rounding) {
    return {name,
            {.threshold = threshold,
             .search_steps = search,
             .diagonal_steps = diagonal,
             .corner_rounding = rounding}};
}

void CheckRange(const char* field, double value, double low, double high, const char* rule) {
    if (!(value >= low && value <= high)) {
        throw Error(MustBe(std::string("SmaaOptions::") + field, value, rule));
    }
}

std::string SizeOf(const Image<Rgb>& picture) {
    return std::to_string(picture.Width()) + " x " + std::to_string(picture.Height());
}

}  // namespace

void Validate(const SmaaOptions& options) {
    CheckRange("threshold", options.threshold, 0, 0.5, "in [0, 0.5]");
    CheckRange("search_steps", options.search_steps, 0, 112, "in [0, 112]");
    CheckRange("diagonal_steps", options.diagonal_steps, 0, 19, "in [0, 19]");
    CheckRange("corner_rounding", options.corner_rounding, 0, 100, "in [0, 100]");
    CheckRange("local_contrast_factor", options.local_contrast_factor, 0, 1e30,
               "finite and not negative");
}

Image<Rgb> SmaaFiltered(const Image<Rgb>& picture, const SmaaOptions& options) {
    return SmaaFiltered(picture, picture, options);
}

Image<Rgb> SmaaFiltered(const Image<Rgb>& encoded, const Image<Rgb>& linear,
                        const SmaaOptions& options) {
    Validate(options);
    if (encoded.Width() != linear.Width() || encoded.Height() != linear.Height()) {
        throw Error("SmaaFiltered: linear = " + SizeOf(linear) +
                    ", must be of the size of encoded, " + SizeOf(encoded));
    }
    if (encoded.Empty()) return linear;
    const Image<SmaaWeights> weights =
        FindSmaaWeights(FindSmaaEdges(encoded, options), options);
    Image<Rgb> out(linear.Width(), linear.Height());
    ParallelFor(linear.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end); ++y) BlendRow(linear, weights, y, out);
    });
    return out;
}

std::vector<SmaaPreset> SmaaPresets() {
    return {Preset("low", 0.15, 4, 0, 100), Preset("medium", 0.1, 8, 0, 100),
            Preset("high", 0.1, 16, 8, 25), Preset("ultra", 0.05, 32, 16, 25)};
}

SmaaOptions SmaaPresetNamed(const std::string& name) {
    const std::vector<SmaaPreset> presets = SmaaPresets();
    return FindNamed(
               presets, [](const SmaaPreset& preset) { return preset.name; }, name,
               "SMAA preset \"" + name + "\"")
        .options;
}

}  // namespace plumb
