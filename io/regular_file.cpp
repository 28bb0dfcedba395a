#include "io/regular_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

#include "core/error.h"

namespace plumb {
namespace {

[[noreturn]] void Fail(const std::filesystem::path& path, const std::string& why) {
    throw Error(path.string() + ": cannot be read: " + why);
}

void CheckIsRegular(const std::filesystem::path& path, const struct stat& found) {
    const mode_t mode = found.st_mode;
    if (S_ISREG(mode)) return;
    const char* what = S_ISDIR(mode)    ? "a folder"
                       : S_ISFIFO(mode) ? "a pipe"
                       : S_ISSOCK(mode) ? "a socket"
                                        : "a device";
    Fail(path, std::string("is ") + what + ", must be a regular file");
}

}  // namespace

bool IsThere(const std::filesystem::path& path) {
    struct stat found {};
    if (stat(path.c_str(), &found) == 0) return true;
    if (errno == ENOENT || errno == ENOTDIR || errno == ENAMETOOLONG) return false;
    Fail(path, std::strerror(errno));
}

int OpenRegularFile(const std::filesystem::path& path) {
    struct stat found {};
    // Before it is opened: to open a device can do something.
    if (stat(path.c_str(), &found) != 0) Fail(path, std::strerror(errno));
    CheckIsRegular(path, found);
    const int file = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) Fail(path, std::strerror(errno));
    return file;
}

std::uintmax_t RegularFileSize(const std::filesystem::path& path) {
    const int file = OpenRegularFile(path);
    struct stat found {};
    const int status = fstat(file, &found);
    const int error = errno;
    close(file);
    if (status != 0) Fail(path, std::strerror(error));
    return std::uintmax_t(found.st_size);
}

}  // namespace plumb
