#include "jobs/light/surface.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "heightfield/bilateral_filter.h"
#include "heightfield/procedural/catalogue.h"
#include "io/content_hash.h"
#include "io/height_map_file.h"

namespace plumb {
namespace {

constexpr std::string_view kMake = "make:";
constexpr int kMadeTexels = 256;
constexpr double kLeastSpacingM = 1e-30, kMostReliefTexels = 1e6;
constexpr std::array kBoundaries = {std::pair{"wrap", Boundary::kWrap},
                                    std::pair{"mirror", Boundary::kMirror},
                                    std::pair{"open", Boundary::kOpen}};

std::vector<std::string> SplitAtColons(std::string_view text) {
    std::vector<std::string> parts;
    while (true) {
        const std::size_t colon = text.find(':');
        parts.emplace_back(text.substr(0, colon));
        if (colon == std::string_view::npos) return parts;
        text.remove_prefix(colon + 1);
    }
}

template <class T>
T WholeNumber(const std::string& text, const std::string& name, const char* what) {
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
        throw Error(name + ": " + what + " = " + text + ", must be a whole number");
    }
    return value;
}

std::string HashOfHeights(const HeightField& field) {
    const std::vector<double>& z = field.HeightsM().Pixels();
    return Sha256Hex({reinterpret_cast<const char*>(z.data()), z.size() * sizeof(double)});
}

Surface Made(const std::string& name, const SurfaceOptions& o) {
    const std::vector<std::string> parts = SplitAtColons(name.substr(kMake.size()));
    if (parts.size() > 3) {
        throw Error(name + ": must be make:KIND[:SIZE[:SEED]]");
    }
    const ProceduralKind& kind = ProceduralKindNamed(parts[0]);
    const int texels =
        parts.size() > 1 ? WholeNumber<int>(parts[1], name, "SIZE in texels") : kMadeTexels;
    const std::uint64_t seed =
        parts.size() > 2 ? WholeNumber<std::uint64_t>(parts[2], name, "SEED") : 1;
    Tile tile = AdvisedTile(kind, texels, texels);
    if (o.spacing_m) {
        tile.width_m = tile.height_m = *o.spacing_m * texels;
        tile.amplitude_m = kind.amplitude_per_width * tile.width_m;
    }
    if (o.amplitude_of_width && !(*o.amplitude_of_width > 0)) {
        throw Error(MustBe("--amplitude-of-width", *o.amplitude_of_width,
                           "> 0: a made map has relief"));
    }
    if (o.amplitude_of_width) tile.amplitude_m = *o.amplitude_of_width * tile.width_m;
    if (o.amplitude_m) tile.amplitude_m = *o.amplitude_m;
    HeightField field = kind.make(seed, tile);
    if (o.boundary && *o.boundary != Boundary::kWrap) {
        field = HeightField(field.HeightsM(), field.SpacingXM(), field.SpacingYM(), *o.boundary,
                            field.GetDiagonal());
    }
    MapSource source;
    source.name = parts[0] + (seed == 1 ? "" : " " + std::to_string(seed));
    source.sha256 = HashOfHeights(field);
    source.source = name;
    return {std::move(field), std::move(source)};
}

Surface Read(const std::string& name, const SurfaceOptions& o) {
    HeightMapOverrides overrides;
    if (o.spacing_m) overrides.spacing_m = Vec2(*o.spacing_m, *o.spacing_m);
    overrides.amplitude_m = o.amplitude_m;
    overrides.amplitude_of_width = o.amplitude_of_width;
    if (o.boundary) overrides.boundary = NameOf(*o.boundary);
    HeightMapFile file = ReadHeightMap(name, overrides);
    const std::string short_name = std::filesystem::path(name).filename().string();
    try {
        HeightField field(std::move(file.heights_m), file.spacing_x_m, file.spacing_y_m,
                          BoundaryNamed(file.boundary));
        MapSource source;
        source.name = file.name;
        source.file = short_name;
        source.sha256 = file.sha256;
        source.source = file.source;
        source.licence = file.licence;
        return {std::move(field), std::move(source)};
    } catch (const Error& error) {
        throw Error(name + ": " + error.what());
    }
}

// Heights and spacings that light can be told from: beyond, rounding hides one facet from the
// next, and lines of sight never end.
void RequireSaneRelief(const std::string& name, const HeightField& field,
                       const SurfaceOptions& o) {
    const auto refuse = [&](const char* what, double value, const char* rule) {
        std::ostringstream said;
        const auto say = [&said](const char* flag, const std::optional<double>& given) {
            if (given)
                said << (said.str().empty() ? "; given: " : ", ") << flag << " " << *given;
        };
        say("--spacing-m", o.spacing_m);
        say("--amplitude-m", o.amplitude_m);
        say("--amplitude-of-width", o.amplitude_of_width);
        throw Error(MustBe(name + ": " + what, value, rule) + said.str());
    };
    for (const double spacing_m : {field.SpacingXM(), field.SpacingYM()}) {
        if (spacing_m < kLeastSpacingM || spacing_m > 1 / kLeastSpacingM) {
            refuse("spacing in metres", spacing_m, "in [1e-30, 1e30]");
        }
    }
    const double relief_texels =
        (field.HighestM() - field.LowestM()) / std::min(field.SpacingXM(), field.SpacingYM());
    if (!(relief_texels <= kMostReliefTexels)) {
        refuse("relief over spacing", relief_texels,
               "<= 1e6 (is there a height that stands for no data?)");
    }
}

}  // namespace

Surface LoadSurface(const std::string& name, const SurfaceOptions& options) {
    Surface surface = name.starts_with(kMake) ? Made(name, options) : Read(name, options);
    RequireSaneRelief(name, surface.field, options);
    if (options.smooth_px > 0) {
        const double relief_m = surface.field.HighestM() - surface.field.LowestM();
        if (relief_m > 0) {
            surface.field = Filtered(surface.field,
                                     {options.smooth_px, options.smooth_tolerance * relief_m});
        }
        surface.source.preparation =
            "bilateral filter, radius " + std::to_string(options.smooth_px) + " texels";
    }
    MapSource& source = surface.source;
    source.width_texels = surface.field.Width();
    source.height_texels = surface.field.Height();
    source.spacing_x_m = surface.field.SpacingXM();
    source.spacing_y_m = surface.field.SpacingYM();
    source.amplitude_m = surface.field.HighestM() - surface.field.LowestM();
    source.boundary = NameOf(surface.field.GetBoundary());
    return surface;
}

HeightField MiddleOf(const HeightField& field, int n) {
    const int w = std::min(n, field.Width()), h = std::min(n, field.Height());
    const int i0 = (field.Width() - w) / 2, j0 = (field.Height() - h) / 2;
    Image<double> heights(w, h);
    for (int j = 0; j < h; ++j) {
        for (int i = 0; i < w; ++i) heights(i, j) = field.At(i0 + i, j0 + j);
    }
    return HeightField(std::move(heights), field.SpacingXM(), field.SpacingYM(),
                       Boundary::kMirror, field.GetDiagonal());
}

std::string NameOf(Boundary boundary) {
    for (const auto& [name, value] : kBoundaries) {
        if (value == boundary) return name;
    }
    return "";
}

Boundary BoundaryNamed(const std::string& name) {
    for (const auto& [known, value] : kBoundaries) {
        if (name == known) return value;
    }
    throw Error("boundary = " + name + ", must be wrap, mirror or open");
}

}  // namespace plumb
