#include "jobs/truth/facet_truth.h"

#include <bit>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "core/error.h"
#include "io/whole_file.h"
#include "jobs/truth/view_truth.h"
#include "rays/embree/embree_caster.h"
#include "reports/text.h"
#include "truth/escape_walk.h"
#include "truth/open_sky.h"

namespace plumb {
namespace {

struct FacetColumn {
    std::string name;
    std::function<Measured(std::int64_t)> of;
};

std::string CsvOf(const Mesh& mesh, const std::vector<Receiver>& receivers,
                  const std::vector<FacetColumn>& columns) {
    std::string csv = "triangle,area_m2,normal_x,normal_y,normal_z";
    for (const FacetColumn& c : columns) {
        for (const char* part : {"", "_error", "_low", "_high"}) csv += "," + c.name + part;
    }
    csv += "\n";
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Triangle triangle = TriangleOf(mesh, receivers[i].triangle);
        const Vec3 n = triangle.Normal();
        csv += std::to_string(receivers[i].triangle) + "," + Exact(triangle.AreaM2());
        for (int axis = 0; axis < 3; ++axis) csv += "," + Exact(n[axis]);
        for (const FacetColumn& column : columns) {
            const Measured m = column.of(std::int64_t(i));
            for (const double x :
                 {m.value, m.standard_error, m.interval.low, m.interval.high}) {
                csv += "," + Exact(x);
            }
        }
        csv += "\n";
    }
    return csv;
}

}  // namespace

void Validate(const FacetTruthJob& job) {
    if (job.spp < 16 || !std::has_single_bit(unsigned(job.spp))) {
        throw Error(MustBe("spp", job.spp, "a power of two >= 16"));
    }
    if (job.bounces < 0 || job.bounces > 100) {
        throw Error(MustBe("bounces", job.bounces, "in [0, 100]"));
    }
}

FacetTruthResult MeasureFacetTruth(const LoadedScene& loaded, const FacetTruthJob& job,
                                   const std::filesystem::path& folder, Monitor& monitor) {
    Validate(job);
    const Mesh& mesh = loaded.scene.mesh;
    const EmbreeCaster caster(loaded.scene);
    std::vector<Receiver> receivers;
    for (std::uint32_t t = 0; t < 2 * mesh.quads.size(); ++t) {
        if (TriangleOf(mesh, t).AreaM2() > 0) receivers.push_back({.triangle = t});
    }
    FacetTruthResult result;
    result.triangles = std::int64_t(receivers.size());
    result.zero_area = caster.Counts().zero_area;
    const NetSampling sampling{
        .replicates = kTruthNets, .points = job.spp / kTruthNets, .seed = job.seed};

    std::vector<FacetColumn> columns;
    OpenCounts V, alpha;
    EscapeCounts walks(0, kTruthNets, 0, 1);
    if (job.bounces > 0) {
        walks = WalkToTheSky(caster, mesh, receivers,
                             {.sampling = sampling, .bounces = job.bounces}, monitor);
        for (int k = 0; k <= job.bounces; ++k) {
            columns.push_back({k == 0 ? "V" : "E_" + std::to_string(k),
                               [&, k](std::int64_t i) { return walks.Bounce(i, k); }});
        }
        result.lost += walks.lost.All();
    } else {
        V = CountOpenSky(caster, mesh, receivers, {.sampling = sampling}, monitor);
        columns.push_back({"V", [&](std::int64_t i) { return V.Of(i); }});
        result.lost += V.lost.All();
    }
    if (job.alpha) {
        alpha = CountOpenSky(caster, mesh, receivers,
                             {.sampling = sampling, .weighting = HemisphereWeight::kUniform},
                             monitor);
        columns.push_back({"alpha", [&](std::int64_t i) { return alpha.Of(i); }});
        result.lost += alpha.lost.All();
    }
    double area = 0, squares = 0;
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const double a = TriangleOf(mesh, receivers[i].triangle).AreaM2();
        const Measured m = columns.front().of(std::int64_t(i));
        result.mean_V += a * m.value;
        squares += m.standard_error * m.standard_error / double(receivers.size());
        area += a;
    }
    if (area > 0) result.mean_V /= area;
    result.rms_error_V = std::sqrt(squares);
    result.csv = folder / "facets.csv";
    WriteWholeFile(result.csv, CsvOf(mesh, receivers, columns));
    return result;
}

}  // namespace plumb
