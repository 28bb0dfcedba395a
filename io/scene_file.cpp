#include "io/scene_file.h"

#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/conventions.h"
#include "core/error.h"
#include "io/json_file.h"
#include "io/mesh_io.h"
#include "io/picture_file.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

constexpr NumberRule kFieldOfView{"in (0, 180)", [](double x) { return 0 < x && x < 180; }};
constexpr NumberRule kPixels{"a whole number in [1, 65536]", [](double x) {
                                 return 1 <= x && x <= 65536 && x == std::floor(x);
                             }};

constexpr NumberRule kTiles{"a whole number in [0, 16]",
                            [](double x) { return 0 <= x && x <= 16 && x == std::floor(x); }};

class Reader {
  public:
    explicit Reader(const std::filesystem::path& path) : path_(path), file_(path.string()) {}

    SceneFile Read() {
        const Json json = ReadJsonFile(path_);
        out_.files.push_back(path_);
        out_.scene.name = path_.stem().string();
        JsonFields fields(json, file_);
        if (const auto name = fields.Text("name")) out_.scene.name = *name;
        ReadSurfaces(fields);
        ReadLight(fields);
        if (fields.IsList("cameras")) {
            out_.has_cameras = true;
            ReadEach(fields, "cameras", [&](JsonFields& camera) { ReadCamera(camera); });
        }
        if (fields.IsList("techniques")) {
            ReadEach(fields, "techniques",
                     [&](JsonFields& technique) { ReadTechnique(technique); });
        }
        fields.Finish();
        return std::move(out_);
    }

  private:
    template <class F>
    void ReadEach(JsonFields& fields, const char* list, const F& read) {
        std::size_t i = 0;
        for (const Json& item : fields.NeedList(list)) {
            JsonFields of_item(item, file_,
                               std::string(list) + "[" + std::to_string(i++) + "]");
            read(of_item);
            of_item.Finish();
        }
    }

    static std::vector<double> Three(const JsonFields& fields, const char* field,
                                     std::vector<double> numbers) {
        if (numbers.size() != 3) {
            throw Error(fields.NameOf(field) + " has " + std::to_string(numbers.size()) +
                        " numbers, must have 3");
        }
        return numbers;
    }

    // What goes wrong with another file says also which field asked for it.
    template <class F>
    static auto AskedFor(const std::string& field, const F& read) {
        try {
            return read();
        } catch (const Error& error) {
            throw Error(field + ": " + error.what());
        } catch (const MachineError& error) {
            throw MachineError(field + ": " + error.what());
        }
    }

    static Vec3 NeedVector(JsonFields& fields, const char* field) {
        const auto x = Three(fields, field, fields.NeedNumbers(field, kFinite));
        return {x[0], x[1], x[2]};
    }

    static std::optional<Rgb> Colour(JsonFields& fields, const char* field,
                                     const NumberRule& rule) {
        const auto numbers = fields.Numbers(field, rule);
        if (!numbers) return std::nullopt;
        const auto x = Three(fields, field, *numbers);
        return Rgb{float(x[0]), float(x[1]), float(x[2])};
    }

    static Rgb NeedColour(JsonFields& fields, const char* field) {
        const auto x = Three(fields, field, fields.NeedNumbers(field, kNotNegative));
        return {float(x[0]), float(x[1]), float(x[2])};
    }

    void ReadSurfaces(JsonFields& fields) {
        const auto generator = fields.Text("generator");
        const bool meshes = fields.IsList("meshes"), heights = fields.IsList("heights");
        if (generator.has_value() == (meshes || heights)) {
            throw Error(file_ + ": must have either generator, or meshes or heights");
        }
        if (generator) out_.generator = *generator;
        if (meshes) {
            ReadEach(fields, "meshes", [&](JsonFields& mesh) { ReadMeshEntry(mesh); });
        }
        if (heights) {
            ReadEach(fields, "heights", [&](JsonFields& field) { ReadHeightsEntry(field); });
        }
        if (!generator && out_.scene.mesh.quads.empty() && out_.heights.empty()) {
            throw Error(file_ + (meshes ? ": meshes is empty" : ": heights is empty"));
        }
    }

