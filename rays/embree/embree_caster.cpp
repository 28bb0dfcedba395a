#include "rays/embree/embree_caster.h"

#include <embree3/rtcore.h>
#include <xmmintrin.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>

#include "core/error.h"
#include "core/surface.h"
#include "rays/triangle.h"

namespace plumb {
namespace {

// Geometry numbers. What has holes comes last.
constexpr unsigned kQuads = 0, kTriangles = 1, kQuadsWithHoles = 2, kTrianglesWithHoles = 3;
constexpr unsigned kGeometries = 4;
constexpr std::size_t kStream = 256;  // Rays handed to Embree at once.
constexpr float kDiagonal = 1e-5f;    // As near to a quad's diagonal as rounding may mislead.

// Embree wants denormals off while it works; nobody else gets to see that.
class DenormalsOff {
  public:
    DenormalsOff() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
    ~DenormalsOff() { _mm_setcsr(before_); }
    DenormalsOff(const DenormalsOff&) = delete;

  private:
    unsigned before_;
};

RTCRay EmbreeRay(const Ray& ray) {
    RTCRay out;
    out.org_x = ray.origin_m.x();
    out.org_y = ray.origin_m.y();
    out.org_z = ray.origin_m.z();
    out.tnear = ray.near;
    out.dir_x = ray.direction.x();
    out.dir_y = ray.direction.y();
    out.dir_z = ray.direction.z();
    out.time = 0;
    out.tfar = ray.far;
    out.mask = ~0u;  // Debian's Embree tests masks: 0 would meet nothing.
    out.id = 0;
    out.flags = 0;
    return out;
}

bool WasMet(const RTCRay& ray) {
    return ray.tfar == -std::numeric_limits<float>::infinity();
}

RTCIntersectContext NewContext() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    return context;
}

bool HasArea(const Mesh& mesh, std::uint32_t triangle) {
    return TriangleOf(mesh, triangle).Cross().squaredNorm() > 0;
}

}  // namespace

struct EmbreeCaster::Tree {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    // Of each geometry: the first triangle of primitive i. Empty if that is 2 i.
    std::array<std::vector<std::uint32_t>, kGeometries> triangle;
    const plumb::Scene* holes = nullptr;  // Null: there are none.

    ~Tree() {
        if (scene) rtcReleaseScene(scene);
        if (device) rtcReleaseDevice(device);
    }

    // Throws what Embree has to complain of.
    void Check(const char* doing) const {
        const RTCError error = rtcGetDeviceError(device);
        if (error == RTC_ERROR_NONE) return;
        const char* what = error == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : "error ";
        throw MachineError(std::string("Embree, ") + doing + ": " + what +
                           (error == RTC_ERROR_OUT_OF_MEMORY ? "" : std::to_string(error)));
    }

    template <std::size_t kCorners>
    void AddGeometry(unsigned number, RTCGeometryType type, RTCFormat format, RTCBuffer points,
                     std::size_t points_count,
                     const std::vector<std::array<std::uint32_t, kCorners>>& faces) {
        if (faces.empty()) return;
        RTCGeometry geometry = rtcNewGeometry(device, type);
        rtcSetGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, points, 0,
                             sizeof(Vec3f), points_count);
        void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, format,
                                                sizeof faces[0], faces.size());
        if (indices) std::memcpy(indices, faces.data(), faces.size() * sizeof faces[0]);
        if (number == kQuadsWithHoles || number == kTrianglesWithHoles) {
            rtcSetGeometryUserData(geometry, this);
            rtcSetGeometryIntersectFilterFunction(geometry, RefuseHoles);
            rtcSetGeometryOccludedFilterFunction(geometry, RefuseHoles);
        }
        rtcCommitGeometry(geometry);
        rtcAttachGeometryByID(scene, geometry, number);
        rtcReleaseGeometry(geometry);
        Check("taking a mesh");
    }

    // On the diagonal itself rounding hides which half it was; the normal still tells.
    bool IsSecondHalf(const RTCHit& hit) const {
        const RTCGeometry quads = rtcGetGeometry(scene, hit.geomID);
        const auto* points = static_cast<const Vec3f*>(
            rtcGetGeometryBufferData(quads, RTC_BUFFER_TYPE_VERTEX, 0));
        const auto* corners = static_cast<const std::array<std::uint32_t, 4>*>(
            rtcGetGeometryBufferData(quads, RTC_BUFFER_TYPE_INDEX, 0));
        const std::array<std::uint32_t, 4>& q = corners[hit.primID];
        const Vec3f a = points[q[0]], b = points[q[1]], c = points[q[2]], d = points[q[3]];
        const Vec3f n(hit.Ng_x, hit.Ng_y, hit.Ng_z);
        const Vec3f first = (b - a).cross(d - a).normalized();
        const Vec3f second = (d - c).cross(b - c).normalized();
        return std::abs(n.dot(second)) > std::abs(n.dot(first));
    }

    // Which triangle was met, and where on it.
    Hit Place(const RTCHit& found) const {
        Hit hit;
        const std::vector<std::uint32_t>& first = triangle[found.geomID];
        hit.triangle = first.empty() ? 2 * found.primID : first[found.primID];
        hit.b_1 = found.u;
        hit.b_2 = found.v;
        if (found.geomID != kQuads && found.geomID != kQuadsWithHoles) return hit;
        // Embree gives one (u, v) over both halves of a quad; beyond the diagonal the second
        // half's own coordinates are 1 - u and 1 - v.
        const float over = found.u + found.v - 1;
        const bool second = std::abs(over) > kDiagonal ? over > 0 : IsSecondHalf(found);
        if (second) {
            ++hit.triangle;
            hit.b_1 = 1 - hit.b_1;
            hit.b_2 = 1 - hit.b_2;
        }
        return hit;
    }

    Hit ToHit(const RTCRayHit& found) const {
        if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        Hit hit = Place(found.hit);
        hit.t = found.ray.tfar;
        return hit;
    }

    // Asked by Embree at every hit of a face that may have a hole there.
    static void RefuseHoles(const RTCFilterFunctionNArguments* asked) {
        const Tree& tree = *static_cast<const Tree*>(asked->geometryUserPtr);
        for (unsigned i = 0; i < asked->N; ++i) {
            if (asked->valid[i] != -1) continue;
            const Hit hit = tree.Place(rtcGetHitFromHitN(asked->hit, asked->N, i));
            if (!IsSolidAt(*tree.holes, hit.triangle, hit.b_1, hit.b_2)) asked->valid[i] = 0;
        }
    }
};

