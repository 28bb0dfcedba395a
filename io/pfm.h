// Portable float maps: the plainest file of floats.
//
//       Pf | PF      one channel | three
//       width height
//       scale        its sign says the byte order: negative is little-endian
//       floats, rows from the bottom up
//
// Source   P. Debevec's format; http://www.pauldebevec.com/Research/HDR/PFM/
// Beware   The size of `scale` is a unit that nobody agrees on; it is not applied.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "io/stored_image.h"

namespace plumb {

/// `name` is what errors call the file whose content is `bytes`.
StoredImage ParsePfm(std::string_view bytes, const std::string& name, std::int64_t max_numbers);

}  // namespace plumb
