#include "jobs/load_scene.h"

#include <cstdint>
#include <type_traits>
#include <utility>

#include "core/error.h"
#include "io/content_hash.h"
#include "io/scene_file.h"
#include "scenes/catalogue.h"

namespace plumb {
namespace {

// Appends the bytes of plain numbers, in this machine's order.
template <class T>
void Append(std::string& bytes, const std::vector<T>& values) {
    static_assert(std::is_trivially_copyable_v<T> || std::is_same_v<T, Vec3f> ||
                  std::is_same_v<T, Vec2f>);
    // The count first: no two scenes run into the same bytes.
    const std::uint64_t count = values.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

std::string Digest(const Scene& scene) {
    std::string bytes;
    Append(bytes, scene.mesh.vertices_m);
    Append(bytes, scene.mesh.quads);
    Append(bytes, scene.material_of_face);
    Append(bytes, scene.mesh.normals);
    Append(bytes, scene.mesh.uvs);
    for (const Material& material : scene.materials) {
        Append(bytes, std::vector{material.albedo});
        Append(bytes, std::vector{material.texture, int(material.alpha_tested)});
    }
    for (const Texture& texture : scene.textures) {
        Append(bytes, std::vector{texture.albedo.Width(), texture.albedo.Height()});
        Append(bytes, texture.albedo.Pixels());
        Append(bytes, texture.opacity.Pixels());
    }
    return Sha256Hex(bytes);
}

}  // namespace

LoadedScene LoadScene(const std::string& name) {
    LoadedScene loaded;
    if (name.ends_with(".json")) {
        SceneFile file = ReadSceneFile(name);
        loaded.scene = std::move(file.scene);
        loaded.notes = std::move(file.notes);
        if (!file.generator.empty()) {
            Scene made = SceneKindNamed(file.generator).make();
            made.name = loaded.scene.name;
            if (file.has_light) made.light = loaded.scene.light;
            if (file.has_cameras) made.cameras = loaded.scene.cameras;
            loaded.scene = std::move(made);
        }
    } else {
        loaded.scene = SceneKindNamed(name.starts_with("make:") ? name.substr(5) : name).make();
    }
    Validate(loaded.scene);
    loaded.digest = Digest(loaded.scene);
    return loaded;
}

const Camera& CameraNamed(const Scene& scene, const std::string& name) {
    if (scene.cameras.empty()) throw Error(scene.name + ": no cameras, must have one");
    if (name.empty()) return scene.cameras.front();
    std::string names;
    for (const Camera& camera : scene.cameras) {
        if (camera.name == name) return camera;
        names += (names.empty() ? "" : ", ") + camera.name;
    }
    throw Error(scene.name + ": camera \"" + name + "\", must be one of " + names);
}

}  // namespace plumb
