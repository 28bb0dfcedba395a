#include "screen_space/antialiasing/deferred_shader.h"

#include <memory>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/texture.h"

namespace plumb {
namespace {

class Shader {
  public:
    Shader(const Scene& scene, const Camera& camera, const WideGBuffer& g,
           DeferredOptions options)
        : scene_(scene),
          camera_(camera),
          frame_(camera),
          g_(g),
          options_(std::move(options)),
          model_(scene.light) {
        if (options_.filter == TextureFilter::kNone) return;
        auto levels = std::make_shared<std::vector<MipChain>>();
        for (const Texture& texture : scene.textures) levels->emplace_back(texture);
        levels_ = levels;
    }

    Rgb Shade(const SampleToShade& sample) const {
        const int X = sample.X, Y = sample.Y;
        const GBuffer& g = g_.samples;
        const std::uint16_t material = g_.material(X, Y);
        if (material == WideGBuffer::kNoMaterial) {
            const double m = g_.m;
            return SkyRadiance(scene_.light,
                               frame_.Direction(camera_, (X + 0.5) / m, (Y + 0.5) / m));
        }
        const Vec3 x =
            camera_.position_m + World(g.view.Point(X + 0.5, Y + 0.5, double(g.z_m(X, Y))));
        const Vec3 n = World(g.shading_normal(X, Y).cast<double>());
        const Rgb rho = Albedo(scene_.materials[material], sample);
        if (!options_.is_lit) {
            return model_.Shade(x, n, rho, [](const LightAt&) { return true; });
        }
        const Vec3 face = World(g.face_normal(X, Y).cast<double>());
        return model_.Shade(
            x, n, rho, [&](const LightAt& light) { return options_.is_lit(light, x, face); });
    }

    void operator()(std::span<const SampleToShade> samples, std::span<Rgb> colours) const {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            colours[i] = Shade(samples[i]);
            // What comes of it is compared, so that no compiler leaves it out; it is equal.
            for (int again = 1; again < options_.times; ++again) {
                const Rgb colour = Shade(samples[i]);
                if (colour != colours[i]) colours[i] = colour;
            }
        }
    }

  private:
    Vec3 World(const Vec3& v) const {
        return v.x() * frame_.right + v.y() * frame_.up + v.z() * frame_.backward;
    }

    Rgb Albedo(const Material& material, const SampleToShade& sample) const {
        Rgb rho = material.albedo;
        if (material.texture == Material::kNoTexture) return rho;
        const Rgb of_texture = TextureAt(std::size_t(material.texture), sample);
        for (std::size_t c = 0; c < 3; ++c) rho[c] *= of_texture[c];
        return rho;
    }

    Rgb TextureAt(std::size_t number, const SampleToShade& sample) const {
        const Vec2f& uv = g_.samples.uv(sample.X, sample.Y);
        if (!levels_) return SampleAlbedo(scene_.textures[number], uv);
        const Footprint one = FootprintOf(g_, sample.X, sample.Y, options_.footprint);
        return SampleFootprint((*levels_)[number], uv,
                               one.Scaled(SampleSpacing(g_.m, sample.of_pixel)),
                               options_.most_taps);
    }

    const Scene& scene_;
    Camera camera_;
    CameraFrame frame_;
    const WideGBuffer& g_;
    DeferredOptions options_;
    ShadingModel model_;
    std::shared_ptr<const std::vector<MipChain>>
        levels_;  ///< Of each texture; null: no filter.
};

}  // namespace

SampleShader DeferredShader(const Scene& scene, const Camera& camera, const WideGBuffer& g,
                            const DeferredOptions& options) {
    if (options.times < 1) {
        throw Error(MustBe("DeferredOptions::times", options.times, "at least 1"));
    }
    if (options.most_taps < 1 || options.most_taps > 64) {
        throw Error(MustBe("DeferredOptions::most_taps", options.most_taps, "in [1, 64]"));
    }
    return Shader(scene, camera, g, options);
}

}  // namespace plumb
