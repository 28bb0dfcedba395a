#include "io/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <system_error>

#include "core/error.h"
#include "io/regular_file.h"
#include "io/short_name.h"

namespace plumb {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void Fail(const fs::path& path, const std::string& what, int error) {
    throw MachineError(path.string() + ": " + what + ": " + std::strerror(error));
}

/// An open file that is closed when its owner goes.
class Descriptor {
  public:
    Descriptor(const fs::path& path, int flags) : fd_(open(path.c_str(), flags, 0666)) {}
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    bool IsOpen() const { return fd_ >= 0; }
    int Get() const { return fd_; }

    /// 0 or the error: some file systems report a full disk only here.
    int Close() {
        const int status = close(fd_);
        fd_ = -1;
        return status == 0 ? 0 : errno;
    }

  private:
    int fd_;
};

void WriteAll(const Descriptor& file, std::string_view bytes, const fs::path& path) {
    while (!bytes.empty()) {
        const ssize_t written = write(file.Get(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) Fail(path, "cannot write", errno);
        bytes.remove_prefix(std::size_t(written));
    }
}

/// The file beside the target: removed unless it took the target's name.
class PartFile {
  public:
    explicit PartFile(const fs::path& target) : target_(target), part_(FreeName(target)) {}
    ~PartFile() {
        if (!committed_) unlink(part_.c_str());
    }
    PartFile(const PartFile&) = delete;
    PartFile& operator=(const PartFile&) = delete;

    void WriteAndCommit(std::string_view bytes) {
        Descriptor file(part_, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC);
        if (!file.IsOpen()) Fail(target_, "cannot create", errno);
        WriteAll(file, bytes, target_);
        if (fsync(file.Get()) != 0) Fail(target_, "cannot write", errno);
        if (const int error = file.Close()) Fail(target_, "cannot write", error);
        if (rename(part_.c_str(), target_.c_str()) != 0) Fail(target_, "cannot replace", errno);
        committed_ = true;
        // The name itself is on the disk only once the folder is. Not every file system can.
        const Descriptor folder(target_.parent_path(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (folder.IsOpen()) fsync(folder.Get());
    }

  private:
    static fs::path FreeName(const fs::path& target) {
        // What is appended must not be what makes the name too long.
        static std::atomic<int> serial = 0;
        const std::string name = target.filename().string().substr(0, kMostOfName);
        fs::path part = target;
        std::error_code ignored;
        do {
            part.replace_filename(name + ".part" + std::to_string(getpid()) + "-" +
                                  std::to_string(++serial));
        } while (fs::exists(part, ignored));
        return part;
    }

    fs::path target_, part_;
    bool committed_ = false;
};

/// The file that `path` means: links followed, folders made.
fs::path Target(const fs::path& path) {
    if (path.filename().empty()) throw MachineError(path.string() + ": names no file");
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    fs::path target;
    if (!error) target = fs::weakly_canonical(absolute, error);
    if (!error) fs::create_directories(target.parent_path(), error);
    if (error) {
        throw MachineError(path.string() + ": cannot make its folder: " + error.message());
    }
    return target;
}

bool IsDeviceOrPipe(const fs::path& target) {
    std::error_code ignored;
    const fs::file_status status = fs::status(target, ignored);
    return fs::exists(status) && fs::is_other(status);
}

}  // namespace

void WriteWholeFile(const fs::path& path, std::string_view bytes) {
    if (IsDeviceOrPipe(path)) {
        Descriptor file(path, O_WRONLY | O_CLOEXEC);
        if (!file.IsOpen()) Fail(path, "cannot open", errno);
        WriteAll(file, bytes, path);
        if (const int error = file.Close()) Fail(path, "cannot write", error);
    } else {
        PartFile(Target(path)).WriteAndCommit(bytes);
    }
}

std::string ReadWholeFile(const fs::path& path) {
    const Descriptor file(OpenRegularFile(path));
    std::string bytes;
    std::string block(1 << 16, '\0');
    for (ssize_t n = 1; n > 0;) {
        n = read(file.Get(), block.data(), block.size());
        if (n < 0 && errno == EINTR) {
            n = 1;
            continue;
        }
        if (n < 0) throw Error(path.string() + ": cannot be read: " + std::strerror(errno));
        bytes.append(block.data(), std::size_t(n));
    }
    return bytes;
}

}  // namespace plumb
