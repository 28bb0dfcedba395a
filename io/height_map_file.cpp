#include "io/height_map_file.h"

#include <cmath>

#include "core/error.h"
#include "io/content_hash.h"
#include "io/read_heights.h"
#include "io/side_file.h"

namespace plumb {
namespace {

void CheckOverrides(const HeightMapOverrides& overrides) {
    for (double spacing_m : overrides.spacing_m.value_or(Vec2(1, 1))) {
        if (!(spacing_m > 0) || !std::isfinite(spacing_m)) {
            throw Error(MustBe("--spacing-m", spacing_m, "> 0"));
        }
    }
    const auto check_amplitude = [](const char* flag, std::optional<double> amplitude) {
        if (amplitude && (!(*amplitude >= 0) || !std::isfinite(*amplitude))) {
            throw Error(MustBe(flag, *amplitude, ">= 0"));
        }
    };
    check_amplitude("--amplitude-m", overrides.amplitude_m);
    check_amplitude("--amplitude-of-width", overrides.amplitude_of_width);
    if (overrides.amplitude_m && overrides.amplitude_of_width) {
        throw Error("--amplitude-m and --amplitude-of-width: at most one must be given");
    }
    if (overrides.boundary) CheckBoundary("--boundary", *overrides.boundary);
}

Vec2 Spacing(const HeightMapOverrides& overrides, const SideFile& side, const RawHeights& raw,
             const std::string& file) {
    if (overrides.spacing_m) return *overrides.spacing_m;
    if (side.spacing_m) return *side.spacing_m;
    if (raw.spacing_m) return *raw.spacing_m;
    if (!raw.no_spacing_because.empty()) {
        throw Error(file + ": has no spacing in metres, " + raw.no_spacing_because +
                    "; spacing_m must be given in the side file or by --spacing-m");
    }
    const double spacing_m = kDefaultWidthM / raw.values.Width();
    return {spacing_m, spacing_m};
}

/// Metres between the values 0 and 1.
double Amplitude(const HeightMapOverrides& overrides, const SideFile& side,
                 const RawHeights& raw, double width_m) {
    if (overrides.amplitude_m) return *overrides.amplitude_m;
    if (overrides.amplitude_of_width) return *overrides.amplitude_of_width * width_m;
    if (side.amplitude_m) return *side.amplitude_m;
    if (side.amplitude_of_width) return *side.amplitude_of_width * width_m;
    if (side.metres_per_unit) return *side.metres_per_unit * raw.full_scale;
    if (side.high_m) return *side.high_m - *side.low_m;
    return raw.is_float ? 1 : kDefaultAmplitudeOfWidth * width_m;
}

std::string BoundaryOf(const HeightMapOverrides& overrides, const SideFile& side,
                       const RawHeights& raw) {
    if (overrides.boundary) return *overrides.boundary;
    if (side.boundary) return *side.boundary;
    return raw.spacing_m ? "open" : "wrap";
}

}  // namespace

HeightMapFile ReadHeightMap(const std::filesystem::path& path,
                            const HeightMapOverrides& overrides, std::int64_t max_numbers) {
    CheckOverrides(overrides);
    const SideFile side = ReadSideFile(path);
    RawHeights raw = ReadHeights(path, side.encoding, max_numbers);
    const Vec2 spacing_m = Spacing(overrides, side, raw, path.string());
    const double width_m = spacing_m.x() * raw.values.Width();
    const double amplitude_m = Amplitude(overrides, side, raw, width_m);
    HeightMapFile map{.name = side.name.value_or(path.stem().string()),
                      .heights_m = std::move(raw.values),
                      .spacing_x_m = spacing_m.x(),
                      .spacing_y_m = spacing_m.y(),
                      .boundary = BoundaryOf(overrides, side, raw),
                      .step_m = raw.is_float ? 0 : amplitude_m / raw.full_scale,
                      .bits = raw.bits,
                      .channel = raw.channel,
                      .sha256 = Sha256HexOfFile(path),
                      .source = side.source,
                      .licence = side.licence};
    for (double& height : map.heights_m.Pixels()) {
        height = side.low_m.value_or(0) + amplitude_m * height;
    }
    return map;
}

}  // namespace plumb
