#include "io/scene_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "core/error.h"
#include "io/image_io.h"
#include "io/mesh_io.h"

namespace plumb {
namespace {

class SceneFiles : public testing::Test {
  protected:
    SceneFiles()
        : folder_(std::filesystem::path(PLUMB_BINARY_DIR) / "scene_files" /
                  testing::UnitTest::GetInstance()->current_test_info()->name()) {
        std::filesystem::create_directories(folder_);
    }

    std::filesystem::path Write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name) << text;
        return folder_ / name;
    }

    /// What reading a scene of this text complains of, without the folder's name.
    std::string Complaint(const std::string& text) const {
        try {
            ReadSceneFile(Write("scene.json", text));
        } catch (const Error& error) {
            std::string message = error.what();
            const std::string folder = folder_.string() + "/";
            for (std::size_t at; (at = message.find(folder)) != std::string::npos;) {
                message.erase(at, folder.size());
            }
            return message;
        }
        return "none";
    }

    std::filesystem::path folder_;
};

constexpr const char* kCamera = R"("position_m": [0, -3, 1], "target_m": [0, 0, 0])";

std::string WithCamera(const std::string& more) {
    return std::string(R"({"generator": "box_on_plane", "cameras": [{)") + kCamera + ", " +
           more + "}]}";
}

// A square of 2 x 2 in the plane y = 0 (up is y), of two materials.
constexpr const char* kObj =
    "mtllib square.mtl\nv -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\n"
    "usemtl red\nf 1 4 3\nusemtl grey\nf 1 3 2\n";
constexpr const char* kMtl = "newmtl red\nKd 0.5 0.1 0.1\nnewmtl grey\nKd 0.25 0.25 0.25\n";

TEST_F(SceneFiles, ReadEveryField) {
    Write("square.obj", kObj);
    Write("square.mtl", kMtl);
    const SceneFile file = ReadSceneFile(Write("all.json", R"({
        "name": "everything",
        "meshes": [{"file": "square.obj", "unit_m": 0.01, "up": "y"},
                   {"file": "square.obj", "up": "z", "albedo": [0.1, 0.2, 0.3]}],
        "sky": [1, 2, 3],
        "directional_lights": [{"towards": [0, 0, 2], "irradiance": [4, 5, 6]}],
        "point_lights": [{"position_m": [1, 2, 3], "intensity": [7, 8, 9]}],
        "cameras": [{"name": "front", "position_m": [0, -3, 1], "target_m": [0, 0, 1],
                     "up": [0, 1, 1], "fov_deg": 90, "width_px": 64, "height_px": 32}]
    })"));
    const Scene& scene = file.scene;
    EXPECT_EQ(scene.name, "everything");
    EXPECT_TRUE(file.generator.empty());
    ASSERT_EQ(scene.mesh.quads.size(), 4u);
    Validate(scene);
    // Of the first, y up and centimetres: z = 0 everywhere, 2 cm wide, fronts up.
    const auto corner = [&](std::size_t face, int k) {
        return scene.mesh.vertices_m[scene.mesh.quads[face][std::size_t(k)]];
    };
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(corner(0, k).z(), 0);
        EXPECT_FLOAT_EQ(std::abs(corner(0, k).x()), 0.01f);
        EXPECT_EQ(corner(2, k).y(), 0);
        EXPECT_EQ(std::abs(corner(2, k).z()), 1);
    }
    EXPECT_GT((corner(0, 1) - corner(0, 0)).cross(corner(0, 2) - corner(0, 0)).z(), 0);
    bool red = false;
    for (std::uint32_t t = 0; t < 4; t += 2) {
        red = red || scene.AlbedoOfTriangle(t) == Rgb{0.5f, 0.1f, 0.1f};
    }
    EXPECT_TRUE(red);
    EXPECT_EQ(scene.AlbedoOfTriangle(4), (Rgb{0.1f, 0.2f, 0.3f}));
    EXPECT_EQ(scene.light.sky, (Rgb{1, 2, 3}));
    EXPECT_EQ(scene.light.directional.at(0).irradiance, (Rgb{4, 5, 6}));
    EXPECT_EQ(scene.light.points.at(0).position_m, Vec3(1, 2, 3));
    const Camera& camera = scene.cameras.at(0);
    EXPECT_EQ(camera.name, "front");
    EXPECT_DOUBLE_EQ(camera.fov_rad, std::numbers::pi / 2);
    EXPECT_EQ(camera.width_px, 64);
    EXPECT_EQ(camera.height_px, 32);
    EXPECT_EQ(camera.up, Vec3(0, 1, 1));
    EXPECT_EQ(file.files.size(), 3u);
}

