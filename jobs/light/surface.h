// A height field with its papers: where it came from, enough to make it again.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "heightfield/height_field.h"
#include "reports/provenance.h"

namespace plumb {

/// A surface to simulate.
struct Surface {
    HeightField field;
    MapSource source;  ///< source.name names it in every report.
};

/// What the user may say of a map, over what its file says. Unset: the file's word counts.
struct SurfaceOptions {
    std::optional<double> spacing_m;           ///< Along x and y. (0, ...)
    std::optional<double> amplitude_m;         ///< Of the value 1 over the value 0. [0, ...)
    std::optional<double> amplitude_of_width;  ///< The same as a share of the width. [0, ...)
    std::optional<Boundary> boundary;
    int smooth_px = 0;  ///< Radius of the bilateral pre-filter in texels; 0 = none. [0, 64]
    double smooth_tolerance = 0.2;  ///< Its tolerance as a share of the relief. (0, 1]
};

/// Spacings must lie in [1e-30, 1e30] m, the relief within 1e6 of them: a height of -3.4e38 stands
/// for no data, not for a hole.
///
/// The surface that `name` means: the path of an image with heights (docs/height_maps.md), or
/// "make:KIND[:SIZE[:SEED]]" for a procedural one, e.g. "make:stone_wall:512:7". Throws Error.
Surface LoadSurface(const std::string& name, const SurfaceOptions& options = {});

/// The middle n x n texels (all of them if there are fewer), mirrored at their border: a piece
/// that stands for the whole where the whole would take too long.
HeightField MiddleOf(const HeightField& field, int n);

/// "wrap", "mirror", "open", and back (Error names the three).
std::string NameOf(Boundary boundary);
Boundary BoundaryNamed(const std::string& name);

}  // namespace plumb
