// The materials of a mesh file: diffuse colours, and the textures that they name.
//
// A texture is a file beside the mesh or one embedded in it. A separate picture of opacity (the
// map_d of OBJ) is put into the texture of the colours, at their size.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/scene.h"
#include "io/mesh_io.h"

struct aiScene;

namespace plumb {

struct MeshMaterials {
    std::vector<Material> materials;
    std::vector<unsigned> uv_channel;  ///< Of each material: which of a mesh's to take.
    std::vector<Texture> textures;
    std::vector<std::string> notes;
};

/// Throws Error naming mesh, material and texture if one is missing or cannot be read.
MeshMaterials ReadMaterials(const aiScene& scene, const std::filesystem::path& mesh_path,
                            const MeshFileOptions& options);

}  // namespace plumb
