#include "screen_space/antialiasing/wide_gbuffer.h"

#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/windows.h"
#include "screen_space/raster/draw_gbuffer.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 16;
constexpr std::size_t kMostMaterials8Bit = 255;  // One value is the sky's.

template <class EachSample>
void ForEachSample(const GBuffer& g, const EachSample& each) {
    ParallelFor(g.z_m.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int Y = int(begin); Y < int(end); ++Y) {
            for (int X = 0; X < g.z_m.Width(); ++X) each(X, Y);
        }
    });
}

Image<std::uint16_t> Materials(const Scene& scene, const GBuffer& g) {
    Image<std::uint16_t> material(g.z_m.Width(), g.z_m.Height(), WideGBuffer::kNoMaterial);
    ForEachSample(g, [&](int X, int Y) {
        const std::uint32_t triangle = g.triangle(X, Y);
        if (triangle != GBuffer::kSky) {
            material(X, Y) = scene.material_of_face[triangle / 2];
        }
    });
    return material;
}

// Its place within one repeat, in 16 bits.
float StoredCoordinate(float u) {
    const double within = u - std::floor(double(u));
    return float(std::floor(within * 65535 + 0.5) / 65535);
}

void StoreIn8Bits(GBuffer& g) {
    ForEachSample(g, [&](int X, int Y) {
        g.face_normal(X, Y) = ByteNormal(g.face_normal(X, Y));
        g.shading_normal(X, Y) = ByteNormal(g.shading_normal(X, Y));
        Vec2f& uv = g.uv(X, Y);
        uv = {StoredCoordinate(uv.x()), StoredCoordinate(uv.y())};
    });
}

}  // namespace

Vec3f ByteNormal(const Vec3f& n) {
    if (n.isZero(0)) return n;
    Vec3f out;
    for (int axis = 0; axis < 3; ++axis) {
        const double byte = std::floor((double(n[axis]) + 1) / 2 * 255 + 0.5);
        out[axis] = float(byte / 255 * 2 - 1);
    }
    return out;
}

WideGBuffer DrawWideGBuffer(const Scene& scene, const Camera& camera,
                            const WideOptions& options) {
    CheckEnlargement(options.m);
    Validate(camera);
    if (options.format == GBufferFormat::k8Bit && scene.materials.size() > kMostMaterials8Bit) {
        throw Error(MustBe("materials of a G-buffer of 8 bits a channel",
                           double(scene.materials.size()), "at most 255"));
    }
    Camera wide = camera;
    wide.width_px *= options.m;
    wide.height_px *= options.m;
    RasterOptions raster;
    raster.depth = options.depth;
    raster.range = options.range;
    raster.albedo = false;
    raster.texture_coordinates = true;
    WideGBuffer out;
    out.m = options.m;
    out.samples = DrawGBuffer(scene, wide, raster);
    out.material = Materials(scene, out.samples);
    if (options.format == GBufferFormat::k8Bit) StoreIn8Bits(out.samples);
    return out;
}

}  // namespace plumb
