#include "io/far_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/mesh_io.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::Contains;
using testing::HasSubstr;

// By hand: 16 times the extent is near enough, more is not; steps of the next power of two.
TEST(FarMesh, OriginIsTheMiddleInStepsOfTheExtent) {
    EXPECT_EQ(OriginFor({-1, -1, 0}, {1, 1, 1}), Vec3(0, 0, 0));
    EXPECT_EQ(OriginFor({31, 0, 0}, {33, 1, 1}), Vec3(0, 0, 0));
    EXPECT_EQ(OriginFor({32, 0, 0}, {34.1, 1, 1}), Vec3(0, 0, 0));
    EXPECT_EQ(OriginFor({34, 0, 0}, {36, 1, 1}), Vec3(36, 0, 0));
    EXPECT_EQ(OriginFor({500000, 5400000, 10}, {500003, 5400002, 11}),
              Vec3(500000, 5400000, 12));
    EXPECT_EQ(OriginFor({7, 7, 7}, {7, 7, 7}), Vec3(0, 0, 0));  // No extent, no scale.
}

// By hand: digits that floats lose (5400000.123 has steps of 1/2) stay; all else does.
TEST(FarMesh, MovesVerticesOfTextAndNothingElse) {
    const std::string obj =
        "mtllib a.mtl\r\nv 500000.125 +5400000.25 10 1 0 0\n\tv 500001 5400001 1e1\nvn 0 0 1\n"
        "vt 500000 0\nf 1 2 1\nv 500000 5400001 11";
    const auto near = BringNear(obj);
    ASSERT_TRUE(near);
    EXPECT_EQ(near->origin, Vec3(500001, 5400001, 11));  // The middle is at halves.
    EXPECT_EQ(
        near->text,
        "mtllib a.mtl\r\nv -0.875 -0.75 -1 1 0 0\nv 0 0 -1\nvn 0 0 1\nvt 500000 0\nf 1 2 1\n"
        "v -1 0 0");
    EXPECT_FALSE(BringNear("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"));
    EXPECT_FALSE(BringNear("v 500000 oops 0\nv 500001 0 0\n"));
    EXPECT_FALSE(BringNear("v 500000 nan 0\nv 500001 0 0\n"));
    EXPECT_FALSE(BringNear(""));
}

class FarFiles : public TempFolder {};

// Expected: the file's own differences, exactly: 1/8 m at 5.4e6 m, in inches and with y up too.
TEST_F(FarFiles, KeepTheDigitsOfObj) {
    Put("far.obj",
        "v 500000.125 5400000 0\nv 500001 5400000 0\nv 500000 5400001.375 0\nf 1 2 3\n");
    const MeshFile z = ReadMesh(Path("far.obj"), {.up = UpAxis::kZ});
    ASSERT_EQ(z.mesh.vertices_m.size(), 3u);
    const auto& v = z.mesh.vertices_m;
    EXPECT_EQ(v[1].x() - v[0].x(), 0.875f);
    EXPECT_EQ(v[2].y() - v[0].y(), 1.375f);
    EXPECT_LT(v[2].norm(), 4);
    EXPECT_EQ(v[0].cast<double>() + z.origin_m, Vec3(500000.125, 5400000, 0));
    const MeshFile y = ReadMesh(Path("far.obj"), {.unit_m = 0.5});
    EXPECT_EQ(y.mesh.vertices_m[0].cast<double>() + y.origin_m, Vec3(250000.0625, 0, 2700000));
}

// What a reader of floats has rounded is told.
TEST_F(FarFiles, SayWhatIsRounded) {
    Put("far.ply",
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
        "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        "500000 5400000 0\n500001 5400000 0\n500000 5400001 0\n3 0 1 2\n");
    const MeshFile far = ReadMesh(Path("far.ply"), {.up = UpAxis::kZ});
    EXPECT_THAT(far.notes, Contains(HasSubstr("rounded to steps of about 0.64")));
    EXPECT_LT(far.mesh.vertices_m[0].norm(), 4);
    EXPECT_EQ(far.mesh.vertices_m[1].x() - far.mesh.vertices_m[0].x(), 1);
}

}  // namespace
}  // namespace plumb