    void ReadHeightsEntry(JsonFields& fields) {
        HeightsEntry entry;
        entry.name = fields.NeedText("file");
        entry.asked_by = fields.NameOf("file");
        if (!entry.name.starts_with("make:")) {
            const std::filesystem::path map = path_.parent_path() / entry.name;
            entry.name = map.string();
            out_.files.push_back(map);
        }
        if (const auto albedo = Colour(fields, "albedo", kShare)) entry.albedo = *albedo;
        entry.amplitude_m = fields.Number("amplitude_m", kNotNegative);
        if (const auto tiles = fields.Number("tiles", kTiles)) entry.tiles = int(*tiles);
        out_.heights.push_back(std::move(entry));
    }

    void ReadMeshEntry(JsonFields& fields) {
        const std::filesystem::path mesh_path = path_.parent_path() / fields.NeedText("file");
        MeshFileOptions options;
        if (const auto unit_m = fields.Number("unit_m", kPositive)) options.unit_m = *unit_m;
        if (const auto up = fields.OneOf("up", {"x", "y", "z"})) {
            options.up = *up == "x" ? UpAxis::kX : *up == "y" ? UpAxis::kY : UpAxis::kZ;
        }
        const std::optional<Rgb> albedo = Colour(fields, "albedo", kShare);
        options.alpha_tested = fields.Flag("alpha_tested");
        options.textures = fields.Flag("textures").value_or(!albedo);
        if (albedo && options.textures) {
            throw Error(fields.NameOf("albedo") + " and textures: must be only one of them");
        }
        if (options.alpha_tested.value_or(false) && !options.textures) {
            throw Error(fields.NameOf("alpha_tested") + " without textures, must have them");
        }
        out_.files.push_back(mesh_path);
        Append(AskedFor(fields.NameOf("file"), [&] { return ReadMesh(mesh_path, options); }),
               albedo);
    }

    void Append(MeshFile read, const std::optional<Rgb>& albedo) {
        Scene& scene = out_.scene;
        const std::size_t vertex = scene.mesh.vertices_m.size();
        const std::size_t material = scene.materials.size();
        const std::size_t texture = scene.textures.size();
        if (vertex + read.mesh.vertices_m.size() > 0xffffffffu ||
            material + read.materials.size() > 0xffffu) {
            throw Error(file_ + ": more than 2^32 vertices or 65535 materials in all");
        }
        for (std::array<std::uint32_t, 4>& q : read.mesh.quads) {
            for (std::uint32_t& corner : q) corner += std::uint32_t(vertex);
        }
        for (std::uint16_t& m : read.material_of_face) m = std::uint16_t(m + material);
        for (Material& m : read.materials) {
            if (albedo) m.albedo = *albedo;
            if (m.texture != Material::kNoTexture) m.texture += int(texture);
        }
        if (vertex == 0 && !read.origin_m.isZero(0)) {
            out_.origin_m = read.origin_m;
            std::ostringstream note;
            note << std::setprecision(17) << file_ << ": all positions are kept relative to ("
                 << read.origin_m.x() << ", " << read.origin_m.y() << ", " << read.origin_m.z()
                 << ") m, because floats would round them there";
            out_.notes.push_back(note.str());
        }
        const Vec3 shift_m = read.origin_m - out_.origin_m;
        if (!shift_m.isZero(0)) {
            for (Vec3f& v : read.mesh.vertices_m)
                v = (v.cast<double>() + shift_m).cast<float>();
        }
        const auto append = [](auto& to, const auto& from) {
            to.insert(to.end(), from.begin(), from.end());
        };
        // Of vertices; those of a mesh without get zeros as soon as another has them.
        const auto append_of_vertices = [&](auto& to, const auto& from, const auto& zero) {
            if (to.empty() && from.empty()) return;
            to.resize(vertex, zero);
            append(to, from);
            to.resize(vertex + read.mesh.vertices_m.size(), zero);
        };
        append_of_vertices(scene.mesh.normals, read.mesh.normals, Vec3f(Vec3f::Zero()));
        append_of_vertices(scene.mesh.uvs, read.mesh.uvs, Vec2f(Vec2f::Zero()));
        append(scene.textures, read.textures);
        append(scene.mesh.vertices_m, read.mesh.vertices_m);
        append(scene.mesh.quads, read.mesh.quads);
        append(scene.material_of_face, read.material_of_face);
        append(scene.materials, read.materials);
        append(out_.notes, read.notes);
    }

