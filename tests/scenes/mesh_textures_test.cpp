// Normals, texture coordinates and textures of mesh files.
#include <OpenImageIO/imageio.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/surface.h"
#include "io/data_uri.h"
#include "io/image_io.h"
#include "io/mesh_io.h"
#include "io/picture_file.h"
#include "io/scene_file.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::HasSubstr;

// A square from (-1, 0) to (1, 0, 2 up) of an OBJ whose up is z, uv from (0, 0) to (1, 1).
constexpr const char* kObj =
    "mtllib square.mtl\nusemtl cloth\n"
    "v -1 0 0\nv 1 0 0\nv 1 0 2\nv -1 0 2\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 -2 0\n"
    "f 1/1/1 2/2/1 3/3/1 4/4/1\n";

class MeshTextures : public TempFolder {
  protected:
    // 2 x 2 texels: red and green above, blue and white below.
    void PutColours(const std::string& name) const {
        Image<Rgb> image(2, 2);
        image(0, 0) = {1, 0, 0};
        image(1, 0) = {0, 1, 0};
        image(0, 1) = {0, 0, 1};
        image(1, 1) = {1, 1, 1};
        WritePreview(Path(name), image);
    }

    MeshFile ReadObj(const std::string& mtl, MeshFileOptions options = {}) const {
        Put("square.obj", kObj);
        Put("square.mtl", "newmtl cloth\nKd 1 0.5 1\n" + mtl);
        options.up = UpAxis::kZ;
        return ReadMesh(Path("square.obj"), options);
    }

    static Scene ToScene(const MeshFile& file) {
        Scene scene;
        scene.mesh = file.mesh;
        scene.material_of_face = file.material_of_face;
        scene.materials = file.materials;
        scene.textures = file.textures;
        Validate(scene);
        return scene;
    }

    // Albedo at the point of the square with these texture coordinates, whatever its triangles.
    static Rgb AlbedoAtUv(const Scene& scene, double u, double v) {
        for (std::uint32_t f = 0; f < scene.mesh.quads.size(); ++f) {
            const auto [p, q, r] = CornersOf(scene.mesh, 2 * f);
            Eigen::Matrix2d m;
            m.col(0) = (scene.mesh.uvs[q] - scene.mesh.uvs[p]).cast<double>();
            m.col(1) = (scene.mesh.uvs[r] - scene.mesh.uvs[p]).cast<double>();
            const Vec2 b = m.inverse() * (Vec2(u, v) - scene.mesh.uvs[p].cast<double>());
            if (b.minCoeff() >= 0 && b.sum() <= 1) return AlbedoAt(scene, 2 * f, b.x(), b.y());
        }
        ADD_FAILURE() << "no triangle there";
        return {};
    }
};

// Expected: by hand, (0, 0) is the lower left corner: u = v = 1/4 is the centre of the texel in
// the lower left, blue, times Kd. Rounding: sRGB 0 and 255 decode to 0 and 1 exactly.
TEST_F(MeshTextures, LieTheRightWayUp) {
    PutColours("colours.png");
    const MeshFile file = ReadObj("map_Kd colours.png\n");
    const Scene scene = ToScene(file);
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_FALSE(scene.materials[scene.material_of_face[0]].alpha_tested);
    const auto near = [](const Rgb& expected) {
        return testing::Pointwise(testing::FloatNear(1e-5f), expected);
    };
    EXPECT_THAT(AlbedoAtUv(scene, 0.25, 0.25), near({0, 0, 1}));
    EXPECT_THAT(AlbedoAtUv(scene, 0.75, 0.25), near({1, 0.5, 1}));
    EXPECT_THAT(AlbedoAtUv(scene, 0.25, 0.75), near({1, 0, 0}));
    EXPECT_THAT(AlbedoAtUv(scene, 0.75, 0.75), near({0, 0.5, 0}));
}

