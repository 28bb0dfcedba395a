#include "screen_space/antialiasing/deferred_shader.h"

#include <utility>

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
          model_(scene.light) {}

    Rgb Shade(int X, int Y) const {
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
        const Rgb rho = Albedo(scene_.materials[material], g.uv(X, Y));
        if (!options_.is_lit) {
            return model_.Shade(x, n, rho, [](const LightAt&) { return true; });
        }
        const Vec3 face = World(g.face_normal(X, Y).cast<double>());
        return model_.Shade(
            x, n, rho, [&](const LightAt& light) { return options_.is_lit(light, x, face); });
    }

    void operator()(std::span<const SampleToShade> samples, std::span<Rgb> colours) const {
        for (std::size_t i = 0; i < samples.size(); ++i) {
            colours[i] = Shade(samples[i].X, samples[i].Y);
            // What comes of it is compared, so that no compiler leaves it out; it is equal.
            for (int again = 1; again < options_.times; ++again) {
                const Rgb colour = Shade(samples[i].X, samples[i].Y);
                if (colour != colours[i]) colours[i] = colour;
            }
        }
    }

  private:
    Vec3 World(const Vec3& v) const {
        return v.x() * frame_.right + v.y() * frame_.up + v.z() * frame_.backward;
    }

    Rgb Albedo(const Material& material, const Vec2f& uv) const {
        Rgb rho = material.albedo;
        if (material.texture == Material::kNoTexture) return rho;
        const Rgb of_texture = SampleAlbedo(scene_.textures[std::size_t(material.texture)], uv);
        for (std::size_t c = 0; c < 3; ++c) rho[c] *= of_texture[c];
        return rho;
    }

    const Scene& scene_;
    Camera camera_;
    CameraFrame frame_;
    const WideGBuffer& g_;
    DeferredOptions options_;
    ShadingModel model_;
};

}  // namespace

SampleShader DeferredShader(const Scene& scene, const Camera& camera, const WideGBuffer& g,
                            const DeferredOptions& options) {
    if (options.times < 1) {
        throw Error(MustBe("DeferredOptions::times", options.times, "at least 1"));
    }
    return Shader(scene, camera, g, options);
}

}  // namespace plumb
