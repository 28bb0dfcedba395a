// A picture as text inside a page: "data:image/png;base64,...".
#pragma once

#include <filesystem>
#include <string>

namespace plumb {

/// The PNG file of that path. Throws Error naming the file if it cannot be read.
std::string PngDataUri(const std::filesystem::path& path);

}  // namespace plumb
