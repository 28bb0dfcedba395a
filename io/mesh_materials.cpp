#include "io/mesh_materials.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <assimp/texture.h>

#include <algorithm>
#include <map>
#include <utility>

#include "core/error.h"
#include "io/picture_file.h"

namespace plumb {
namespace {

// A texture that a material names: which picture, and how it lies on the surface.
struct Named {
    std::string path;  // Empty: none.
    unsigned uv_channel = 0;
    bool repeats = true;
};

Named NamedTexture(const aiMaterial& material, std::initializer_list<aiTextureType> types) {
    for (const aiTextureType type : types) {
        if (material.GetTextureCount(type) == 0) continue;
        aiString path;
        Named named;
        aiTextureMapMode modes[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap,
                                     aiTextureMapMode_Wrap};
        if (material.GetTexture(type, 0, &path, nullptr, &named.uv_channel, nullptr, nullptr,
                                modes) != aiReturn_SUCCESS) {
            continue;
        }
        named.path = path.C_Str();
        named.repeats = modes[0] == aiTextureMapMode_Wrap && modes[1] == aiTextureMapMode_Wrap;
        if (!named.path.empty()) return named;
    }
    return {};
}

// What a glTF says of its textures' opacity.
struct Mask {
    bool is_one = false;
    float cutoff = kSolidOpacity;
};

Mask MaskOf(const aiMaterial& material) {
    Mask mask;
    aiString mode;
    mask.is_one = material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS &&
                  std::string(mode.C_Str()) == "MASK";
    material.Get(AI_MATKEY_GLTF_ALPHACUTOFF, mask.cutoff);
    return mask;
}

class MaterialReader {
  public:
    MaterialReader(const aiScene& scene, const std::filesystem::path& mesh_path,
                   const MeshFileOptions& options)
        : scene_(scene), mesh_path_(mesh_path), options_(options) {}

    MeshMaterials Read() {
        for (unsigned m = 0; m < scene_.mNumMaterials; ++m) Add(*scene_.mMaterials[m]);
        return std::move(out_);
    }

  private:
    void Note(const Material& material, const std::string& what) {
        out_.notes.push_back(mesh_path_.string() + ": material " + material.name + ": " + what);
    }

    void Add(const aiMaterial& from) {
        Material material;
        material.name = from.GetName().C_Str();
        ReadColour(from, material);
        Named colours = NamedTexture(from, {aiTextureType_DIFFUSE, aiTextureType_BASE_COLOR});
        Named opacity = NamedTexture(from, {aiTextureType_OPACITY});
        const Mask mask = MaskOf(from);
        if (!options_.textures) {
            if (!colours.path.empty() || !opacity.path.empty()) {
                Note(material, "texture left out as asked, constant colour instead");
            }
            colours = opacity = {};
        }
        const Named& shown = colours.path.empty() ? opacity : colours;
        if (!shown.repeats) Note(material, "texture repeats here, the file says otherwise");
        if (!shown.path.empty()) {
            material.texture = TextureOf(colours.path, opacity.path, material);
            material.alpha_tested = IsAlphaTested(mask, material, !opacity.path.empty());
        }
        out_.uv_channel.push_back(shown.uv_channel);
        out_.materials.push_back(std::move(material));
    }

    void ReadColour(const aiMaterial& from, Material& material) {
        aiColor4D colour(0.8f, 0.8f, 0.8f, 1.0f);
        if (from.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS) {
            from.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
        }
        const float channels[] = {colour.r, colour.g, colour.b};
        bool clamped = false;
        for (std::size_t c = 0; c < 3; ++c) {
            clamped = clamped || !(channels[c] >= 0 && channels[c] <= 1);
            // In this order what is not a number becomes 0.
            material.albedo[c] = std::min(1.0f, std::max(0.0f, channels[c]));
        }
        if (clamped) Note(material, "colour out of [0, 1], clamped");
    }

    bool IsAlphaTested(const Mask& mask, const Material& material, bool has_map) {
        if (out_.textures[std::size_t(material.texture)].opacity.Empty()) return false;
        if (options_.alpha_tested) return *options_.alpha_tested;
        if (mask.is_one && mask.cutoff != kSolidOpacity) {
            Note(material, "alpha cutoff " + std::to_string(mask.cutoff) + ", 0.5 here");
        }
        return mask.is_one || has_map;
    }

