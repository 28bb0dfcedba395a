// A GeoTIFF as surveys write it: libtiff with the tags of the standard.
#pragma once

#include <gtest/gtest.h>
#include <tiffio.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <type_traits>
#include <vector>

namespace plumb {

struct GeoTiffOptions {
    std::vector<double> pixel_scale = {};      ///< Tag 33550: three numbers.
    std::vector<double> transformation = {};   ///< Tag 34264: sixteen numbers.
    std::vector<std::uint16_t> geo_keys = {};  ///< Tag 34735 after its header: rows of four.
    std::string no_data = {};                  ///< Tag 42113.
};

/// Heights in the type T: signed integers or floats.
template <class T>
void WriteGeoTiffOf(const std::filesystem::path& path, std::uint32_t width,
                    const std::vector<T>& heights, const GeoTiffOptions& options) {
    char names[4][32] = {"ModelPixelScale", "ModelTransformation", "GeoKeyDirectory",
                         "GdalNoData"};
    const std::array<TIFFFieldInfo, 4> fields{{
        {33550, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[0]},
        {34264, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, names[1]},
        {34735, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, names[2]},
        {42113, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, names[3]},
    }};
    TIFF* file = TIFFOpen(path.c_str(), "w");
    ASSERT_NE(file, nullptr);
    TIFFMergeFieldInfo(file, fields.data(), fields.size());
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, width);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, std::uint32_t(heights.size()) / width);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, int(8 * sizeof(T)));
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(file, TIFFTAG_SAMPLEFORMAT,
                 std::is_floating_point_v<T> ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_INT);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    const auto set = [&](std::uint32_t tag, const auto& values) {
        if (!values.empty()) TIFFSetField(file, tag, int(values.size()), values.data());
    };
    set(33550, options.pixel_scale);
    set(34264, options.transformation);
    if (!options.geo_keys.empty()) {
        // The header: version 1.1.0 and the number of keys.
        std::vector<std::uint16_t> directory{1, 1, 0,
                                             std::uint16_t(options.geo_keys.size() / 4)};
        directory.insert(directory.end(), options.geo_keys.begin(), options.geo_keys.end());
        set(34735, directory);
    }
    if (!options.no_data.empty()) TIFFSetField(file, 42113, options.no_data.c_str());
    std::vector<T> rows = heights;
    for (std::uint32_t j = 0; j < heights.size() / width; ++j) {
        ASSERT_EQ(TIFFWriteScanline(file, &rows[j * width], j, 0), 1);
    }
    TIFFClose(file);
}

/// 16-bit signed heights.
inline void WriteGeoTiff(const std::filesystem::path& path, std::uint32_t width,
                         const std::vector<std::int16_t>& heights,
                         const GeoTiffOptions& options) {
    WriteGeoTiffOf(path, width, heights, options);
}

}  // namespace plumb
