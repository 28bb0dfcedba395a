#include "jobs/screen_space/z_precision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/conventions.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "io/whole_file.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/normal_precision.h"

namespace plumb {
namespace {

ZErrorCurve CurveOf(const ZPipeline& p, const ZStudySettings& settings) {
    ZErrorCurve curve{.host = p.host == HostPrecision::kDouble ? "double" : "float",
                      .concatenated = p.concatenated,
                      .order = p.order == ProductOrder::kRows ? "rows" : "columns",
                      .clip = p.clip == ClipRange::kMinusOneToOne ? "GL" : "D3D",
                      .format = std::string(NameOf(p.format)),
                      .far_is_infinite = p.far_is_infinite,
                      .distance_m = {},
                      .rms_m = {},
                      .worst_m = {},
                      .mean_m = {}};
    for (const ZError& error : MeasureZError(p, settings)) {
        curve.distance_m.push_back(error.t_m);
        curve.rms_m.push_back(error.rms_m);
        curve.worst_m.push_back(error.worst_m);
        curve.mean_m.push_back(error.mean_m);
    }
    return curve;
}

// Of z as read back, where both pictures show the same triangle and normals are judged: at its
// edges a pixel's centre may lie outside a triangle, and what its z is there is a matter of taste.
void JudgeZ(const GBuffer& drawn, const GBuffer& exact, const Image<float>& angle_rad,
            DrawnPrecision& out) {
    double sum = 0;
    std::int64_t judged = 0;
    for (std::size_t p = 0; p < drawn.z_m.Pixels().size(); ++p) {
        const std::uint32_t triangle = drawn.triangle.Pixels()[p];
        if (triangle == GBuffer::kSky || triangle != exact.triangle.Pixels()[p]) continue;
        ++out.pixels;
        if (std::isnan(angle_rad.Pixels()[p])) continue;
        ++judged;
        const double off = double(drawn.z_m.Pixels()[p]) - double(exact.z_m.Pixels()[p]);
        sum += off * off;
        out.z_worst_m = std::max(out.z_worst_m, std::abs(off));
    }
    out.z_rms_m = std::sqrt(sum / double(std::max<std::int64_t>(1, judged)));
}

void JudgeNormals(const Image<float>& angle_rad, DrawnPrecision& out) {
    std::vector<double> angles_deg;
    double sum = 0;
    std::int64_t within = 0;
    for (const float angle : angle_rad.Pixels()) {
        if (std::isnan(angle)) continue;
        const double deg = double(angle) * 180 / kPi;
        angles_deg.push_back(deg);
        sum += deg * deg;
        within += deg <= kPaperWorstNormalDeg;
    }
    out.judged = std::int64_t(angles_deg.size());
    if (angles_deg.empty()) return;
    out.normal_rms_deg = std::sqrt(sum / double(out.judged));
    out.within_paper_share = double(within) / double(out.judged);
    out.normal_99_deg = Percentile(angles_deg, 0.99);
    out.normal_999_deg = Percentile(angles_deg, 0.999);
    out.normal_worst_deg = *std::max_element(angles_deg.begin(), angles_deg.end());
}

void JudgeView(const Scene& scene, const Camera& camera, const ZPrecisionSettings& settings,
               Monitor& monitor, std::vector<DrawnPrecision>& out) {
    Rasterizer rasterizer;
    RasterOptions options;
    options.range.near_m = settings.near_m;
    GBuffer exact, drawn;
    DrawGBuffer(rasterizer, scene, camera, options, exact);
    options.z = ZSource::kStored;
    for (const VertexPath vertices : {VertexPath::kDouble, VertexPath::kFloat}) {
        for (const DepthFormat format : {DepthFormat::kD16, DepthFormat::kD24,
                                         DepthFormat::kD32F, DepthFormat::kD32FReversed}) {
            for (const bool infinite : {true, false}) {
                if (monitor.Cancelled()) throw Interrupted();
                options.vertices = vertices;
                options.depth = format;
                options.range.far_m =
                    infinite ? std::numeric_limits<double>::infinity() : settings.far_m;
                DrawGBuffer(rasterizer, scene, camera, options, drawn);
                DrawnPrecision row;
                row.camera = camera.name;
                row.vertices = vertices == VertexPath::kDouble ? "double" : "float";
                row.format = NameOf(format);
                row.far_is_infinite = infinite;
                const Image<float> angle_rad = NormalErrorRad(drawn);
                JudgeZ(drawn, exact, angle_rad, row);
                JudgeNormals(angle_rad, row);
                out.push_back(row);
            }
        }
    }
}

}  // namespace

ZPrecisionReport StudyZPrecision(const Scene& scene, const ZPrecisionSettings& settings,
                                 Monitor& monitor) {
    const ZStudySettings& c = settings.curves;
    Validate(c);
    ZPrecisionReport report;
    report.near_m = c.near_m;
    report.far_m = c.far_m;
    report.from_origin_m = c.from_origin_m;
    report.object_from_origin_m = c.object_from_origin_m;
    report.poses = c.poses;
    report.points = c.points;
    const std::vector<ZPipeline> pipelines = AllZPipelines();
    report.curves.resize(pipelines.size());
    ParallelFor(
        std::int64_t(pipelines.size()), 1,
        [&](std::int64_t k, std::int64_t) {
            report.curves[std::size_t(k)] = CurveOf(pipelines[std::size_t(k)], c);
        },
        monitor, "z against distance");
    report.scene = scene.name;
    report.width_px = settings.width_px;
    report.height_px = settings.height_px;
    for (Camera camera : scene.cameras) {
        camera.width_px = settings.width_px;
        camera.height_px = settings.height_px;
        JudgeView(scene, camera, settings, monitor, report.drawn);
    }
    return report;
}

void WriteZPrecision(const std::filesystem::path& folder, const ZPrecisionReport& report) {
    WriteWholeFile(folder / "z_precision.json", ToJsonText(report));
    WriteWholeFile(folder / "z_error.csv", CurvesCsv(report));
    WriteWholeFile(folder / "normal_error.csv", DrawnCsv(report));
}

}  // namespace plumb
