// A TIFF file that is open, for the files of io/ that read its tags and its pixels.
#pragma once

#include <filesystem>
#include <memory>

struct tiff;  // libtiff's TIFF, whose header stays in .cpp files

namespace plumb {

/// Closed when the last owner goes; nothing is printed. Throws Error if it is no TIFF.
std::shared_ptr<tiff> OpenTiff(const std::filesystem::path& path);

}  // namespace plumb
