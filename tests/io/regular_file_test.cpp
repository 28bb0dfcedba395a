#include "io/regular_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "core/error.h"
#include "io/side_file.h"
#include "io/whole_file.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::HasSubstr;

class RegularFile : public TempFolder {
  protected:
    std::filesystem::path Loop() const {
        std::filesystem::create_symlink("loop", Path("loop"));
        return Path("loop");
    }
    std::filesystem::path Pipe() const {
        EXPECT_EQ(mkfifo(Path("pipe").c_str(), 0600), 0);
        return Path("pipe");
    }
};

TEST_F(RegularFile, HasASize) {
    EXPECT_EQ(RegularFileSize(Put("a", "12345")), 5u);
}

TEST_F(RegularFile, NothingElseIsRead) {
    const auto complaint = [](const std::filesystem::path& path) {
        return MessageOf<Error>([&] { ReadWholeFile(path); });
    };
    EXPECT_EQ(complaint(Pipe()),
              Path("pipe").string() + ": cannot be read: is a pipe, must be a regular file");
    EXPECT_THAT(complaint(folder_), HasSubstr("is a folder"));
    EXPECT_THAT(complaint("/dev/zero"), HasSubstr("is a device"));
    EXPECT_THAT(complaint(Loop()), HasSubstr("Too many levels of symbolic links"));
    EXPECT_THAT(complaint(Path(std::string(300, 'n'))), HasSubstr("File name too long"));
    EXPECT_THAT(complaint(Put("a", "") / "b"), HasSubstr("Not a directory"));
}

TEST_F(RegularFile, IsThereOrNotWithoutExceptionsOfTheLibrary) {
    EXPECT_TRUE(IsThere(Put("a", "")));
    EXPECT_TRUE(IsThere(folder_));
    EXPECT_TRUE(IsThere(Pipe()));
    EXPECT_FALSE(IsThere(Path("none")));
    EXPECT_FALSE(IsThere(Path("a") / "b"));
    EXPECT_FALSE(IsThere(Path(std::string(300, 'n'))));
    EXPECT_THAT(MessageOf<Error>([&] { IsThere(Loop()); }),
                HasSubstr("loop: cannot be read: "));
}

// The name of an image may be the longest there is; its side file's would be longer.
TEST_F(RegularFile, ALongNameHasNoSideFile) {
    EXPECT_FALSE(ReadSideFile(Path(std::string(252, 'n') + ".x")).name.has_value());
}

TEST_F(RegularFile, TheLongestNameCanBeWritten) {
    const std::string name(255, 'n');
    WriteWholeFile(Path(name), "text");
    EXPECT_EQ(Get(name), "text");
    EXPECT_THAT(MessageOf<MachineError>([&] { WriteWholeFile(Path(name + "n"), ""); }),
                HasSubstr("File name too long"));
    EXPECT_EQ(FileCount(), 1);
    EXPECT_THAT(MessageOf<MachineError>([&] { WriteWholeFile(Loop() / "a", ""); }),
                HasSubstr("Too many levels of symbolic links"));
}

}  // namespace
}  // namespace plumb
