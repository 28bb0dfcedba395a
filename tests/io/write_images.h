// Image files as other programs write them, for the readers to be tried on.
#pragma once

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace plumb {

/// Stores `numbers`, interleaved, as they are in the type T. `channels` gives the names.
template <class T>
void WriteStored(const std::filesystem::path& path, int width, int height,
                 const std::vector<std::string>& channels, const std::vector<T>& numbers,
                 const std::string& compression = "") {
    OIIO::ImageSpec spec(width, height, int(channels.size()), OIIO::BaseTypeFromC<T>::value);
    spec.channelnames = channels;
    if (!compression.empty()) spec.attribute("compression", compression);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    const auto output = OIIO::ImageOutput::create(path.string());
    ASSERT_TRUE(output && output->open(path.string(), spec)) << OIIO::geterror();
    ASSERT_TRUE(output->write_image(spec.format, numbers.data())) << output->geterror();
    ASSERT_TRUE(output->close());
}

}  // namespace plumb
