#include "io/mesh_io.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>

#include "core/error.h"
#include "io/far_mesh.h"
#include "io/mesh_header.h"
#include "io/mesh_materials.h"
#include "io/regular_file.h"
#include "io/try_in_child.h"
#include "io/whole_file.h"

namespace plumb {
namespace {

Vec3 Vector(const aiVector3D& v) {
    return {v.x, v.y, v.z};
}

Vec3 UpIsZ(const Vec3& p, UpAxis up) {
    switch (up) {
        case UpAxis::kX:
            return {p.y(), p.z(), p.x()};
        case UpAxis::kY:
            return {p.x(), -p.z(), p.y()};
        case UpAxis::kZ:
            return p;
    }
    return Vec3::Zero();
}

Vec3f UnitOrZero(const Vec3& n) {
    const double length = n.norm();
    if (!(length > 0 && std::isfinite(length))) return Vec3f::Zero();
    return Vec3(n / length).cast<float>();
}

// What assimp's readers warn of while one of these lives.
class Warnings {
  public:
    Warnings() {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
        Assimp::DefaultLogger::get()->attachStream(new Stream(lines_),
                                                   Assimp::Logger::Warn | Assimp::Logger::Err);
    }
    ~Warnings() { Assimp::DefaultLogger::kill(); }  // And the stream.
    Warnings(const Warnings&) = delete;

    const std::vector<std::string>& Lines() const { return lines_; }

  private:
    struct Stream : Assimp::LogStream {
        explicit Stream(std::vector<std::string>& lines_in) : lines(lines_in) {}
        void write(const char* message) override {
            std::string line = message;
            while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) {
                line.pop_back();
            }
            // "Warn,  T0: what"; and what every OBJ without an "o" line is told.
            if (const std::size_t colon = line.find(": "); colon < 12) line.erase(0, colon + 2);
            if (line.find("No object detected") != std::string::npos) return;
            if (lines.size() < kMostWarnings) lines.push_back(line);
        }
        std::vector<std::string>& lines;
    };

    static constexpr std::size_t kMostWarnings = 20;
    std::vector<std::string> lines_;
};

// Gives another text for one file.
class TextInstead final : public Assimp::DefaultIOSystem {
  public:
    TextInstead(std::string file, std::string text)
        : file_(std::move(file)), text_(std::move(text)) {}

    Assimp::IOStream* Open(const char* file, const char* mode) override {
        if (file != file_) return DefaultIOSystem::Open(file, mode);
        return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(text_.data()),
                                          text_.size());
    }

  private:
    std::string file_, text_;
};

bool IsObj(const std::string& file) {
    std::string ending = std::filesystem::path(file).extension().string();
    for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".obj";
}

// `origin`: what was taken from the vertices, in the file's own unit and axes.
const aiScene* Parse(Assimp::Importer& importer, const std::string& file, Vec3& origin) {
    origin = Vec3::Zero();
    if (IsObj(file)) {
        if (auto near = BringNear(ReadWholeFile(file))) {
            origin = near->origin;
            importer.SetIOHandler(new TextInstead(file, std::move(near->text)));
        }
    }
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    return importer.ReadFile(file, aiProcess_Triangulate | aiProcess_PreTransformVertices |
                                       aiProcess_JoinIdenticalVertices | aiProcess_SortByPType);
}

class Converter {
  public:
    Converter(const std::filesystem::path& path, const MeshFileOptions& options)
        : path_(path), file_(path.string()), options_(options) {}

    /// `origin`: as Parse() gives it.
    MeshFile Convert(const aiScene& scene, const Vec3& origin) {
        FindOrigin(scene, origin);
        if (scene.mNumMaterials > 65535) {
            throw Error(MustBe(file_ + ": materials", scene.mNumMaterials, "at most 65535"));
        }
        MeshMaterials read = ReadMaterials(scene, path_, options_);
        out_.materials = std::move(read.materials);
        out_.textures = std::move(read.textures);
        out_.notes.insert(out_.notes.end(), read.notes.begin(), read.notes.end());
        uv_channel_ = std::move(read.uv_channel);
        for (unsigned m = 0; m < scene.mNumMeshes; ++m) Add(*scene.mMeshes[m]);
        if (out_.mesh.quads.empty()) throw Error(file_ + ": no faces");
        if (!has_normals_) out_.mesh.normals.clear();
        if (!has_uvs_) out_.mesh.uvs.clear();
        return std::move(out_);
    }