EmbreeCaster::EmbreeCaster(const Mesh& mesh) : EmbreeCaster(mesh, nullptr) {}

EmbreeCaster::EmbreeCaster(const Scene& scene) : EmbreeCaster(scene.mesh, &scene) {}

EmbreeCaster::EmbreeCaster(const Mesh& mesh, const Scene* holes)
    : tree_(std::make_unique<Tree>()) {
    Validate(mesh);
    counts_.faces = std::int64_t(mesh.quads.size());
    tree_->holes = holes;

    std::array<std::vector<std::array<std::uint32_t, 4>>, 2> quads;  // Without, with holes.
    std::array<std::vector<std::array<std::uint32_t, 3>>, 2> triangles;
    for (std::uint32_t f = 0; f < mesh.quads.size(); ++f) {
        const std::array<std::uint32_t, 4>& q = mesh.quads[f];
        const bool is_triangle = q[2] == q[3];
        const bool first = HasArea(mesh, 2 * f);
        const bool second = !is_triangle && HasArea(mesh, 2 * f + 1);
        counts_.triangles += first + second;
        counts_.zero_area += !first + (!is_triangle && !second);
        if (!first && !second) continue;
        const unsigned h = holes != nullptr && IsAlphaTested(*holes, f) ? 1 : 0;
        const bool both = first && second;
        const unsigned number = both ? (h == 0 ? kQuads : kQuadsWithHoles)
                                     : (h == 0 ? kTriangles : kTrianglesWithHoles);
        tree_->triangle[number].push_back(first ? 2 * f : 2 * f + 1);
        if (both) {
            quads[h].push_back(q);
        } else if (first) {
            triangles[h].push_back({q[0], q[1], q[3]});
        } else {
            triangles[h].push_back({q[2], q[3], q[1]});
        }
    }
    if (quads[0].size() == mesh.quads.size()) tree_->triangle[kQuads] = {};

    tree_->device = rtcNewDevice(nullptr);
    if (!tree_->device) throw MachineError("Embree: no device");
    tree_->scene = rtcNewScene(tree_->device);
    rtcSetSceneFlags(tree_->scene, RTC_SCENE_FLAG_ROBUST);
    // Embree reads 16 bytes at every vertex, the last one too.
    RTCBuffer points = rtcNewBuffer(tree_->device, mesh.vertices_m.size() * sizeof(Vec3f) + 4);
    tree_->Check("taking the vertices");
    if (!mesh.vertices_m.empty()) {
        std::memcpy(rtcGetBufferData(points), mesh.vertices_m.data(),
                    mesh.vertices_m.size() * sizeof(Vec3f));
    }
    for (const unsigned h : {0u, 1u}) {
        tree_->AddGeometry(h == 0 ? kQuads : kQuadsWithHoles, RTC_GEOMETRY_TYPE_QUAD,
                           RTC_FORMAT_UINT4, points, mesh.vertices_m.size(), quads[h]);
        tree_->AddGeometry(h == 0 ? kTriangles : kTrianglesWithHoles,
                           RTC_GEOMETRY_TYPE_TRIANGLE, RTC_FORMAT_UINT3, points,
                           mesh.vertices_m.size(), triangles[h]);
    }
    rtcReleaseBuffer(points);
    rtcCommitScene(tree_->scene);
    tree_->Check("building its tree");
}