TEST_F(MeshTextures, NormalsAreUnitAndTurnedWithTheMesh) {
    PutColours("colours.png");
    const MeshFile z_up = ReadObj("map_Kd colours.png\n");
    ASSERT_EQ(z_up.mesh.normals.size(), z_up.mesh.vertices_m.size());
    EXPECT_LT((z_up.mesh.normals[0] - Vec3f(0, -1, 0)).norm(), 1e-6f);
    const MeshFile y_up = ReadMesh(Path("square.obj"), {.up = UpAxis::kY});
    EXPECT_LT((y_up.mesh.normals[0] - Vec3f(0, 0, -1)).norm(), 1e-6f);
}

TEST_F(MeshTextures, HolesComeFromTheFileOrTheScene) {
    PutColours("colours.png");
    Image<double> mask(4, 4);
    for (int j = 0; j < 4; ++j) {
        for (int i = 0; i < 4; ++i) mask(i, j) = i < 2 ? 0.4 : 1;
    }
    WriteGreyPng(Path("mask.png"), mask, 8);
    const std::string both = "map_Kd colours.png\nmap_d mask.png\n";
    const MeshFile file = ReadObj(both);
    ASSERT_EQ(file.textures.size(), 1u);
    EXPECT_TRUE(file.materials[file.material_of_face[0]].alpha_tested);
    // The mask at the size of the colours; 0.4 stays 0.4, it is no colour.
    ASSERT_EQ(file.textures[0].opacity.Width(), 2);
    EXPECT_NEAR(file.textures[0].opacity(0, 0), 0.4, 0.5 / 255);
    EXPECT_EQ(file.textures[0].opacity(1, 1), 1);
    const MeshFile closed = ReadObj(both, {.alpha_tested = false});
    EXPECT_FALSE(closed.materials[closed.material_of_face[0]].alpha_tested);
    // Without a mask nothing can be cut.
    const MeshFile plain = ReadObj("map_Kd colours.png\n", {.alpha_tested = true});
    EXPECT_FALSE(plain.materials[plain.material_of_face[0]].alpha_tested);
}

TEST_F(MeshTextures, MissingOrDamagedOnesAreNamed) {
    EXPECT_THAT(MessageOf<Error>([&] { ReadObj("map_Kd sub\\gone.png\n"); }),
                testing::AllOf(HasSubstr("square.obj: material cloth: texture sub\\gone.png"),
                               HasSubstr("sub/gone.png")));
    Put("bad.png", "\x89PNG\r\n\x1a\n");
    EXPECT_THAT(MessageOf<Error>([&] { ReadObj("map_Kd bad.png\n"); }),
                HasSubstr("material cloth: texture bad.png"));
    Put("text.jpg", "hello");
    EXPECT_THAT(MessageOf<Error>([&] { ReadObj("map_Kd text.jpg\n"); }),
                HasSubstr("is no picture of a known format"));
    const MeshFile file = ReadObj("map_Kd gone.png\n", {.textures = false});
    EXPECT_EQ(file.textures.size(), 0u);
    EXPECT_EQ(file.materials[file.material_of_face[0]].texture, Material::kNoTexture);
    ASSERT_EQ(file.notes.size(), 1u);
    EXPECT_THAT(file.notes[0], HasSubstr("left out as asked"));
}