  private:
    Vec3 PositionM(const Vec3& v) const { return options_.unit_m * UpIsZ(v, options_.up); }

    // Where the reader's numbers become those that are kept.
    void FindOrigin(const aiScene& scene, const Vec3& taken_before) {
        const Vec3 before_m = PositionM(taken_before);
        Eigen::AlignedBox3d box;
        for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
            for (unsigned v = 0; v < scene.mMeshes[m]->mNumVertices; ++v) {
                box.extend(PositionM(Vector(scene.mMeshes[m]->mVertices[v])));
            }
        }
        if (!box.isEmpty()) moved_m_ = OriginFor(box.min(), box.max());
        if (!moved_m_.allFinite()) moved_m_ = Vec3::Zero();  // Refused where it is added.
        out_.origin_m = before_m + moved_m_;
        if (!(out_.origin_m.cwiseAbs().maxCoeff() <= 1e15)) {
            throw Error(file_ + ": vertices must be at most 1e15 m from 0");
        }
        if (moved_m_.isZero(0)) return;
        const double extent_m = (box.max() - box.min()).maxCoeff();
        const double step_m = box.max().cwiseAbs().cwiseMax(box.min().cwiseAbs()).maxCoeff() *
                              double(std::numeric_limits<float>::epsilon());
        constexpr double kCoarse = 1e-5;
        if (step_m <= kCoarse * extent_m) return;
        std::ostringstream note;
        note << file_ << ": lies so far from the origin of its coordinates that its "
             << "vertices are rounded to steps of about " << step_m << " m, " << extent_m
             << " m of extent: move it nearer, or write it as OBJ";
        out_.notes.push_back(note.str());
    }

    void Add(const aiMesh& mesh) {
        if (mesh.mMaterialIndex >= out_.materials.size()) {
            throw Error(MustBe(file_ + ": mesh " + mesh.mName.C_Str() + ": material",
                               mesh.mMaterialIndex,
                               "< " + std::to_string(out_.materials.size())));
        }
        const std::size_t first = out_.mesh.vertices_m.size();
        if (first + mesh.mNumVertices > std::numeric_limits<std::uint32_t>::max()) {
            throw Error(file_ + ": more than 2^32 vertices");
        }
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const Vec3 p = PositionM(Vector(mesh.mVertices[v])) - moved_m_;
            if (!(p.cwiseAbs().maxCoeff() <= 1e15)) {  // Also if it is not a number.
                throw Error(file_ + ": mesh " + mesh.mName.C_Str() + ", vertex " +
                            std::to_string(v) + ": must be finite and at most 1e15 m from 0");
            }
            out_.mesh.vertices_m.push_back(p.cast<float>());
        }
        AddNormals(mesh);
        AddUvs(mesh);
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

    void AddNormals(const aiMesh& mesh) {
        has_normals_ = has_normals_ || mesh.HasNormals();
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const Vec3 n = mesh.HasNormals() ? UpIsZ(Vector(mesh.mNormals[v]), options_.up)
                                             : Vec3(0, 0, 0);
            out_.mesh.normals.push_back(UnitOrZero(n));
        }
    }

    void AddUvs(const aiMesh& mesh) {
        const Material& material = out_.materials[mesh.mMaterialIndex];
        const unsigned channel = uv_channel_[mesh.mMaterialIndex];
        const bool has_uvs =
            channel < AI_MAX_NUMBER_OF_TEXTURECOORDS && mesh.HasTextureCoords(channel);
        if (material.texture != Material::kNoTexture && !has_uvs) {
            out_.notes.push_back(file_ + ": mesh " + mesh.mName.C_Str() +
                                 ": no coordinates for its texture, its lower left corner "
                                 "everywhere");
        }
        has_uvs_ = has_uvs_ || has_uvs;
        bool bad = false;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            Vec2f uv = Vec2f::Zero();
            if (has_uvs) {
                const aiVector3D& from = mesh.mTextureCoords[channel][v];
                uv = Vec2f(from.x, from.y);
            }
            if (!uv.allFinite()) {
                bad = true;
                uv = Vec2f::Zero();
            }
            out_.mesh.uvs.push_back(uv);
        }
        if (bad) {
            out_.notes.push_back(file_ + ": mesh " + mesh.mName.C_Str() +
                                 ": texture coordinates that are not finite, 0 instead");
        }
    }

    std::filesystem::path path_;
    std::string file_;
    const MeshFileOptions& options_;
    std::vector<unsigned> uv_channel_;  // Of each material.
    bool has_normals_ = false, has_uvs_ = false;
    Vec3 moved_m_ = Vec3::Zero();  // Taken from what the reader gives.
    MeshFile out_;
};

