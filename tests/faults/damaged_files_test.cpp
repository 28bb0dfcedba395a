// Files whose readers would take the machine with them.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <csignal>

#include "tests/faults/program.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::HasSubstr;

class DamagedFiles : public TempFolder {
  protected:
    std::vector<std::string> TruthOf(const std::string& mesh) const {
        Put("scene.json", R"({"meshes": [{"file": ")" + mesh +
                              R"("}], "cameras": [{"position_m": [0, -3, 1],
                                 "target_m": [0, 0, 0], "fov_deg": 60}]})");
        return Words("truth scene.json --width 8 --height 8 --spp 64 --out out");
    }

    // A triangle as Collada, whose array of numbers claims a length.
    std::string Collada(const std::string& count) const {
        return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="p">
<float_array id="pa" count=")" +
               count + R"(">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>
</source><vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries><library_visual_scenes><visual_scene id="s"><node>
<instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
    }
};

TEST_F(DamagedFiles, AColladaThatClaims4GigabytesIsRefused) {
    Put("good.dae", Collada("9"));
    EXPECT_EQ(RunPlumb(TruthOf("good.dae"), {.folder = folder_}).status, 0);
    Put("bad.dae", Collada("1000000000"));
    const Ended ended = RunPlumb(TruthOf("bad.dae"), {.folder = folder_}, 300);
    EXPECT_EQ(ended.status, 2) << ended.errors;
    EXPECT_THAT(ended.errors, HasSubstr("scene.json: meshes[0].file: bad.dae: is damaged"));
#ifndef __SANITIZE_ADDRESS__
    EXPECT_THAT(ended.errors, HasSubstr("MiB"));
#endif
}

constexpr const char* kWaits =
    "mtllib pipe.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl cloth\nf 1 2 3\n";

TEST_F(DamagedFiles, AMeshThatWaitsForAPipeIsRefusedInTime) {
    ASSERT_EQ(mkfifo(Path("pipe.mtl").c_str(), 0666), 0);
    Put("waits.obj", kWaits);
    const Ended ended = RunPlumb(TruthOf("waits.obj"), {.folder = folder_}, 300);
    EXPECT_EQ(ended.status, 2) << ended.errors;
    EXPECT_THAT(ended.errors, HasSubstr("waits.obj: is damaged, or waits"));
}

// While the child is at it: the mesh is not to blame.
TEST_F(DamagedFiles, AnInterruptWhileAMeshIsReadIsAnInterrupt) {
    ASSERT_EQ(mkfifo(Path("pipe.mtl").c_str(), 0666), 0);
    Put("waits.obj", kWaits);
    for (const int signal : {SIGINT, SIGTERM}) {
        Program program(TruthOf("waits.obj"), {.folder = folder_});
        ASSERT_TRUE(program.HasAChild());
        program.Send(signal);
        // Not the child's own end by its limits: that has another status.
        const Ended ended = program.Wait(300);
        EXPECT_EQ(ended.status, 130) << ended.errors;
    }
}

}  // namespace
}  // namespace plumb
