// A disk that is full, a file that may not grow, a standard output that takes nothing: status 3, and
// old results stay as they were.
#include <gmock/gmock.h>
#include <sys/mount.h>

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>

#include "core/random.h"
#include "tests/faults/program.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;

// At the smallest size, of each what writes large files.
constexpr const char* kWriters[] = {
    "simulate make:bricks:32 --slices 4 --out out",
    "fit make:bricks:24 make:cobbles:24 --slices 4 --no-studies --bootstrap 0 --starts 1 --out "
    "out",
    "truth wedge --width 64 --height 64 --spp 64 --out out",
    "truth wedge --facets --spp 16 --out out",
    "render wedge --width 64 --height 64 --technique gtao-xegtao --out out",
    "report wedge --width 64 --height 36 --spp 16 --rounds 1 --no-studies --technique "
    "gtao-xegtao "
    "--out out",
    "score a.pfm b.pfm --out out",
};

/// A picture of noise, which no format makes small.
std::string Noise(int width, int height, std::uint64_t seed) {
    std::string bytes =
        "Pf\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1\n";
    for (int p = 0; p < width * height; ++p) {
        const float value = float(RandomUnit(seed, std::uint64_t(p), 0, 0));
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    return bytes;
}

class Writers : public TempFolder, public testing::WithParamInterface<const char*> {
  protected:
    void SetUp() override {
        Put("a.pfm", Noise(64, 64, 1));
        Put("b.pfm", Noise(64, 64, 2));
    }

    void ExpectStatus3(const Ended& ended, const char* words) {
        EXPECT_EQ(ended.status, 3) << ended.errors;
        EXPECT_THAT(ended.errors, HasSubstr(words));
        EXPECT_THAT(PartsBelow(folder_), IsEmpty());
    }
};

// ulimit -f: the system's signal would kill.
TEST_P(Writers, AFileThatMayNotGrowIsStatus3) {
    ExpectStatus3(RunPlumb(Words(GetParam()), {.folder = folder_, .file_bytes = 1000}),
                  "File too large");
}

TEST_P(Writers, AFullDiskIsStatus3AndOldResultsStay) {
    fs::create_directory(Path("out"));
    if (mount("none", Path("out").c_str(), "tmpfs", 0, "size=16k") != 0) {
        GTEST_SKIP() << "no right to mount a small disk";
    }
    Put("out/report.json", "old");
    Put("out/truth.exr", "old");
    ExpectStatus3(RunPlumb(Words(GetParam()), {.folder = folder_}), "No space left on device");
    EXPECT_EQ(Get("out/report.json"), "old");
    EXPECT_EQ(Get("out/truth.exr"), "old");
    umount(Path("out").c_str());
}

INSTANTIATE_TEST_SUITE_P(Every, Writers, testing::ValuesIn(kWriters));

class Talkers : public TempFolder, public testing::WithParamInterface<const char*> {};

TEST_P(Talkers, AStandardOutputThatTakesNothingIsStatus3) {
    Put("a.pfm", Noise(8, 8, 1));
    const Ended ended =
        RunPlumb(Words(GetParam()), {.folder = folder_, .standard_output = "/dev/full"});
    EXPECT_EQ(ended.status, 3);
    EXPECT_THAT(ended.errors, HasSubstr("standard output: cannot write"));
}

constexpr const char* kTalkers[] = {
    "--help",
    "--version",
    "truth --help",
    "simulate make:bricks:16 --slices 4 --json",
    "simulate make:bricks:16 --slices 4",
    "fit make:bricks:24 make:cobbles:24 --slices 4 --no-studies --bootstrap 0 --starts 1 "
    "--json",
    "truth wedge --width 16 --height 16 --spp 64 --json",
    "truth wedge --facets --spp 16",
    "render wedge --width 16 --height 16 --technique gtao-paper",
    "report wedge --width 64 --height 36 --spp 16 --rounds 1 --no-studies --technique "
    "gtao-xegtao "
    "--json",
    "bench raster wedge --width 32 --height 32 --rounds 5 --json",
    "score a.pfm a.pfm",
    "score a.pfm a.pfm --json",
    "bench score --width 32 --height 32",
};

INSTANTIATE_TEST_SUITE_P(Every, Talkers, testing::ValuesIn(kTalkers));

}  // namespace
}  // namespace plumb
