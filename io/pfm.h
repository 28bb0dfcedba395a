// Portable float maps: the plainest file of floats.
//
//       Pf | PF      one channel | three
//       width height
//       scale        its sign says the byte order: negative is little-endian
//       floats, rows from the bottom up; a number is |scale| times its float
//
// Source   P. Debevec's format; http://www.pauldebevec.com/Research/HDR/PFM/
// Beware   Most writers write a scale of -1 or 1; some readers do not apply any other.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/stored_image.h"

namespace plumb {

/// `name` is what errors call the file whose content is `bytes`.
StoredImage ParsePfm(std::string_view bytes, const std::string& name, std::int64_t max_numbers);

}  // namespace plumb