    // Number of the texture with these pictures, read if it is new.
    int TextureOf(const std::string& colours, const std::string& opacity,
                  const Material& material) {
        const auto [at, is_new] =
            numbers_.try_emplace({colours, opacity}, int(out_.textures.size()));
        if (!is_new) return at->second;
        Texture texture;
        texture.name = colours.empty() ? opacity : colours;
        if (!colours.empty()) {
            Picture picture = ReadOne(colours, PictureOf::kColours, material);
            texture.albedo = std::move(picture.linear);
            texture.opacity = std::move(picture.opacity);
        }
        if (!opacity.empty()) {
            TakeOpacity(ReadOne(opacity, PictureOf::kNumbers, material), texture);
        }
        bool clamped = false;
        for (Rgb& pixel : texture.albedo.Pixels()) {
            for (float& value : pixel) {
                clamped = clamped || value > 1;
                value = std::min(1.0f, value);
            }
        }
        if (clamped) Note(material, "texture " + texture.name + " exceeds 1, clamped");
        out_.textures.push_back(std::move(texture));
        return at->second;
    }

    Picture ReadOne(const std::string& name, PictureOf of, const Material& material) {
        const std::string whole =
            mesh_path_.string() + ": material " + material.name + ": texture " + name;
        Picture picture;
        try {
            picture = Decode(name, of, whole);
        } catch (const Error& error) {
            const std::string what = error.what();
            throw Error((what.starts_with(whole) ? "" : whole + ": ") + what);
        }
        if (picture.had_bad_numbers) {
            Note(material, "texture " + name + " has numbers that are no colours, 0 instead");
        }
        return picture;
    }

    Picture Decode(const std::string& name, PictureOf of, const std::string& whole) const {
        if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str())) {
            return Embedded(*embedded, of, whole);
        }
        std::string path = name;
        std::ranges::replace(path, '\\', '/');  // As Windows writes them.
        return ReadPictureFile(mesh_path_.parent_path() / path, of);
    }

    static Picture Embedded(const aiTexture& texture, PictureOf of, const std::string& whole) {
        if (texture.pcData == nullptr) throw Error(whole + ": is empty");
        if (texture.mHeight == 0) {  // A file of mWidth bytes.
            return DecodePicture(
                {reinterpret_cast<const char*>(texture.pcData), texture.mWidth},
                whole + "." + texture.achFormatHint, of);
        }
        throw Error(whole + ": is embedded as bare texels, must be a PNG, JPEG or other file");
    }

    // The grey of a picture, or its own opacity if it has one, as the opacity of a texture.
    static void TakeOpacity(Picture from, Texture& texture) {
        Texture mask;
        mask.opacity = std::move(from.opacity);
        if (mask.opacity.Empty()) {
            mask.opacity = Image<float>(from.linear.Width(), from.linear.Height());
            for (std::size_t p = 0; p < mask.opacity.Pixels().size(); ++p) {
                mask.opacity.Pixels()[p] = std::min(1.0f, from.linear.Pixels()[p][1]);
            }
        }
        if (texture.albedo.Empty()) {
            texture.albedo =
                Image<Rgb>(mask.opacity.Width(), mask.opacity.Height(), Rgb{1, 1, 1});
        }
        const int w = texture.albedo.Width(), h = texture.albedo.Height();
        if (w == mask.opacity.Width() && h == mask.opacity.Height()) {
            texture.opacity = std::move(mask.opacity);
            return;
        }
        texture.opacity = Image<float>(w, h);
        for (int j = 0; j < h; ++j) {
            for (int i = 0; i < w; ++i) {
                const Vec2 uv((i + 0.5) / w, 1 - (j + 0.5) / h);
                texture.opacity(i, j) = SampleOpacity(mask, uv.cast<float>());
            }
        }
    }

    const aiScene& scene_;
    const std::filesystem::path& mesh_path_;
    const MeshFileOptions& options_;
    std::map<std::pair<std::string, std::string>, int> numbers_;
    MeshMaterials out_;
};

}  // namespace

MeshMaterials ReadMaterials(const aiScene& scene, const std::filesystem::path& mesh_path,
                            const MeshFileOptions& options) {
    return MaterialReader(scene, mesh_path, options).Read();
}

}  // namespace plumb
