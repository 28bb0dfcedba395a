// The side file of a height map: NAME.json beside NAME.png says what the image cannot.
//
// Format and meaning of every field: docs/height_maps.md.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/vec.h"
#include "io/read_heights.h"

namespace plumb {

struct SideFile {
    std::optional<std::string> name;
    std::optional<Vec2> spacing_m;  ///< Along x and y, > 0.
    /// How values become metres; at most one of these four.
    std::optional<double> amplitude_m, amplitude_of_width, metres_per_unit, high_m;
    std::optional<double> low_m;          ///< Height of the value 0.
    std::optional<std::string> boundary;  ///< "wrap", "mirror" or "open".
    HeightEncoding encoding;
    std::string source, licence;
};

/// Where the side file of an image stands.
std::filesystem::path SideFilePath(const std::filesystem::path& image);

/// The side file of an image; all fields empty if there is none. Throws Error naming file,
/// field, value and rule.
SideFile ReadSideFile(const std::filesystem::path& image);

/// "wrap", "mirror" or "open"; throws Error naming `where` and the value otherwise.
void CheckBoundary(const std::string& where, const std::string& boundary);

}  // namespace plumb
