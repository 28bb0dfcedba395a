// The pixels of a TIFF, by libtiff itself.
//
// OpenImageIO 2.4 would read most of them, but says nothing when a compressed strip is damaged,
// and gives zeros for some images of 64-bit floats.
//
// Domain   Integers of 8, 16, 32 bits and floats of 16, 32, 64; strips or tiles, channels mixed
//          or apart, every compression of libtiff; grey or RGB. One image and its overviews.
#pragma once

#include <cstdint>
#include <filesystem>

#include "io/stored_image.h"

namespace plumb {

/// Throws Error naming file, field, value and rule.
StoredImage ReadTiffImage(const std::filesystem::path& path, std::int64_t max_numbers);

}  // namespace plumb
