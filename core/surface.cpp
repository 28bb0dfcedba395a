#include "core/surface.h"

namespace plumb {
namespace {

// With the texture that the material names, or nothing.
const Texture* TextureOf(const Scene& scene, const Material& material) {
    if (material.texture == Material::kNoTexture) return nullptr;
    return &scene.textures[std::size_t(material.texture)];
}

const Material& MaterialOf(const Scene& scene, std::uint32_t face) {
    return scene.materials[scene.material_of_face[face]];
}

}  // namespace

std::array<std::uint32_t, 3> CornersOf(const Mesh& mesh, std::uint32_t triangle) {
    const std::array<std::uint32_t, 4>& face = mesh.quads[triangle / 2];
    return triangle % 2 == 0 ? std::array{face[0], face[1], face[3]}
                             : std::array{face[2], face[3], face[1]};
}

Vec2f UvAt(const Mesh& mesh, std::uint32_t triangle, double b_1, double b_2) {
    if (mesh.uvs.empty()) return Vec2f::Zero();
    const auto [p, q, r] = CornersOf(mesh, triangle);
    const Vec2 uv = (1 - b_1 - b_2) * mesh.uvs[p].cast<double>() +
                    b_1 * mesh.uvs[q].cast<double>() + b_2 * mesh.uvs[r].cast<double>();
    return uv.cast<float>();
}

Rgb AlbedoAt(const Scene& scene, std::uint32_t triangle, double b_1, double b_2) {
    const Material& material = MaterialOf(scene, triangle / 2);
    const Texture* texture = TextureOf(scene, material);
    if (texture == nullptr) return material.albedo;
    const Rgb of_texture = SampleAlbedo(*texture, UvAt(scene.mesh, triangle, b_1, b_2));
    Rgb albedo;
    for (std::size_t c = 0; c < 3; ++c) albedo[c] = material.albedo[c] * of_texture[c];
    return albedo;
}

bool IsAlphaTested(const Scene& scene, std::uint32_t face) {
    const Material& material = MaterialOf(scene, face);
    const Texture* texture = TextureOf(scene, material);
    return material.alpha_tested && texture != nullptr && !texture->opacity.Empty();
}

bool IsSolidAt(const Scene& scene, std::uint32_t triangle, double b_1, double b_2) {
    if (!IsAlphaTested(scene, triangle / 2)) return true;
    const Texture& texture = *TextureOf(scene, MaterialOf(scene, triangle / 2));
    return SampleOpacity(texture, UvAt(scene.mesh, triangle, b_1, b_2)) >= kSolidOpacity;
}

Vec3 ShadingNormalAt(const Mesh& mesh, std::uint32_t triangle, double b_1, double b_2,
                     const Vec3& face_normal) {
    if (mesh.normals.empty()) return face_normal;
    const auto [p, q, r] = CornersOf(mesh, triangle);
    const Vec3 n = (1 - b_1 - b_2) * mesh.normals[p].cast<double>() +
                   b_1 * mesh.normals[q].cast<double>() + b_2 * mesh.normals[r].cast<double>();
    const double length = n.norm();
    constexpr double kCancelled = 1e-6;  // Of unit vectors in float.
    if (!(length > kCancelled)) return face_normal;
    return n.dot(face_normal) < 0 ? Vec3(-n / length) : Vec3(n / length);
}

}  // namespace plumb
