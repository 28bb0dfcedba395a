// What stands where a file or a folder should: the program says so, and never waits for it.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <ostream>

#include "tests/faults/program.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

struct Odd {
    const char* line;
    int status;
    const char* words;
};

void PrintTo(const Odd& odd, std::ostream* out) {
    *out << odd.line;
}

class FileSystems : public TempFolder, public testing::WithParamInterface<Odd> {
  protected:
    FileSystems() {
        for (const char* ending :
             {"png", "tif", "exr", "pfm", "json", "csv", "obj", "ply", "glb"}) {
            const std::string tail = std::string(".") + ending;
            EXPECT_EQ(mkfifo(Path("pipe" + tail).c_str(), 0666), 0);
            fs::create_directory(Path("folder" + tail));
            fs::create_symlink("loop" + tail, Path("loop" + tail));
            fs::create_symlink("/dev/zero", Path("zero" + tail));
            fs::create_symlink("gone" + tail, Path("broken" + tail));
            // A scene file for each mesh: SCENE_KIND_ENDING.json.
            for (const char* kind : {"pipe", "folder", "loop", "zero", "broken"}) {
                Put(std::string("mesh_") + kind + "_" + ending + ".json",
                    R"({"meshes": [{"file": ")" + (kind + tail) + R"("}]})");
            }
        }
        Put("file", "");
        fs::create_directory(Path("locked"));
        Put("locked/map.png", "");
        fs::permissions(Path("locked"), fs::perms::none);
        fs::create_directory(Path("read_only"));
        fs::permissions(Path("read_only"), fs::perms::owner_read | fs::perms::owner_exec |
                                               fs::perms::others_read | fs::perms::others_exec);
        fs::permissions(folder_, fs::perms::all);
    }
    ~FileSystems() override { fs::permissions(Path("locked"), fs::perms::all); }
};

TEST_P(FileSystems, AreTold) {
    const Ended ended =
        RunPlumb(Words(GetParam().line), {.folder = folder_, .as_nobody = true}, 20);
    EXPECT_FALSE(ended.was_killed) << "after " << ended.clock_s << " s";
    EXPECT_EQ(ended.status, GetParam().status) << ended.errors;
    EXPECT_THAT(ended.errors, HasSubstr(GetParam().words));
    EXPECT_THAT(PartsBelow(folder_), testing::IsEmpty());
    EXPECT_FALSE(fs::exists(Path("out")));
}

constexpr Odd kMaps[] = {
    {"simulate pipe.png", 2, "is a pipe"},
    {"simulate folder.png", 2, "is a folder"},
    {"simulate loop.png", 2, "Too many levels"},
    {"simulate zero.png", 2, "is a device"},
    {"simulate broken.png", 2, "No such file"},
    {"simulate pipe.tif", 2, "is a pipe"},
    {"simulate zero.tif", 2, "is a device"},
    {"simulate folder.exr", 2, "is a folder"},
    {"simulate zero.pfm", 2, "is a device"},
    {"simulate locked/map.png", 2, "Permission denied"},
    {"simulate file/map.png", 2, "Not a directory"},
    {"simulate make:bricks:16 --albedo-map zero.png", 2, "is a device"},
    {"simulate make:bricks:16 --albedo-map folder.png", 2, "folder.png"},
    {"fit zero.png", 2, "is a device"},
    {"fit --histogram zero.csv", 2, "is a device"},
    {"fit --histogram pipe.csv", 2, "is a pipe"},
    {"fit --histogram folder.csv", 2, "folder.csv"},
    {"bench light loop.png", 2, "Too many levels"},
};

