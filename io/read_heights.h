// The one channel of an image that holds heights, as values, with what the file says of itself.
//
//       value = stored / greatest integer     integers: in [0, 1], or [-1, 1] if signed
//       value = stored                        floats
//
// Format and meaning of every field: docs/height_maps.md.
//
// Beware   The values are not metres yet: io/height_map_file.h makes them so.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "core/image.h"
#include "core/vec.h"
#include "io/stored_image.h"

namespace plumb {

/// Where in the pixels the heights are.
struct HeightEncoding {
    std::string channel = {};  ///< By name; "" = the only one, or R where R = G = B.
    bool rgb24 = false;        ///< One number 65536 R + 256 G + B of an 8-bit image.
};

struct RawHeights {
    Image<double> values;
    bool is_float = false;
    int bits = 0;                    ///< Of an integer or float: 8, 16, 24 (rgb24), 32, 64.
    double full_scale = 1;           ///< stored = value * full_scale; 1 for floats.
    std::string channel;             ///< The one used; "RGB" if packed.
    std::optional<Vec2> spacing_m;   ///< The file's own, along x and y (GeoTIFF).
    std::string no_spacing_because;  ///< Why a GeoTIFF has a scale but no spacing in metres.
};

/// Throws Error naming file, field, value and rule: everything that ReadStoredImage refuses,
/// channels that differ without a choice, NaN, infinity or "no data" (the first pixel is
/// named).
RawHeights ReadHeights(const std::filesystem::path& path, const HeightEncoding& encoding = {},
                       std::int64_t max_numbers = kMaxImageNumbers);

}  // namespace plumb
