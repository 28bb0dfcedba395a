// Meshes from files: whatever assimp reads (glTF, OBJ, PLY, FBX, OFF, STL ...).
//
// Faces become triangles in metres with +z up, node transformations applied. Each keeps the
// diffuse colour and texture of its material; vertices keep their normals and texture
// coordinates.
//
// Beware   Textures repeat, whatever the file says. Points and lines are left out. Zero-area
//          triangles stay in; ray casters keep them out and count them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"

namespace plumb {

enum class UpAxis { kX, kY, kZ };

struct MeshFileOptions {
    double unit_m = 1;       ///< Length of the file's unit. (0, infinity)
    UpAxis up = UpAxis::kY;  ///< The file's axis that points up; glTF's is y.
    bool textures = true;    ///< False: materials keep their constant colours.
    /// Whether textures with an opacity cut holes; unset: as the file says (glTF's MASK, OBJ's
    /// map_d).
    std::optional<bool> alpha_tested = {};
};

struct MeshFile {
    Mesh mesh;
    std::vector<std::uint16_t> material_of_face;
    std::vector<Material> materials;
    std::vector<Texture> textures;
    /// Vertices are relative to it: not 0 if the file's lie far from theirs (io/far_mesh.h).
    Vec3 origin_m = Vec3::Zero();
    std::vector<std::string> notes;  ///< What was left out, for the report.
};

/// Throws Error, naming the file, if it is missing, damaged, of an unknown format, has no face,
/// a vertex that is not finite, an index out of range, more than 65535 materials, or a texture
/// that is missing or cannot be read.
MeshFile ReadMesh(const std::filesystem::path& path, const MeshFileOptions& options = {});

}  // namespace plumb