EmbreeCaster::~EmbreeCaster() = default;

void EmbreeCaster::Closest(std::span<const Ray> rays, std::span<Hit> hits) const {
    assert(hits.size() >= rays.size());
    const DenormalsOff denormals_off;
    RTCIntersectContext context = NewContext();
    RTCRayHit found;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        found.ray = EmbreeRay(rays[i]);
        found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(tree_->scene, &context, &found);
        hits[i] = tree_->ToHit(found);
    }
}

void EmbreeCaster::Any(std::span<const Ray> rays, std::span<std::uint64_t> met) const {
    assert(met.size() >= BitWords(rays.size()));
    std::ranges::fill(met, 0);
    const DenormalsOff denormals_off;
    RTCIntersectContext context = NewContext();
    std::array<RTCRay, kStream> stream;
    for (std::size_t begin = 0; begin < rays.size(); begin += kStream) {
        const std::size_t count = std::min(kStream, rays.size() - begin);
        for (std::size_t i = 0; i < count; ++i) stream[i] = EmbreeRay(rays[begin + i]);
        rtcOccluded1M(tree_->scene, &context, stream.data(), unsigned(count), sizeof(RTCRay));
        for (std::size_t i = 0; i < count; ++i) {
            met[(begin + i) / 64] |= std::uint64_t(WasMet(stream[i])) << ((begin + i) % 64);
        }
    }
}

void EmbreeCaster::AnyFromPoint(const Ray& common, std::span<const Vec3f> directions,
                                std::span<std::uint64_t> met) const {
    assert(met.size() >= BitWords(directions.size()));
    std::ranges::fill(met, 0);
    const DenormalsOff denormals_off;
    RTCIntersectContext context = NewContext();
    std::array<RTCRay, kStream> stream;
    const RTCRay ready = EmbreeRay(common);
    for (std::size_t begin = 0; begin < directions.size(); begin += kStream) {
        const std::size_t count = std::min(kStream, directions.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            const Vec3f& w = directions[begin + i];
            stream[i] = ready;
            stream[i].dir_x = w.x();
            stream[i].dir_y = w.y();
            stream[i].dir_z = w.z();
        }
        rtcOccluded1M(tree_->scene, &context, stream.data(), unsigned(count), sizeof(RTCRay));
        for (std::size_t i = 0; i < count; ++i) {
            met[(begin + i) / 64] |= std::uint64_t(WasMet(stream[i])) << ((begin + i) % 64);
        }
    }
}

struct EmbreeBareLoop::Rays {
    std::vector<RTCRay> rays, work;
};

EmbreeBareLoop::EmbreeBareLoop(const EmbreeCaster& caster, std::span<const Ray> rays)
    : caster_(caster), rays_(std::make_unique<Rays>()) {
    rays_->rays.reserve(rays.size());
    for (const Ray& ray : rays) rays_->rays.push_back(EmbreeRay(ray));
    Refill();
}

EmbreeBareLoop::~EmbreeBareLoop() = default;

std::int64_t EmbreeBareLoop::Closest(std::size_t begin, std::size_t end) const {
    const DenormalsOff denormals_off;
    RTCIntersectContext context = NewContext();
    RTCRayHit found;
    std::int64_t met = 0;
    for (std::size_t i = begin; i < end; ++i) {
        found.ray = rays_->rays[i];
        found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(caster_.tree_->scene, &context, &found);
        met += found.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }
    return met;
}

std::int64_t EmbreeBareLoop::Any(std::size_t begin, std::size_t end) const {
    const DenormalsOff denormals_off;
    RTCIntersectContext context = NewContext();
    std::int64_t met = 0;
    for (std::size_t i = begin; i < end; ++i) {
        RTCRay ray = rays_->rays[i];
        rtcOccluded1(caster_.tree_->scene, &context, &ray);
        met += WasMet(ray);
    }
    return met;
}

std::int64_t EmbreeBareLoop::AnyStream(std::size_t begin, std::size_t end, std::size_t stream) {
    const DenormalsOff denormals_off;
    RTCIntersectContext context = NewContext();
    RTCRay* const rays = rays_->work.data();
    for (std::size_t i = begin; i < end; i += stream) {
        rtcOccluded1M(caster_.tree_->scene, &context, rays + i,
                      unsigned(std::min(stream, end - i)), sizeof(RTCRay));
    }
    return std::count_if(rays + begin, rays + end, WasMet);
}

void EmbreeBareLoop::Refill() {
    rays_->work = rays_->rays;
}

}  // namespace plumb
