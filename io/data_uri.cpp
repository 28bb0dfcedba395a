#include "io/data_uri.h"

#include <OpenImageIO/strutil.h>

#include "io/whole_file.h"

namespace plumb {

std::string PngDataUri(const std::filesystem::path& path) {
    return "data:image/png;base64," + OIIO::Strutil::base64_encode(ReadWholeFile(path));
}

}  // namespace plumb
