// A scene as values: surfaces, what they are made of, light and cameras. It knows nothing of
// files (io/scene_file.h), of generators (scenes/) or of how it is drawn.
//
// Lengths in metres, +z up, linear colours.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/camera.h"
#include "core/environment.h"
#include "core/image.h"
#include "core/mesh.h"
#include "core/texture.h"
#include "core/vec.h"

namespace plumb {

/// Diffuse.
struct Material {
    std::string name = "material";
    Rgb albedo{0.8f, 0.8f, 0.8f};  ///< rho of each colour, times the texture's. [0, 1]
    int texture = kNoTexture;      ///< Of Scene::textures.
    bool alpha_tested = false;     ///< No surface where the texture's opacity is below 1/2.

    static constexpr int kNoTexture = -1;
};

/// Light from infinitely far away.
struct DirectionalLight {
    Vec3 towards{0, 0, 1};  ///< From the scene to the light; any length but 0.
    Rgb irradiance{1.f, 1.f,
                   1.f};  ///< Of a surface that faces it, over pi: see SceneLight. >= 0
};

/// Light from one point, falling off with the square of the distance.
struct PointLight {
    Vec3 position_m{0, 0, 1};
    Rgb intensity{1.f, 1.f, 1.f};  ///< Its irradiance at 1 m, over pi. >= 0
};

/// All light that does not come from surfaces. Like every E of the project, irradiances are
/// divided by pi: a white surface that faces a light of irradiance 1 has the radiance 1, as it
/// has under an open sky of radiance 1.
struct SceneLight {
    Rgb sky{1.f, 1.f, 1.f};   ///< Radiance of the sky, times that of the picture. >= 0
    Environment environment;  ///< The sky as a picture; without one it is the same all around.
    std::vector<DirectionalLight> directional;
    std::vector<PointLight> points;
};

struct Scene {
    std::string name = "scene";
    Mesh mesh;
    std::vector<std::uint16_t> material_of_face;  ///< One a face of the mesh.
    std::vector<Material> materials;
    std::vector<Texture> textures;
    SceneLight light;
    std::vector<Camera> cameras;

    const Rgb& AlbedoOfTriangle(std::uint32_t triangle) const {
        return materials[material_of_face[triangle / 2]].albedo;
    }
};

/// Throws Error, naming field, value and rule, unless there are faces, each with a material
/// that exists, vertices are finite, indices in range, albedos in [0, 1], lights not negative,
/// and cameras valid.
void Validate(const Scene& scene);

}  // namespace plumb
