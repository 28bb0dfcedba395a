#include "io/open_tiff.h"

#include <tiffio.h>

#include "core/error.h"

namespace plumb {
namespace {

int SayNothing(TIFF*, void*, const char*, const char*, va_list) {
    return 1;
}

}  // namespace

std::shared_ptr<tiff> OpenTiff(const std::filesystem::path& path) {
    TIFFOpenOptions* options = TIFFOpenOptionsAlloc();
    // Unknown tags are no news, and errors are told by exceptions.
    TIFFOpenOptionsSetErrorHandlerExtR(options, SayNothing, nullptr);
    TIFFOpenOptionsSetWarningHandlerExtR(options, SayNothing, nullptr);
    TIFF* file = TIFFOpenExt(path.c_str(), "r", options);
    TIFFOpenOptionsFree(options);
    if (file == nullptr) {
        throw Error(path.string() +
                    ": cannot be read, its TIFF directory is missing or damaged");
    }
    return {file, TIFFClose};
}

}  // namespace plumb