// The example of docs/scenes.md is read to the end, with our files in the place of its own.
TEST_F(SceneFiles, ReadTheExampleOfTheirDocumentation) {
    std::ifstream page(std::filesystem::path(PLUMB_SOURCE_DIR) / "docs" / "scenes.md");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    const std::size_t begin = text.find("```json\n") + 8;
    std::string example = text.substr(begin, text.find("```", begin) - begin);
    Write("square.obj", kObj);
    Write("square.mtl", kMtl);
    WriteExr(folder_ / "sky.exr", {{"Y", Image<float>(2, 1, 1)}});
    for (const auto& [theirs, ours] :
         {std::pair{"sponza.obj", "square.obj"}, std::pair{"plants.glb", "square.obj"},
          std::pair{"old.obj", "square.obj"}, std::pair{"statue.ply", "square.obj"},
          std::pair{"evening.hdr", "sky.exr"}}) {
        const std::size_t at = example.find(theirs);
        ASSERT_NE(at, std::string::npos) << theirs;
        example.replace(at, std::string(theirs).size(), ours);
    }
    const SceneFile file = ReadSceneFile(Write("example.json", example));
    Validate(file.scene);
    EXPECT_EQ(file.scene.mesh.quads.size(), 8u);
    EXPECT_EQ(file.heights.size(), 1u);
    EXPECT_EQ(file.scene.cameras.size(), 1u);
}

TEST_F(SceneFiles, ReadSkiesAndHeights) {
    WriteExr(folder_ / "sky.exr", {{"R", Image<float>(2, 1, 1)},
                                   {"G", Image<float>(2, 1, 2)},
                                   {"B", Image<float>(2, 1, 30)}});
    const SceneFile file = ReadSceneFile(Write("sky.json", R"({
        "heights": [{"file": "map.png", "albedo": [0.1, 0.2, 0.3], "amplitude_m": 0.5, "tiles": 3},
                    {"file": "make:bricks:32"}],
        "environment": "sky.exr", "environment_turn_deg": 90})"));
    EXPECT_EQ(file.scene.light.environment.radiance(1, 0), (Rgb{1, 2, 30}));
    EXPECT_DOUBLE_EQ(file.scene.light.environment.turn_rad, std::numbers::pi / 2);
    EXPECT_TRUE(file.has_light);
    ASSERT_EQ(file.heights.size(), 2u);
    EXPECT_EQ(file.heights[0].name, (folder_ / "map.png").string());
    EXPECT_EQ(file.heights[0].albedo, (Rgb{0.1f, 0.2f, 0.3f}));
    EXPECT_EQ(file.heights[0].amplitude_m, 0.5);
    EXPECT_EQ(file.heights[0].tiles, 3);
    EXPECT_EQ(file.heights[1].name, "make:bricks:32");
    EXPECT_EQ(file.heights[1].tiles, 1);
    EXPECT_EQ(Complaint(R"({"generator": "a", "environment": "gone.exr"})"),
              "scene.json: environment: gone.exr: cannot be read: No such file or directory");
    EXPECT_EQ(Complaint(R"({"generator": "a", "environment_turn_deg": 1})"),
              "scene.json: environment_turn_deg without environment, must have one");
    EXPECT_EQ(Complaint(R"({"heights": [{"file": "a.png", "tiles": 17}]})"),
              "scene.json: heights[0].tiles = 17, must be a whole number in [0, 16]");
    EXPECT_EQ(Complaint(R"({"heights": []})"), "scene.json: heights is empty");
    EXPECT_NE(Complaint(R"({"generator": "a", "heights": [{"file": "a.png"}]})").find("either"),
              std::string::npos);
}

TEST_F(SceneFiles, GiveTechniquesTheirParameters) {
    const SceneFile file = ReadSceneFile(Write("scene.json", R"({"generator": "wedge",
        "techniques": [{"name": "gtao", "radius_m": 0.75, "samples": 32, "filter": false,
                        "spread": "screen"},
                       {"name": "hbao"}]})"));
    ASSERT_EQ(file.techniques.size(), 2u);
    EXPECT_EQ(file.techniques[0].name, "gtao");
    EXPECT_TRUE(file.techniques[0].where.ends_with("scene.json: techniques[0]"));
    const std::map<std::string, std::string> values{
        {"filter", "off"}, {"radius_m", "0.75"}, {"samples", "32"}, {"spread", "screen"}};
    EXPECT_EQ(file.techniques[0].values, values);
    EXPECT_TRUE(file.techniques[1].values.empty());
    const auto complaint = [&](const std::string& technique) {
        return Complaint(R"({"generator": "wedge", "techniques": [)" + technique + "]}");
    };
    EXPECT_EQ(
        complaint(R"({"name": "gtao", "radius_m": [1]})"),
        "scene.json: techniques[0].radius_m = [1], must be a number, a text, true or false");
    EXPECT_EQ(complaint(R"({"radius_m": 1})"), "scene.json: techniques[0].name is missing");
    EXPECT_EQ(complaint(R"({"name": "gtao"}, {"name": "gtao"})"),
              "scene.json: techniques[1].name = gtao, must be named once only");
}