// The same square as a glTF whose picture is inside the file.
TEST_F(MeshTextures, AreReadOutOfAGltf) {
    PutColours("colours.png");
    const std::vector<float> floats = {-1, 0,  0, 1, 0, 0, 1, 2,
                                       0,  -1, 2, 0,               // Positions, y up.
                                       0,  1,  1, 1, 1, 0, 0, 0};  // v down, as glTF has it.
    const std::vector<std::uint16_t> indices = {0, 1, 2, 0, 2, 3};
    std::string bytes(reinterpret_cast<const char*>(floats.data()), 4 * floats.size());
    bytes.append(reinterpret_cast<const char*>(indices.data()), 2 * indices.size());
    Put("square.bin", bytes);
    Put("square.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1},
                                    "indices": 2, "material": 0}]}],
        "materials": [{"name": "cloth", "alphaMode": "MASK", "alphaCutoff": 0.5,
          "pbrMetallicRoughness": {"baseColorFactor": [1, 0.5, 1, 1],
                                   "baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": ")" +
                           PngDataUri(Path("colours.png")) + R"("}],
        "buffers": [{"uri": "square.bin", "byteLength": 92}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                        {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
        "accessors": [
          {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
           "min": [-1, 0, 0], "max": [1, 2, 0]},
          {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
          {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}]})");
    const MeshFile file = ReadMesh(Path("square.gltf"));
    const Scene scene = ToScene(file);
    ASSERT_EQ(scene.textures.size(), 1u);
    EXPECT_THAT(AlbedoAtUv(scene, 0.25, 0.25),
                testing::Pointwise(testing::FloatNear(1e-5f), Rgb{0, 0, 1}));
    EXPECT_THAT(AlbedoAtUv(scene, 0.75, 0.75),
                testing::Pointwise(testing::FloatNear(1e-5f), Rgb{0, 0.5f, 0}));
    // MASK without an opacity in the picture: nothing to cut with.
    EXPECT_FALSE(scene.materials[scene.material_of_face[0]].alpha_tested);
}

TEST_F(MeshTextures, AreJoinedIntoOneScene) {
    PutColours("colours.png");
    Image<Rgb> grey(1, 1, Rgb{0.5f, 0.5f, 0.5f});
    WriteExr(Path("grey.exr"), {{"R", Image<float>(1, 1, 0.5f)},
                                {"G", Image<float>(1, 1, 0.5f)},
                                {"B", Image<float>(1, 1, 0.5f)},
                                {"A", Image<float>(1, 1, 0.25f)}});
    ReadObj("map_Kd colours.png\n");
    Put("second.obj",
        "mtllib second.mtl\nusemtl cut\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"
        "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1 2/2 3/3\n");
    Put("second.mtl", "newmtl cut\nKd 1 1 1\nmap_Kd grey.exr\n");
    Put("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const SceneFile file = ReadSceneFile(Put("scene.json", R"({"meshes": [
        {"file": "plain.obj"}, {"file": "square.obj", "up": "z"},
        {"file": "second.obj", "alpha_tested": true},
        {"file": "square.obj", "textures": false}]})"));
    Validate(file.scene);
    ASSERT_EQ(file.scene.textures.size(), 2u);
    EXPECT_EQ(file.scene.mesh.uvs.size(), file.scene.mesh.vertices_m.size());
    const auto material_of = [&](std::size_t face) {
        return file.scene.materials[file.scene.material_of_face[face]];
    };
    EXPECT_EQ(material_of(0).texture, Material::kNoTexture);
    EXPECT_EQ(material_of(1).texture, 0);
    EXPECT_EQ(material_of(3).texture, 1);
    EXPECT_TRUE(material_of(3).alpha_tested);
    EXPECT_FLOAT_EQ(AlbedoAt(file.scene, 6, 0.1, 0.1)[0], 0.5f);
    EXPECT_FALSE(IsSolidAt(file.scene, 6, 0.1, 0.1));
    EXPECT_EQ(material_of(4).texture, Material::kNoTexture);
    EXPECT_EQ(file.scene.mesh.normals[0], Vec3f(Vec3f::Zero()));
}

TEST_F(MeshTextures, FieldsThatContradictAreRefused) {
    ReadObj("");
    const auto complaint = [&](const std::string& fields) {
        return MessageOf<Error>([&] {
            ReadSceneFile(
                Put("scene.json", R"({"meshes": [{"file": "square.obj", )" + fields + "}]}"));
        });
    };
    EXPECT_EQ(complaint(R"("albedo": [1, 1, 1], "textures": true)"),
              Path("scene.json").string() +
                  ": meshes[0].albedo and textures: must be only one of them");
    EXPECT_EQ(complaint(R"("textures": false, "alpha_tested": true)"),
              Path("scene.json").string() +
                  ": meshes[0].alpha_tested without textures, must have them");
    EXPECT_THAT(complaint(R"("alpha_tested": 1)"), HasSubstr("must be true or false"));
}

// Every common format, written by OpenImageIO: full red and half (encoded 188: [IEC61966] 0.503)
// green and blue come back. Tolerance: 8 bits, and what JPEG loses of an even colour.
TEST_F(MeshTextures, PicturesOfEveryFormatAreRead) {
    for (const char* ending : {"png", "jpg", "tga", "bmp", "tif", "gif", "exr", "hdr"}) {
        const bool is_float = ending[0] == 'e' || ending[0] == 'h';
        const float half = is_float ? 0.503f : 188.0f / 255;
        const std::string name = std::string("picture.") + ending;
        OIIO::ImageSpec spec(16, 16, 3,
                             is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
        const auto output = OIIO::ImageOutput::create(Path(name).string());
        ASSERT_TRUE(output && output->open(Path(name).string(), spec)) << ending;
        std::vector<float> numbers;
        for (int k = 0; k < 256; ++k) numbers.insert(numbers.end(), {1, half, half});
        output->write_image(OIIO::TypeDesc::FLOAT, numbers.data());
        output->close();
        const Picture picture = ReadPictureFile(Path(name));
        EXPECT_NEAR(picture.linear(8, 8)[0], 1, 0.02) << ending;
        EXPECT_NEAR(picture.linear(8, 8)[1], 0.503, 0.02) << ending;
        EXPECT_TRUE(picture.opacity.Empty()) << ending;
        // Known by its content: the ending may lie, but for TGA.
        if (std::string(ending) == "tga") continue;
        Put("picture.bin", Get(name));
        EXPECT_EQ(ReadPictureFile(Path("picture.bin")).linear, picture.linear) << ending;
    }
}

// Found by tests/fuzz: a size of which the decoder takes a negative number of bytes.
TEST_F(MeshTextures, AGifThatClaimsAHugeSizeIsRefused) {
    OIIO::ImageSpec spec(4, 4, 3, OIIO::TypeDesc::UINT8);
    const auto output = OIIO::ImageOutput::create(Path("good.gif").string());
    ASSERT_TRUE(output && output->open(Path("good.gif").string(), spec));
    const std::vector<float> numbers(48, 0.5f);
    output->write_image(OIIO::TypeDesc::FLOAT, numbers.data());
    output->close();
    std::string bytes = Get("good.gif");
    bytes.replace(6, 4, "\x0cnan");
    EXPECT_THROW(ReadPictureFile(Put("huge.gif", bytes)), Error);
}

// Law: a float picture is linear, an 8-bit one sRGB-encoded; opacity and numbers never are.
TEST_F(MeshTextures, PicturesAreDecodedByWhatTheyAre) {
    Image<double> half(1, 1, 0.5);
    WriteGreyPng(Path("half.png"), half, 16);
    // [IEC61966] of 0.5 (32768 / 65535): ((0.5 + 0.055) / 1.055)^2.4 = 0.214041
    EXPECT_NEAR(ReadPictureFile(Path("half.png")).linear(0, 0)[0], 0.214041, 2e-5);
    EXPECT_NEAR(ReadPictureFile(Path("half.png"), PictureOf::kNumbers).linear(0, 0)[0], 0.5,
                1e-5);
    WriteExr(Path("bad.exr"), {{"R", Image<float>(1, 1, -1)},
                               {"G", Image<float>(1, 1, 7)},
                               {"B", Image<float>(1, 1, std::nanf(""))}});
    const Picture bad = ReadPictureFile(Path("bad.exr"));
    EXPECT_EQ(bad.linear(0, 0), (Rgb{0, 7, 0}));
    EXPECT_TRUE(bad.had_bad_numbers);
    EXPECT_THROW(ReadPictureFile(Path("gone.png")), Error);
    EXPECT_THROW(ReadPictureFile(Put("empty.png", "")), Error);
    EXPECT_THROW(ReadPictureFile(Path("half.png"), PictureOf::kColours, 0), Error);
}

}  // namespace
}  // namespace plumb
