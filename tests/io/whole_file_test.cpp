#include "io/whole_file.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>

#include "core/error.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

using WholeFile = TempFolder;

TEST_F(WholeFile, ReadsBackEveryByte) {
    std::string bytes(100'000, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = char(i * i);
    WriteWholeFile(Path("a.bin"), bytes);
    EXPECT_EQ(ReadWholeFile(Path("a.bin")), bytes);
    EXPECT_EQ(FileCount(), 1);
}

TEST_F(WholeFile, ReplacesWhatWasThere) {
    Put("a.txt", "something longer");
    WriteWholeFile(Path("a.txt"), "new");
    EXPECT_EQ(Get("a.txt"), "new");
    WriteWholeFile(Path("a.txt"), "");
    EXPECT_EQ(Get("a.txt"), "");
}

TEST_F(WholeFile, MakesTheFolders) {
    WriteWholeFile(Path("x/y/a.txt"), "text");
    EXPECT_EQ(Get("x/y/a.txt"), "text");
}

TEST_F(WholeFile, FollowsALink) {
    Put("target.txt", "old");
    std::filesystem::create_symlink("target.txt", Path("link.txt"));
    WriteWholeFile(Path("link.txt"), "new");
    EXPECT_EQ(Get("target.txt"), "new");
    EXPECT_TRUE(std::filesystem::is_symlink(Path("link.txt")));
}

TEST_F(WholeFile, HasThePermissionsOfAnyNewFile) {
    const mode_t mask = umask(027);
    WriteWholeFile(Path("a.txt"), "");
    umask(mask);
    EXPECT_EQ(int(std::filesystem::status(Path("a.txt")).permissions()), 0640);
}

/// Files may not grow beyond a size while it lives: a full disk that needs no disk.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes) {
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        getrlimit(RLIMIT_FSIZE, &old_);
        rlimit limit = old_;
        limit.rlim_cur = bytes;
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    rlimit old_{};
    void (*handler_)(int) = nullptr;
};

TEST_F(WholeFile, AFullDiskLeavesTheOldFileAndNothingElse) {
    Put("a.txt", "old");
    const std::string message = [&] {
        const FileSizeLimit limit(4096);
        return MessageOf<MachineError>(
            [&] { WriteWholeFile(Path("a.txt"), std::string(10'000, 'x')); });
    }();
    EXPECT_EQ(message, Path("a.txt").string() + ": cannot write: File too large");
    EXPECT_EQ(Get("a.txt"), "old");
    EXPECT_EQ(FileCount(), 1);
}

TEST_F(WholeFile, AFullDeviceIsTold) {
    EXPECT_THAT(MessageOf<MachineError>([] { WriteWholeFile("/dev/full", "text"); }),
                StartsWith("/dev/full: cannot write: No space left"));
}

TEST_F(WholeFile, ADeviceIsWrittenToAndNotReplaced) {
    WriteWholeFile("/dev/null", "text");
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(WholeFile, AFolderInTheWayIsTold) {
    std::filesystem::create_directories(Path("a.txt/full"));
    EXPECT_THAT(MessageOf<MachineError>([&] { WriteWholeFile(Path("a.txt"), "text"); }),
                HasSubstr("a.txt: cannot replace: "));
    EXPECT_EQ(FileCount(), 1);
}

TEST_F(WholeFile, AFileInPlaceOfAFolderIsTold) {
    Put("x", "");
    EXPECT_THAT(MessageOf<MachineError>([&] { WriteWholeFile(Path("x/a.txt"), "text"); }),
                HasSubstr("x/a.txt: cannot make its folder: "));
}

TEST_F(WholeFile, ANameIsNeeded) {
    EXPECT_THROW(WriteWholeFile("", "text"), MachineError);
    EXPECT_THROW(WriteWholeFile(Path("x/"), "text"), MachineError);
}

TEST_F(WholeFile, ReadingNamesTheFileAndTheReason) {
    EXPECT_EQ(MessageOf<Error>([&] { ReadWholeFile(Path("none.txt")); }),
              Path("none.txt").string() + ": cannot be read: No such file or directory");
    EXPECT_EQ(MessageOf<Error>([&] { ReadWholeFile(folder_); }),
              folder_.string() + ": cannot be read: is a folder, must be a regular file");
}

}  // namespace
}  // namespace plumb
