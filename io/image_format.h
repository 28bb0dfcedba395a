// What an image file really is, before anything is decoded: endings lie, headers exaggerate.
//
// A JPEG that was renamed to .png would be read by some libraries and be full of 8 x 8 blocks;
// a download that failed is often a web page called heights.tif.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace plumb {

enum class ImageFormat { kPng, kTiff, kExr, kPfm };

/// The format of the image `path` whose content is `bytes`. Throws Error if the file is empty,
/// if its ending is none of .png, .tif, .tiff, .exr, .pfm (in any case), or if the content is
/// something else, which is named where it is known.
ImageFormat CheckImageFormat(const std::filesystem::path& path, std::string_view bytes);

/// Throws Error unless `bytes` are whole PNG chunks with correct checksums from the header to
/// the end mark: decoders accept a file that lost its tail.
void CheckPngIsWhole(const std::filesystem::path& path, std::string_view bytes);

/// Throws Error if `bytes`, whole chunks, are too few for the pixels that their header claims,
/// however well they are compressed: decoders take seconds and gigabytes to find out.
void CheckPngHoldsItsPixels(const std::string& name, std::string_view bytes);

/// Throws Error naming the size and the limit if an image is empty or would have more numbers
/// than `max_numbers`: before memory is taken for it.
void CheckImageSize(const std::string& name, std::int64_t width, std::int64_t height,
                    std::int64_t channels, std::int64_t max_numbers);

}  // namespace plumb
