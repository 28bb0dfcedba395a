// Names of files that a file system takes, however long those are that they come from.
#pragma once

#include <cstddef>
#include <string>

namespace plumb {

/// A name may have 255 bytes; an ending or a word before it has room besides this.
inline constexpr std::size_t kMostOfName = 200;

/// The name; of a longer one its beginning and digits of a hash of `of`, so that two that begin
/// alike stay apart.
std::string ShortName(const std::string& name, const std::string& of);

}  // namespace plumb
