// What a mesh file's header claims, checked before a reader believes it.
//
// assimp 5.2 reads on for ever in a PLY header that does not end, takes a minute over one that
// counts 2^31 vertices, and as much memory as a chunk of a GLB says it is long.
//
// Source   GLB: Khronos, glTF 2.0 specification, 4.4, binary glTF: 12 bytes of header, then chunks
//          of length (4 bytes), type (4 bytes) and data.
#pragma once

#include <filesystem>

namespace plumb {

/// Throws Error naming the file if its ending is .ply or .glb and its header cannot be true.
void CheckMeshHeader(const std::filesystem::path& path);

}  // namespace plumb
