// A ray caster of our own behind the interface of rays/ray_caster.h: coherent packets of rays
// through an axis-aligned BSP tree. It shares nothing with the Embree caster but that interface
// and the numbers of the triangles, so each checks the other.
//
// Rays that stand together in a span travel together, as many as a packet holds: hand them over
// in small squares of the picture. Those of one kind (signs of the direction, longest axis) make
// a packet; where few are of a kind they travel one by one. A ray's answer is the same bits in
// every company (packet_walk.h).
//
// With the watertight test the nearest hit is the least (t, triangle) over all triangles
// (walk_ray.h). Triangles without area are kept out and counted, as the interface has it.
//
// Source   [Wald01 sections 2 to 4].
// Beware   Rays whose direction is 0, or anything of which is NaN, meet nothing.
#pragma once

#include "core/mesh.h"
#include "core/monitor.h"
#include "core/scene.h"
#include "rays/packets/bsp_build.h"
#include "rays/packets/packet_scene.h"
#include "rays/ray_caster.h"

namespace plumb {

struct PacketOptions {
    TriangleTest test = TriangleTest::kWatertight;
    int rays = 16;          ///< Of a packet: 1 (no packets), 4, 16 or 64.
    int lanes = 16;         ///< Rays that are worked on at once: 4, 8, 16; fewer if the machine
                            ///< has fewer.
    bool mailboxes = true;  ///< mailboxes.h
    BspBuildOptions build = {};
};

/// Throws Error, naming the first field that breaks its range.
void Validate(const PacketOptions& options);

/// What a tree takes.
struct PacketTreeSize {
    std::int64_t nodes = 0;
    std::int64_t leaves = 0;   ///< Of them, empty ones too.
    std::int64_t entries = 0;  ///< Of all leaves' lists.
    std::int64_t bytes = 0;    ///< Nodes, lists and triangles.
    int depth = 0;
};

class PacketCaster final : public RayCaster {
  public:
    /// Throws Error if the mesh is not valid (rays/triangle.h), MachineError if its tree would
    /// be too large.
    explicit PacketCaster(const Mesh& mesh, const PacketOptions& options = {},
                          Monitor& monitor = SilentMonitor());

    /// With the holes of alpha-tested materials: the scene must then outlive the caster.
    explicit PacketCaster(const Scene& scene, const PacketOptions& options = {},
                          Monitor& monitor = SilentMonitor());

    void Closest(std::span<const Ray> rays, std::span<Hit> hits) const override;
    void Any(std::span<const Ray> rays, std::span<std::uint64_t> met) const override;
    void AnyFromPoint(const Ray& common, std::span<const Vec3f> directions,
                      std::span<std::uint64_t> met) const override;
    GeometryCounts Counts() const override { return counts_; }

    /// The same, and what the walks cost.
    WalkCounts CountedClosest(std::span<const Ray> rays, std::span<Hit> hits) const;
    WalkCounts CountedAny(std::span<const Ray> rays, std::span<std::uint64_t> met) const;

    PacketTreeSize Size() const;

  private:
    PacketCaster(const Mesh& mesh, const Scene* holes, const PacketOptions& options,
                 Monitor& monitor);

    PacketOptions options_;
    PacketScene scene_;
    GeometryCounts counts_;
};

}  // namespace plumb
