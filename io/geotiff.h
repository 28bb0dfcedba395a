// What a GeoTIFF says of its grid: how wide a texel is, and which value means "no data".
//
// Source   [GeoTIFF] OGC 19-008r4, GeoTIFF 1.1: ModelPixelScaleTag (33550), 7.1.1
//          ModelTransformationTag (34264), GTModelTypeGeoKey (1024), ProjLinearUnitsGeoKey
//          (3076). "No data": tag 42113 of GDAL.
// Beware   Spacing in degrees is no spacing in metres: a geographic grid has none here, and
//          the reason is told instead.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/vec.h"

namespace plumb {

struct GeoTags {
    std::optional<Vec2> spacing_m;  ///< Along x and y, > 0.
    std::string
        no_spacing_because;  ///< Not empty if the file has a scale that is not in metres.
    std::optional<double> no_data;  ///< The stored number that means "not measured".
};

/// Of any TIFF; one without such tags gives an empty result. Throws Error if it is no TIFF.
GeoTags ReadGeoTags(const std::filesystem::path& path);

}  // namespace plumb