TEST_F(SceneFiles, NameWhatIsWrong) {
    EXPECT_EQ(Complaint(WithCamera(R"("fov_deg": 190)")),
              "scene.json: cameras[0].fov_deg = 190, must be in (0, 180)");
    EXPECT_EQ(Complaint(WithCamera(R"("fov_deg": 0)")),
              "scene.json: cameras[0].fov_deg = 0, must be in (0, 180)");
    EXPECT_EQ(Complaint(WithCamera(R"("fov_deg": 60, "width_px": 0)")),
              "scene.json: cameras[0].width_px = 0, must be a whole number in [1, 65536]");
    EXPECT_EQ(
        Complaint(WithCamera(R"("fov_deg": 60, "height_px": 100000)")),
        "scene.json: cameras[0].height_px = 100000, must be a whole number in [1, 65536]");
    EXPECT_NE(Complaint(WithCamera(R"("fov_deg": 60, "fvo": 1)")).find("unknown field"),
              std::string::npos);
    EXPECT_NE(Complaint(R"({"generator": "a", "mehses": []})").find("unknown field"),
              std::string::npos);
    EXPECT_EQ(Complaint(R"({"name": "x"})"),
              "scene.json: must have either generator, or meshes or heights");
    EXPECT_EQ(Complaint(R"({"meshes": []})"), "scene.json: meshes is empty");
    EXPECT_EQ(
        Complaint(R"({"meshes": [{"file": "gone.obj"}]})"),
        "scene.json: meshes[0].file: gone.obj: cannot be read: No such file or directory");
    EXPECT_EQ(Complaint(R"({"generator": "a", "sky": [1, 2]})"),
              "scene.json: sky has 2 numbers, must have 3");
    EXPECT_NE(Complaint(R"({"generator": "a", "sky": [1, 2, -3]})").find("must be >= 0"),
              std::string::npos);
    EXPECT_NE(Complaint("{\"generator\": ").find("scene.json:"), std::string::npos);
    EXPECT_NE(Complaint("[]").find("scene.json"), std::string::npos);
}

TEST_F(SceneFiles, RefuseBadMeshes) {
    const std::string mesh = "scene.json: meshes[0].file: ";
    const auto complaint = [&](const std::string& name, const std::string& text) {
        Write(name, text);
        return Complaint(R"({"meshes": [{"file": ")" + name + R"("}]})");
    };
    EXPECT_NE(complaint("empty.obj", "").find("empty.obj: "), std::string::npos);
    EXPECT_NE(complaint("points.obj", "v 0 0 0\nv 1 0 0\n").find("points.obj: "),
              std::string::npos);
    EXPECT_NE(complaint("nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find("nan.obj: "),
              std::string::npos);
    EXPECT_NE(
        complaint("beyond.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").find("beyond.obj: "),
        std::string::npos);
    EXPECT_NE(complaint("unknown.xyzzy", "hello").find("unknown.xyzzy: "), std::string::npos);
    EXPECT_NE(
        complaint("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\n").find("cut.ply: "),
        std::string::npos);
    // Over these, found by tests/fuzz, the readers of assimp 5.2 break down: faces that are not
    // there or have no corner, a list that ends in the middle.
    const std::string head =
        "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const auto breaks_down = [&](const std::string& name, const std::string& text) {
        EXPECT_EQ(complaint(name, text),
                  mesh + name + ": is damaged: its reader breaks down over it");
    };
    breaks_down("few.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    breaks_down("none.ply", "ply\nformat ascii 1.0\n" + head + "0 0 0\n1 0 0\n0 1 0\n0\n");
    breaks_down("short.ply", "ply\nformat binary_little_endian 1.0\n" + head +
                                 std::string(36, '\0') + "\xff");
    EXPECT_EQ(complaint("long.glb",
                        std::string("glTF\2\0\0\0\x20\0\0\0\xf0\xff\xff\xffJSON{ }     ", 28)),
              mesh +
                  "long.glb: is cut off or damaged: a chunk of 4294967280 bytes ends beyond "
                  "the file");
    EXPECT_EQ(
        complaint("many.ply", "ply\nformat ascii 1.0\nelement vertex 2147483648\n" + head),
        mesh + "many.ply: element vertex = 2147483648, must be at most the bytes of the file");
    const std::string vertices = "ply\nformat ascii 1.0\nelement vertex 3\n";
    for (const char* no_end : {"property float xend_header\n", "end_headerx\n", "end_header"}) {
        EXPECT_EQ(complaint("endless.ply", vertices + no_end),
                  mesh + "endless.ply: PLY header has no end");
    }
    EXPECT_THROW(ReadMesh(folder_), Error);
    Write("square.obj", kObj);
    EXPECT_THROW(ReadMesh(folder_ / "square.obj", {.unit_m = 0}), Error);
}

}  // namespace
}  // namespace plumb
