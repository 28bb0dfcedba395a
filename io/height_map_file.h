// A height map in metres: image, side file and command line put together.
//
//       height_m = low_m + amplitude_m value      or  low_m + metres_per_unit stored
//       height_m = low_m + (high_m - low_m) value
//
// The command line comes before the side file, the side file before what the image says. All
// rules and defaults: docs/height_maps.md. With nothing said, an integer map is 1 m wide with
// an amplitude of 0.1 m and repeats; a float map is 1 m wide and holds metres.
//
// Source   the defaults: [Mayaux18], "height amplitudes that are roughly 1/10 the size of the
//          map (so a 10cm height amplitude for a 1m large texture in my case)".
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/image.h"
#include "core/vec.h"
#include "io/stored_image.h"

namespace plumb {

/// Share of the width that an integer map is high if nothing says otherwise.
inline constexpr double kDefaultAmplitudeOfWidth = 0.1;

/// Width of a map of which nothing says how wide it is. [m]
inline constexpr double kDefaultWidthM = 1;

/// What the command line says. An amplitude replaces all of the side file's height fields but
/// low_m; at most one of the two.
struct HeightMapOverrides {
    std::optional<Vec2> spacing_m = {};      ///< Along x and y. (0, ...)
    std::optional<double> amplitude_m = {};  ///< Metres between the values 0 and 1. [0, ...)
    std::optional<double> amplitude_of_width =
        {};                                    ///< The same as a share of the width. [0, ...)
    std::optional<std::string> boundary = {};  ///< "wrap", "mirror" or "open".
};

struct HeightMapFile {
    std::string name;
    Image<double> heights_m;
    double spacing_x_m = 0, spacing_y_m = 0;
    std::string boundary;  ///< "wrap", "mirror" or "open".
    /// Metres between two neighbouring stored numbers; 0 for floats. Coarse steps show as
    /// terraces: a slope of step_m / spacing from a single grey step.
    double step_m = 0;
    int bits = 0;         ///< Of a stored number.
    std::string channel;  ///< The one that was read.
    std::string sha256;   ///< Of the image file's bytes, as sha256sum prints it.
    std::string source, licence;
};

/// Throws Error naming file (or flag), field, value and rule.
HeightMapFile ReadHeightMap(const std::filesystem::path& path,
                            const HeightMapOverrides& overrides = {},
                            std::int64_t max_numbers = kMaxImageNumbers);

}  // namespace plumb