    void ReadLight(JsonFields& fields) {
        SceneLight& light = out_.scene.light;
        if (const auto sky = Colour(fields, "sky", kNotNegative)) {
            light.sky = *sky;
            out_.has_light = true;
        }
        const auto picture = fields.Text("environment");
        const auto turn_deg = fields.Number("environment_turn_deg", kFinite);
        if (picture) {
            AskedFor(fields.NameOf("environment"), [&] {
                ReadEnvironment(path_.parent_path() / *picture, light.environment);
            });
        }
        if (turn_deg && !picture) {
            throw Error(fields.NameOf("environment_turn_deg") +
                        " without environment, must have one");
        }
        light.environment.turn_rad = turn_deg.value_or(0) * kPi / 180;
        if (fields.IsList("directional_lights")) {
            out_.has_light = true;
            ReadEach(fields, "directional_lights", [&](JsonFields& of) {
                const Vec3 towards = NeedVector(of, "towards");
                if (!(towards.norm() > 0)) {
                    throw Error(of.NameOf("towards") + " has no length, must have one");
                }
                light.directional.push_back(
                    {.towards = towards, .irradiance = NeedColour(of, "irradiance")});
            });
        }
        if (fields.IsList("point_lights")) {
            out_.has_light = true;
            ReadEach(fields, "point_lights", [&](JsonFields& of) {
                const Vec3 position_m = NeedVector(of, "position_m") - out_.origin_m;
                light.points.push_back(
                    {.position_m = position_m, .intensity = NeedColour(of, "intensity")});
            });
        }
    }

    void ReadEnvironment(const std::filesystem::path& path, Environment& environment) {
        Picture picture = ReadPictureFile(path);
        if (picture.had_bad_numbers) {
            out_.notes.push_back(path.string() +
                                 ": numbers that are not finite or negative, 0 instead");
        }
        environment.radiance = std::move(picture.linear);
        out_.files.push_back(path);
        out_.has_light = true;
    }

    void ReadCamera(JsonFields& fields) {
        Camera camera;
        camera.name = "camera_" + std::to_string(out_.scene.cameras.size());
        if (const auto name = fields.Text("name")) camera.name = *name;
        camera.position_m = NeedVector(fields, "position_m") - out_.origin_m;
        camera.target_m = NeedVector(fields, "target_m") - out_.origin_m;
        if (const auto up = fields.Numbers("up", kFinite)) {
            const auto x = Three(fields, "up", *up);
            camera.up = {x[0], x[1], x[2]};
        }
        camera.fov_rad = fields.NeedNumber("fov_deg", kFieldOfView) * kPi / 180;
        if (const auto w = fields.Number("width_px", kPixels)) camera.width_px = int(*w);
        if (const auto h = fields.Number("height_px", kPixels)) camera.height_px = int(*h);
        Validate(camera,
                 file_ + ": cameras[" + std::to_string(out_.scene.cameras.size()) + "]");
        out_.scene.cameras.push_back(camera);
    }

    void ReadTechnique(JsonFields& fields) {
        TechniqueEntry entry{
            .name = fields.NeedText("name"),
            .where = file_ + ": techniques[" + std::to_string(out_.techniques.size()) + "]",
            .values = fields.OtherScalars()};
        for (const TechniqueEntry& other : out_.techniques) {
            if (other.name == entry.name) {
                throw Error(fields.NameOf("name") + " = " + entry.name +
                            ", must be named once only");
            }
        }
        out_.techniques.push_back(std::move(entry));
    }

    std::filesystem::path path_;
    std::string file_;
    SceneFile out_;
};

}  // namespace

SceneFile ReadSceneFile(const std::filesystem::path& path) {
    return Reader(path).Read();
}

}  // namespace plumb
