#include "screen_space/raster/draw_gbuffer.h"

#include <algorithm>
#include <optional>

#include "core/parallel.h"
#include "core/surface.h"
#include "screen_space/raster/seen_triangle.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 8;

// What all pixels of a triangle share.
struct Seen {
    std::uint32_t triangle;
    std::array<std::uint32_t, 3> corners;
    SeenTriangle plane;
    Vec3 normal;        // In the camera's frame.
    Vec3 world_normal;  // The same in the scene's.

    Seen(std::uint32_t number, const Mesh& mesh, const std::vector<ScreenVertex>& vertices,
         const CameraFrame& frame)
        : triangle(number),
          corners(CornersOf(mesh, number)),
          plane({vertices[corners[0]].P, vertices[corners[1]].P, vertices[corners[2]].P}),
          normal(plane.Normal()),
          world_normal(normal.x() * frame.right + normal.y() * frame.up +
                       normal.z() * frame.backward) {}
};

template <class T>
void Resize(Image<T>& image, int width, int height, const T& value) {
    if (image.Width() == width && image.Height() == height) return;
    image = Image<T>(width, height, value);
}

class Resolver {
  public:
    Resolver(const Scene& scene, const Camera& camera, const RasterOptions& options,
             const VisibilityBuffer& seen, const std::vector<ScreenVertex>& vertices,
             GBuffer& out)
        : scene_(scene),
          options_(options),
          seen_(seen),
          vertices_(vertices),
          frame_(camera),
          out_(out) {
        const int width = seen.view.DrawnWidth(), height = seen.view.DrawnHeight();
        out.view = seen.view;
        out.format = seen.format;
        out.range = seen.range;
        out.depth = seen.depth;
        out.triangle = seen.triangle;
        Resize(out.z_m, width, height, GBuffer::kSkyZ);
        Resize(out.face_normal, width, height, Vec3f(0, 0, 0));
        Resize(out.shading_normal, width, height, Vec3f(0, 0, 0));
        Resize(out.albedo, options.albedo ? width : 0, options.albedo ? height : 0, Rgb{});
        const int uv_width = options.texture_coordinates ? width : 0;
        const int uv_height = options.texture_coordinates ? height : 0;
        Resize(out.uv, uv_width, uv_height, Vec2f(0, 0));
        Resize(out.uv_per_x_px, uv_width, uv_height, Vec2f(0, 0));
        Resize(out.uv_per_y_px, uv_width, uv_height, Vec2f(0, 0));
    }

    void Resolve() {
        ParallelFor(seen_.view.DrawnHeight(), kRowsAtATime,
                    [&](std::int64_t begin, std::int64_t end) {
                        for (int j = int(begin); j < int(end); ++j) Row(j);
                    });
    }

  private:
    void Row(int j) {
        std::optional<Seen> here;
        for (int i = 0; i < seen_.view.DrawnWidth(); ++i) {
            const std::uint32_t triangle = seen_.triangle(i, j);
            if (triangle == GBuffer::kSky) {
                Sky(i, j);
                continue;
            }
            if (!here || triangle != here->triangle) {
                here.emplace(triangle, scene_.mesh, vertices_, frame_);
            }
            Pixel(*here, i, j);
        }
    }

    void Sky(int i, int j) {
        out_.z_m(i, j) = GBuffer::kSkyZ;
        out_.face_normal(i, j) = out_.shading_normal(i, j) = Vec3f::Zero();
        if (options_.albedo) out_.albedo(i, j) = {};
        if (options_.texture_coordinates) NoTextureCoordinates(i, j);
    }

    void NoTextureCoordinates(int i, int j) {
        out_.uv(i, j) = out_.uv_per_x_px(i, j) = out_.uv_per_y_px(i, j) = Vec2f::Zero();
    }

    void Pixel(const Seen& here, int i, int j) {
        const Vec3 b = here.plane.Weights(seen_.view, i + 0.5, j + 0.5);
        out_.z_m(i, j) =
            options_.z == ZSource::kStored ? StoredZ(i, j) : SurfaceZ(here.plane.PointM(b).z());
        out_.face_normal(i, j) = here.normal.cast<float>();
        if (scene_.mesh.normals.empty()) {
            out_.shading_normal(i, j) = out_.face_normal(i, j);
        } else {
            const Vec3 n =
                ShadingNormalAt(scene_.mesh, here.triangle, b[1], b[2], here.world_normal);
            out_.shading_normal(i, j) =
                Vec3(n.dot(frame_.right), n.dot(frame_.up), n.dot(frame_.backward))
                    .cast<float>();
        }
        if (options_.albedo) out_.albedo(i, j) = AlbedoAt(scene_, here.triangle, b[1], b[2]);
        if (!options_.texture_coordinates) return;
        if (scene_.mesh.uvs.empty()) {
            NoTextureCoordinates(i, j);
        } else {
            TextureCoordinates(here, b, i, j);
        }
    }

    float SurfaceZ(double z) const { return float(std::min(z, -seen_.range.near_m)); }

    float StoredZ(int i, int j) const {
        const double d = DecodeDepth(seen_.format, seen_.depth(i, j));
        return ReconstructZ(seen_.format, seen_.range, float(d));
    }

    void TextureCoordinates(const Seen& here, const Vec3& b, int i, int j) {
        out_.uv(i, j) = UvAt(scene_.mesh, here.triangle, b[1], b[2]);
        for (int axis = 0; axis < 2; ++axis) {
            Vec3 values;
            for (int k = 0; k < 3; ++k) {
                values[k] = scene_.mesh.uvs[here.corners[std::size_t(k)]][axis];
            }
            const Vec2 slope = here.plane.Derivatives(seen_.view, i + 0.5, j + 0.5, values);
            out_.uv_per_x_px(i, j)[axis] = float(slope.x());
            out_.uv_per_y_px(i, j)[axis] = float(slope.y());
        }
    }

    const Scene& scene_;
    const RasterOptions& options_;
    const VisibilityBuffer& seen_;
    const std::vector<ScreenVertex>& vertices_;
    CameraFrame frame_;
    GBuffer& out_;
};

}  // namespace

AlphaTest AlphaTestOf(const Scene& scene) {
    return {.tested = [&](std::uint32_t face) { return IsAlphaTested(scene, face); },
            .solid = [&](std::uint32_t triangle, double b_1,
                         double b_2) { return IsSolidAt(scene, triangle, b_1, b_2); }};
}

GBuffer DrawGBuffer(const Scene& scene, const Camera& camera, const RasterOptions& options) {
    Rasterizer rasterizer;
    GBuffer out;
    DrawGBuffer(rasterizer, scene, camera, options, out);
    return out;
}

void DrawGBuffer(Rasterizer& rasterizer, const Scene& scene, const Camera& camera,
                 const RasterOptions& options, GBuffer& out) {
    const bool holes =
        std::any_of(scene.materials.begin(), scene.materials.end(),
                    [](const Material& material) { return material.alpha_tested; });
    const AlphaTest alpha_test = AlphaTestOf(scene);
    const VisibilityBuffer& seen =
        rasterizer.Draw(scene.mesh, camera, options, true, holes ? &alpha_test : nullptr);
    Resolver(scene, camera, options, seen, rasterizer.Vertices(), out).Resolve();
}

}  // namespace plumb
