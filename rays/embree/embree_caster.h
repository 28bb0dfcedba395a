// Embree behind the interface of rays/ray_caster.h.
//
// The scene is built ROBUST: without it 3.5 rays in a million pass between two triangles, and
// up to a fifth of those aimed at an edge. Quads stay quads (half the nodes of two triangles);
// faces with one half of no area, and triangles, are a second geometry. Zero-area triangles
// are kept out and counted: they have no normal to go on from. Faces with holes (alpha-tested)
// are geometries of their own, so that the others pay nothing for them.
//
// Source   Embree 3.13. Measured rates and leaks of its modes are in the tests and in
//          `plumb bench truth`.
// Beware   Rays aimed exactly at a vertex may still leak (13 000 in a million, as measured).
#pragma once

#include <memory>
#include <vector>

#include "core/mesh.h"
#include "core/scene.h"
#include "rays/ray_caster.h"

namespace plumb {

class EmbreeCaster final : public RayCaster {
  public:
    /// Copies what it needs of the mesh. Throws Error if the mesh is not valid (see
    /// rays/triangle.h), MachineError if memory runs out.
    explicit EmbreeCaster(const Mesh& mesh);

    /// The scene's mesh with the holes of its alpha-tested materials. If it has any, the scene
    /// must outlive the caster: its textures are asked at every hit.
    explicit EmbreeCaster(const Scene& scene);
    ~EmbreeCaster() override;

    void Closest(std::span<const Ray> rays, std::span<Hit> hits) const override;
    void Any(std::span<const Ray> rays, std::span<std::uint64_t> met) const override;
    void AnyFromPoint(const Ray& common, std::span<const Vec3f> directions,
                      std::span<std::uint64_t> met) const override;
    GeometryCounts Counts() const override { return counts_; }

  private:
    friend class EmbreeBareLoop;
    struct Tree;

    /// `holes` may be null.
    EmbreeCaster(const Mesh& mesh, const Scene* holes);

    std::unique_ptr<Tree> tree_;
    GeometryCounts counts_;
};

/// The yardstick of every speed that we report: nothing but Embree's own calls over rays that
/// lie ready in Embree's own layout. The caster must outlive it.
class EmbreeBareLoop {
  public:
    EmbreeBareLoop(const EmbreeCaster& caster, std::span<const Ray> rays);
    ~EmbreeBareLoop();

    /// Rays that meet something, by rtcIntersect1 and by rtcOccluded1, one after the other.
    std::int64_t Closest(std::size_t begin, std::size_t end) const;
    std::int64_t Any(std::size_t begin, std::size_t end) const;

    /// The same by rtcOccluded1M, `stream` rays at once. Embree writes into the rays: Refill()
    /// makes those of all ready again.
    std::int64_t AnyStream(std::size_t begin, std::size_t end, std::size_t stream = 256);
    void Refill();

  private:
    struct Rays;
    const EmbreeCaster& caster_;
    std::unique_ptr<Rays> rays_;
};

}  // namespace plumb
