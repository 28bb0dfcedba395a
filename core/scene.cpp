#include "core/scene.h"

#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

void NotNegative(const Rgb& colour, const std::string& name, double most, const char* rule) {
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(colour[c] >= 0 && colour[c] <= most)) {
            throw Error(MustBe(name + "[" + std::to_string(c) + "]", colour[c], rule));
        }
    }
}

void ValidateTexture(const Texture& texture, const std::string& name) {
    const Image<float>& opacity = texture.opacity;
    if (texture.albedo.Empty()) throw Error(name + ".albedo is empty, must have a pixel");
    if (!opacity.Empty() && (opacity.Width() != texture.albedo.Width() ||
                             opacity.Height() != texture.albedo.Height())) {
        throw Error(name + ".opacity is of another size than .albedo, must be of the same");
    }
    for (const Rgb& pixel : texture.albedo.Pixels()) {
        for (const float x : pixel) {
            if (!(x >= 0 && x <= 1)) throw Error(MustBe(name + ".albedo", x, "in [0, 1]"));
        }
    }
    for (const float x : opacity.Pixels()) {
        if (!(x >= 0 && x <= 1)) throw Error(MustBe(name + ".opacity", x, "in [0, 1]"));
    }
}

// Normals, texture coordinates, textures, and who names them.
void ValidateShading(const Scene& scene) {
    const Mesh& mesh = scene.mesh;
    const std::string rule = "0 or the number of vertices";
    if (!mesh.normals.empty() && mesh.normals.size() != mesh.vertices_m.size()) {
        throw Error(MustBe(scene.name + ": normals", double(mesh.normals.size()), rule));
    }
    if (!mesh.uvs.empty() && mesh.uvs.size() != mesh.vertices_m.size()) {
        throw Error(
            MustBe(scene.name + ": texture coordinates", double(mesh.uvs.size()), rule));
    }
    for (const Vec3f& n : mesh.normals) {
        if (!n.allFinite()) throw Error(scene.name + ": a normal is not finite, must be");
    }
    for (const Vec2f& uv : mesh.uvs) {
        if (!uv.allFinite()) {
            throw Error(scene.name + ": a texture coordinate is not finite, must be");
        }
    }
    for (std::size_t t = 0; t < scene.textures.size(); ++t) {
        ValidateTexture(scene.textures[t],
                        scene.name + ": textures[" + std::to_string(t) + "]");
    }
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const int texture = scene.materials[m].texture;
        if (texture < Material::kNoTexture || texture >= int(scene.textures.size())) {
            throw Error(MustBe(scene.name + ": materials[" + std::to_string(m) + "].texture",
                               texture, "-1 or < " + std::to_string(scene.textures.size())));
        }
    }
}

}  // namespace

void Validate(const Scene& scene) {
    const std::string& name = scene.name;
    if (scene.mesh.quads.empty()) throw Error(name + ": faces = 0, must be >= 1");
    const std::size_t vertices = scene.mesh.vertices_m.size();
    for (std::size_t i = 0; i < vertices; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const float x = scene.mesh.vertices_m[i][axis];
            if (!(std::abs(x) <= 1e15f)) {
                throw Error(MustBe(name + ": vertex " + std::to_string(i) + "." + "xyz"[axis],
                                   x, "finite and at most 1e15 from 0"));
            }
        }
    }
    for (std::size_t f = 0; f < scene.mesh.quads.size(); ++f) {
        for (const std::uint32_t corner : scene.mesh.quads[f]) {
            if (corner >= vertices) {
                throw Error(MustBe(name + ": corner of face " + std::to_string(f), corner,
                                   "< " + std::to_string(vertices) + ", the vertices"));
            }
        }
    }
    if (scene.material_of_face.size() != scene.mesh.quads.size()) {
        throw Error(MustBe(name + ": faces with a material",
                           double(scene.material_of_face.size()), "the number of faces"));
    }
    for (const std::uint16_t material : scene.material_of_face) {
        if (material >= scene.materials.size()) {
            throw Error(MustBe(name + ": material of a face", material,
                               "< " + std::to_string(scene.materials.size())));
        }
    }
    ValidateShading(scene);
    constexpr double kHuge = 1e30;
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        NotNegative(scene.materials[m].albedo,
                    name + ": materials[" + std::to_string(m) + "].albedo", 1, "in [0, 1]");
    }
    NotNegative(scene.light.sky, name + ": sky", kHuge, "finite and >= 0");
    for (const Rgb& pixel : scene.light.environment.radiance.Pixels()) {
        NotNegative(pixel, name + ": environment", kHuge, "finite and >= 0");
    }
    if (!std::isfinite(scene.light.environment.turn_rad)) {
        throw Error(name + ": environment.turn_rad is not finite, must be");
    }
    for (std::size_t i = 0; i < scene.light.directional.size(); ++i) {
        const std::string at = name + ": directional_lights[" + std::to_string(i) + "]";
        NotNegative(scene.light.directional[i].irradiance, at + ".irradiance", kHuge,
                    "finite and >= 0");
        const double length = scene.light.directional[i].towards.norm();
        if (!(length > 0 && std::isfinite(length))) {
            throw Error(at + ".towards has no length, or none that is finite; must have one");
        }
    }
    for (std::size_t i = 0; i < scene.light.points.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const double x = scene.light.points[i].position_m[axis];
            if (!(std::abs(x) <= 1e15)) {
                throw Error(MustBe(name + ": point_lights[" + std::to_string(i) +
                                       "].position_m[" + std::to_string(axis) + "]",
                                   x, "finite and at most 1e15 from 0"));
            }
        }
        NotNegative(scene.light.points[i].intensity,
                    name + ": point_lights[" + std::to_string(i) + "].intensity", kHuge,
                    "finite and >= 0");
    }
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        Validate(scene.cameras[i], name + ": cameras[" + std::to_string(i) + "]");
    }
}

}  // namespace plumb