// What reading a whole file may take: a gibibyte and 64 bytes for each of its own, ten seconds and
// one for each of its mebibytes. glTF's numbers are in files beside it.
ChildLimits LimitsFor(const std::filesystem::path& path) {
    std::uintmax_t bytes = RegularFileSize(path);
    std::error_code ignored;
    for (const auto& beside :
         std::filesystem::directory_iterator(path.parent_path() / ".", ignored)) {
        std::error_code no_size;
        const std::uintmax_t size = beside.path().extension() == ".bin"
                                        ? std::filesystem::file_size(beside.path(), no_size)
                                        : 0;
        if (!no_size) bytes += size;
    }
    const double mebibytes = double(bytes) / (1 << 20);
    ChildLimits limits;
    limits.memory_bytes += 64 * bytes;
    limits.cpu_s += mebibytes;
    limits.clock_s += 2 * mebibytes;
    return limits;
}

MeshFile ReadByAssimp(const std::filesystem::path& path, const MeshFileOptions& options) {
    const std::string file = path.string();
    try {
        const Warnings warnings;
        Assimp::Importer importer;
        Vec3 origin;
        const aiScene* scene = Parse(importer, file, origin);
        if (!scene) throw Error(file + ": " + importer.GetErrorString());
        for (const std::string& line : warnings.Lines()) {
            // assimp puts another vertex in its place and goes on.
            if (line.find("out of range") != std::string::npos) throw Error(file + ": " + line);
        }
        MeshFile read = Converter(path, options).Convert(*scene, origin);
        for (const std::string& line : warnings.Lines()) {
            read.notes.push_back(file + ": " + line);
        }
        return read;
    } catch (const Error&) {
        throw;
    } catch (const MachineError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {  // Some readers of assimp throw what they like.
        throw Error(file + ": " + error.what());
    }
}

// Tries it in a child; pictures are not assimp's business.
void CheckThatItEndsWell(const std::filesystem::path& path, MeshFileOptions options) {
    const ChildLimits limits = LimitsFor(path);
    options.textures = false;
    const ChildEnd end = TryInChild([&] { ReadByAssimp(path, options); }, limits);
    const std::string file = path.string();
    switch (end.kind) {
        case ChildEnd::Kind::kDone:
            return;
        case ChildEnd::Kind::kThrew:
            throw Error(end.what);
        case ChildEnd::Kind::kCrashed:
            throw Error(file + ": is damaged: its reader breaks down over it");
        case ChildEnd::Kind::kTooMuchMemory:
            throw Error(file + ": is damaged: reading it takes more than " +
                        std::to_string(limits.memory_bytes >> 20) +
                        " MiB, which no whole file of its size does");
        case ChildEnd::Kind::kTooLong:
            throw Error(file +
                        ": is damaged, or waits for what it refers to: reading it takes more "
                        "than " +
                        std::to_string(int(limits.cpu_s)) + " s");
    }
}

}  // namespace

MeshFile ReadMesh(const std::filesystem::path& path, const MeshFileOptions& options) {
    if (!(options.unit_m > 0 && std::isfinite(options.unit_m))) {
        throw Error(MustBe(path.string() + ": unit_m", options.unit_m, "> 0"));
    }
    CheckMeshHeader(path);
    try {
        CheckThatItEndsWell(path, options);
        return ReadByAssimp(path, options);
    } catch (const std::bad_alloc&) {
        throw MachineError(path.string() + ": out of memory");
    }
}

}  // namespace plumb
