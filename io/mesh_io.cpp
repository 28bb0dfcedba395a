#include "io/mesh_io.h"

#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <limits>

#include "core/error.h"

namespace plumb {
namespace {

Vec3 UpIsZ(const aiVector3D& p, UpAxis up) {
    switch (up) {
        case UpAxis::kX:
            return {p.y, p.z, p.x};
        case UpAxis::kY:
            return {p.x, -p.z, p.y};
        case UpAxis::kZ:
            return {p.x, p.y, p.z};
    }
    return Vec3::Zero();
}

Material ToMaterial(const aiMaterial& from, const std::string& file,
                    std::vector<std::string>& notes) {
    Material material;
    material.name = from.GetName().C_Str();
    aiColor4D colour(0.8f, 0.8f, 0.8f, 1.0f);
    if (from.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS) {
        from.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
    }
    const float channels[] = {colour.r, colour.g, colour.b};
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(channels[c] >= 0 && channels[c] <= 1)) {
            notes.push_back(file + ": material " + material.name +
                            ": colour out of [0, 1], clamped");
        }
        // In this order what is not a number becomes 0.
        material.albedo[c] = std::min(1.0f, std::max(0.0f, channels[c]));
    }
    if (from.GetTextureCount(aiTextureType_DIFFUSE) > 0 ||
        from.GetTextureCount(aiTextureType_BASE_COLOR) > 0) {
        notes.push_back(file + ": material " + material.name +
                        ": texture left out, constant colour instead");
    }
    return material;
}

// assimp 5.2 reads on for ever in a PLY header that does not end.
void CheckPlyHeader(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return std::tolower(c); });
    if (ending != ".ply") return;
    constexpr std::size_t kLongestHeader = 1 << 16;
    std::string head(kLongestHeader, '\0');
    std::ifstream in(path, std::ios::binary);
    in.read(head.data(), std::streamsize(head.size()));
    head.resize(std::size_t(in.gcount()));
    if (head.find("end_header") == std::string::npos) {
        throw Error(path.string() + ": PLY header has no end");
    }
}

class Converter {
  public:
    Converter(const std::string& file, const MeshFileOptions& options)
        : file_(file), options_(options) {}

    MeshFile Convert(const aiScene& scene) {
        if (scene.mNumMaterials > 65535) {
            throw Error(MustBe(file_ + ": materials", scene.mNumMaterials, "at most 65535"));
        }
        for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
            out_.materials.push_back(ToMaterial(*scene.mMaterials[m], file_, out_.notes));
        }
        for (unsigned m = 0; m < scene.mNumMeshes; ++m) Add(*scene.mMeshes[m]);
        if (out_.mesh.quads.empty()) throw Error(file_ + ": no faces");
        return std::move(out_);
    }

  private:
    void Add(const aiMesh& mesh) {
        const std::size_t first = out_.mesh.vertices_m.size();
        if (first + mesh.mNumVertices > std::numeric_limits<std::uint32_t>::max()) {
            throw Error(file_ + ": more than 2^32 vertices");
        }
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const Vec3 p = options_.unit_m * UpIsZ(mesh.mVertices[v], options_.up);
            if (!(p.cwiseAbs().maxCoeff() <= 1e15)) {  // Also if it is not a number.
                throw Error(file_ + ": mesh " + mesh.mName.C_Str() + ", vertex " +
                            std::to_string(v) + ": must be finite and at most 1e15 m from 0");
            }
            out_.mesh.vertices_m.push_back(p.cast<float>());
        }
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const aiFace& face = mesh.mFaces[f];
            if (face.mNumIndices != 3) continue;  // Points and lines.
            std::array<std::uint32_t, 4> corners{};
            for (unsigned k = 0; k < 3; ++k) {
                if (face.mIndices[k] >= mesh.mNumVertices) {
                    throw Error(MustBe(file_ + ": mesh " + mesh.mName.C_Str() + ", face " +
                                           std::to_string(f) + ": index",
                                       face.mIndices[k],
                                       "< " + std::to_string(mesh.mNumVertices)));
                }
                corners[k] = std::uint32_t(first) + face.mIndices[k];
            }
            corners[3] = corners[2];
            out_.mesh.quads.push_back(corners);
            out_.material_of_face.push_back(std::uint16_t(mesh.mMaterialIndex));
        }
    }

    std::string file_;
    const MeshFileOptions& options_;
    MeshFile out_;
};

}  // namespace

MeshFile ReadMesh(const std::filesystem::path& path, const MeshFileOptions& options) {
    const std::string file = path.string();
    if (!(options.unit_m > 0 && std::isfinite(options.unit_m))) {
        throw Error(MustBe(file + ": unit_m", options.unit_m, "> 0"));
    }
    if (std::ifstream probe(path, std::ios::binary);
        !probe || std::filesystem::is_directory(path)) {
        throw Error(file + ": cannot be read");
    }
    CheckPlyHeader(path);
    try {
        Assimp::Importer importer;
        importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                    aiPrimitiveType_POINT | aiPrimitiveType_LINE);
        const aiScene* scene = importer.ReadFile(
            file, aiProcess_Triangulate | aiProcess_PreTransformVertices |
                      aiProcess_JoinIdenticalVertices | aiProcess_SortByPType);
        if (!scene) throw Error(file + ": " + importer.GetErrorString());
        return Converter(file, options).Convert(*scene);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw MachineError(file + ": out of memory");
    } catch (const std::exception& error) {  // Some readers of assimp throw what they like.
        throw Error(file + ": " + error.what());
    }
}

}  // namespace plumb
