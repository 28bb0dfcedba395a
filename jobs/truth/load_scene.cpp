#include "jobs/truth/load_scene.h"

#include <cstdint>
#include <type_traits>
#include <utility>

#include "core/error.h"
#include "core/names.h"
#include "heightfield/facet.h"
#include "io/content_hash.h"
#include "io/scene_file.h"
#include "jobs/light/surface.h"
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

}  // namespace

std::string DigestOf(const Scene& scene) {
    std::string bytes;
    Append(bytes, scene.mesh.vertices_m);
    Append(bytes, scene.mesh.quads);
    Append(bytes, scene.material_of_face);
    Append(bytes, scene.mesh.normals);
    Append(bytes, scene.mesh.uvs);
    // How many there are: no two lists run into the same bytes.
    Append(bytes, std::vector{scene.materials.size(), scene.textures.size(),
                              scene.light.directional.size(), scene.light.points.size()});
    for (const Material& material : scene.materials) {
        Append(bytes, std::vector{material.albedo});
        Append(bytes, std::vector{material.texture, int(material.alpha_tested)});
    }
    for (const Texture& texture : scene.textures) {
        Append(bytes, std::vector{texture.albedo.Width(), texture.albedo.Height()});
        Append(bytes, texture.albedo.Pixels());
        Append(bytes, texture.opacity.Pixels());
    }
    const SceneLight& light = scene.light;
    Append(bytes, std::vector{light.sky});
    Append(bytes, light.environment.radiance.Pixels());
    Append(bytes,
           std::vector{double(light.environment.radiance.Width()), light.environment.turn_rad});
    for (const DirectionalLight& of : light.directional) {
        Append(bytes, std::vector{of.towards.x(), of.towards.y(), of.towards.z()});
        Append(bytes, std::vector{of.irradiance});
    }
    for (const PointLight& of : light.points) {
        Append(bytes, std::vector{of.position_m.x(), of.position_m.y(), of.position_m.z()});
        Append(bytes, std::vector{of.intensity});
    }
    return Sha256Hex(bytes);
}

namespace {

// Adds the surface of a height map with a material of its own.
void AddHeights(const HeightsEntry& entry, const Vec3& origin_m, Scene& scene) {
    SurfaceOptions options;
    options.amplitude_m = entry.amplitude_m;
    const Surface surface = LoadSurface(entry.name, options);
    const bool endless = surface.field.GetBoundary() != Boundary::kOpen;
    const double copies = endless ? 2.0 * entry.tiles + 1 : 1;
    const double faces = double(surface.field.Facets()) / 2 * copies * copies;
    constexpr double kMostFaces = 1 << 28;
    if (faces > kMostFaces) {
        throw Error(MustBe(entry.name + ": faces of all tiles", faces, "at most 2^28"));
    }
    Mesh mesh = ToMesh(surface.field, endless ? entry.tiles : 0);
    if (!origin_m.isZero(0)) {
        for (Vec3f& v : mesh.vertices_m) v = (v.cast<double>() - origin_m).cast<float>();
    }
    const std::size_t first = scene.mesh.vertices_m.size();
    if (first + mesh.vertices_m.size() > 0xffffffffu || scene.materials.size() >= 0xffffu) {
        throw Error(scene.name + ": more than 2^32 vertices or 65535 materials in all");
    }
    scene.mesh.vertices_m.insert(scene.mesh.vertices_m.end(), mesh.vertices_m.begin(),
                                 mesh.vertices_m.end());
    if (!scene.mesh.normals.empty()) {
        scene.mesh.normals.resize(scene.mesh.vertices_m.size(), Vec3f::Zero());
    }
    if (!scene.mesh.uvs.empty()) {
        scene.mesh.uvs.resize(scene.mesh.vertices_m.size(), Vec2f::Zero());
    }
    for (std::array<std::uint32_t, 4> quad : mesh.quads) {
        for (std::uint32_t& corner : quad) corner += std::uint32_t(first);
        scene.mesh.quads.push_back(quad);
        scene.material_of_face.push_back(std::uint16_t(scene.materials.size()));
    }
    scene.materials.push_back({.name = surface.source.name, .albedo = entry.albedo});
}

}  // namespace

LoadedScene LoadScene(const std::string& name) {
    LoadedScene loaded;
    if (name.ends_with(".json")) {
        SceneFile file = ReadSceneFile(name);
        loaded.scene = std::move(file.scene);
        loaded.notes = std::move(file.notes);
        loaded.techniques = std::move(file.techniques);
        for (const HeightsEntry& entry : file.heights) {
            try {
                AddHeights(entry, file.origin_m, loaded.scene);
            } catch (const Error& error) {
                throw Error(entry.asked_by + ": " + error.what());
            }
        }
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
    loaded.digest = DigestOf(loaded.scene);
    return loaded;
}

const Camera& CameraNamed(const Scene& scene, const std::string& name) {
    if (scene.cameras.empty()) throw Error(scene.name + ": no cameras, must have one");
    if (name.empty()) return scene.cameras.front();
    return FindNamed(
        scene.cameras, [](const Camera& camera) { return camera.name; }, name,
        scene.name + ": camera \"" + name + "\"");
}

}  // namespace plumb