constexpr Odd kScenes[] = {
    {"truth pipe.json", 2, "is a pipe"},
    {"truth folder.json", 2, "is a folder"},
    {"truth loop.json", 2, "Too many levels"},
    {"render zero.json", 2, "is a device"},
    {"report broken.json", 2, "No such file"},
    {"bench raster pipe.json", 2, "is a pipe"},
    {"bench truth zero.json", 2, "is a device"},
    {"bench ao folder.json", 2, "is a folder"},
    {"truth mesh_pipe_obj.json", 2,
     "mesh_pipe_obj.json: meshes[0].file: pipe.obj: cannot be read"},
    {"truth mesh_zero_obj.json", 2, "is a device"},
    {"truth mesh_folder_obj.json", 2, "is a folder"},
    {"truth mesh_loop_obj.json", 2, "Too many levels"},
    {"truth mesh_broken_obj.json", 2, "No such file"},
    {"truth mesh_pipe_ply.json", 2, "is a pipe"},
    {"truth mesh_zero_ply.json", 2, "is a device"},
    {"render mesh_zero_glb.json", 2, "is a device"},
    {"report mesh_pipe_glb.json", 2, "is a pipe"},
};

// Where results cannot go is known before they are made.
constexpr Odd kOutputs[] = {
    {"simulate make:bricks:16 --slices 4 --out file", 3, "--out file"},
    {"simulate make:bricks:16 --slices 4 --out file/below", 3, "--out file/below"},
    {"simulate make:bricks:16 --slices 4 --out pipe.png", 3, "--out pipe.png"},
    {"simulate make:stone_wall:512 --slices 65536 --out read_only", 3, "Permission denied"},
    {"simulate make:stone_wall:512 --slices 65536 --out read_only/below", 3,
     "Permission denied"},
    {"simulate make:bricks:16 --slices 4 --out locked/below", 3, "Permission denied"},
    {"truth atrium --spp 65536 --out loop.png", 3, "Too many levels"},
    {"truth atrium --spp 65536 --out read_only", 3, "read_only"},
    {"render atrium --out read_only", 3, "read_only"},
    {"report atrium --out read_only", 3, "read_only"},
    {"fit make:bricks:256 --out read_only", 3, "read_only"},
    {"bench light make:bricks:256 --out read_only", 3, "read_only"},
    {"bench raster wedge --out read_only", 3, "read_only"},
    {"bench truth wedge --out read_only", 3, "read_only"},
    {"bench ao wedge --out read_only", 3, "read_only"},
    {"truth wedge --width 16 --height 16 --spp 64 --cache file", 3, "file"},
    {"truth wedge --width 16 --height 16 --spp 64 --cache loop.png", 3, "Too many levels"},
    {"truth wedge --width 16 --height 16 --spp 64 --cache read_only", 3, "Permission denied"},
};

INSTANTIATE_TEST_SUITE_P(Maps, FileSystems, testing::ValuesIn(kMaps));
INSTANTIATE_TEST_SUITE_P(Scenes, FileSystems, testing::ValuesIn(kScenes));
INSTANTIATE_TEST_SUITE_P(Outputs, FileSystems, testing::ValuesIn(kOutputs));

class Names : public TempFolder {};

TEST_F(Names, TooLongForTheSystemAreTold) {
    const std::string name(300, 'n');
    for (const std::string& line : {"simulate " + name + ".png", "truth " + name + ".json",
                                    "fit --histogram " + name + ".csv"}) {
        const Ended ended = RunPlumb(Words(line), {.folder = folder_}, 20);
        EXPECT_EQ(ended.status, 2) << ended.errors;
        EXPECT_THAT(ended.errors, HasSubstr(name));
    }
    const Ended ended = RunPlumb(Words("simulate make:bricks:16 --slices 4 --out " + name),
                                 {.folder = folder_}, 20);
    EXPECT_EQ(ended.status, 3) << ended.errors;
    EXPECT_THAT(ended.errors, HasSubstr("File name too long"));
}

// A folder in the cache that has the name of a state.
TEST_F(Names, AFolderInPlaceOfAStateIsTold) {
    const auto line =
        Words("truth wedge --width 16 --height 16 --spp 64 --out out --cache states");
    ASSERT_EQ(RunPlumb(line, {.folder = folder_}).status, 0);
    for (const auto& state : fs::directory_iterator(Path("states"))) {
        const fs::path path = state.path();
        fs::remove(path);
        fs::create_directory(path);
    }
    const Ended ended = RunPlumb(line, {.folder = folder_}, 20);
    EXPECT_EQ(ended.status, 2) << ended.errors;
    EXPECT_THAT(ended.errors, HasSubstr("is a folder"));
}

}  // namespace
}  // namespace plumb
