#include "jobs/screen_space/z_precision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/conventions.h"
#include "core/error.h"
#include "core/parallel.h"
#include "core/statistics.h"
#include "jobs/screen_space/score_columns.h"
#include "reports/text.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/normal_precision.h"

namespace plumb {
namespace {

using Curve = std::vector<ZError>;

std::string FarOf(bool infinite) {
    return infinite ? "infinite" : "finite";
}

doc::Column ErrorColumn(std::string key, std::string title, std::string unit,
                        std::string meaning = {}) {
    return {.key = std::move(key),
            .title = std::move(title),
            .unit = std::move(unit),
            .better = doc::Better::kLess,
            .meaning = std::move(meaning)};
}

std::vector<doc::Column> WayColumns() {
    return {doc::Name("format", "Format"),    doc::Name("far", "Far plane"),
            doc::Name("host", "Matrices in"), doc::Name("product", "Product"),
            doc::Name("order", "Order"),      doc::Name("clip", "Clip space")};
}

std::vector<doc::Cell> CellsOf(const ZPipeline& way) {
    return {std::string(NameOf(way.format)),
            FarOf(way.far_is_infinite),
            way.host == HostPrecision::kDouble ? "double" : "float",
            way.concatenated ? "one" : "step by step",
            way.order == ProductOrder::kRows ? "rows" : "columns",
            way.clip == ClipRange::kMinusOneToOne ? "GL" : "D3D"};
}

template <class F>
std::vector<double> Each(const Curve& curve, const F& of) {
    std::vector<double> values;
    for (const ZError& error : curve) values.push_back(of(error));
    return values;
}

const auto kRmsMm = [](const ZError& e) { return 1e3 * e.rms_m; };
const auto kWorstMm = [](const ZError& e) { return 1e3 * e.worst_m; };

doc::Table AllErrors(const std::vector<ZPipeline>& ways, const std::vector<Curve>& curves) {
    doc::Table table{.key = "z_error", .columns = WayColumns(), .data = true};
    table.columns.insert(
        table.columns.end(),
        {{.key = "distance_m", .title = "Distance", .unit = "m", .role = doc::Role::kName},
         ErrorColumn("rms_mm", "RMS error of z", "mm"),
         ErrorColumn("worst_mm", "Worst", "mm"),
         {.key = "mean_mm", .title = "Mean", .unit = "mm", .better = doc::Better::kNearZero}});
    for (std::size_t k = 0; k < ways.size(); ++k) {
        for (const ZError& e : curves[k]) {
            std::vector<doc::Cell> row = CellsOf(ways[k]);
            row.insert(row.end(), {e.t_m, kRmsMm(e), kWorstMm(e), 1e3 * e.mean_m});
            table.Add(std::move(row));
        }
    }
    return table;
}

doc::Table GreatestErrors(const std::vector<ZPipeline>& ways,
                          const std::vector<Curve>& curves) {
    doc::Table table{.key = "z_greatest", .columns = WayColumns()};
    table.columns.push_back(ErrorColumn("rms_mm", "RMS", "mm"));
    table.columns.push_back(ErrorColumn("worst_mm", "Worst", "mm"));
    for (std::size_t k = 0; k < ways.size(); ++k) {
        std::vector<doc::Cell> row = CellsOf(ways[k]);
        row.push_back(std::ranges::max(Each(curves[k], kRmsMm)));
        row.push_back(std::ranges::max(Each(curves[k], kWorstMm)));
        table.Add(std::move(row));
    }
    return table;
}

doc::Plots ErrorPlot(const std::vector<ZPipeline>& ways, const std::vector<Curve>& curves) {
    Plot plot{.id = "z-error",
              .title = "Error of z against distance",
              .caption =
                  "Root mean square over random poses of camera and object; the picture's own "
                  "matrices, one depth format a curve. The paper's figure 3.",
              .x = {.label = "distance [m]", .low = {}, .high = {}, .logarithmic = true},
              .y = {.label = "RMS error of z [mm]", .low = {}, .high = {}, .logarithmic = true},
              .views = {},
              .wide = true};
    for (const HostPrecision host : {HostPrecision::kDouble, HostPrecision::kFloat}) {
        for (const bool one : {true, false}) {
            PlotView view;
            for (std::size_t k = 0; k < ways.size(); ++k) {
                const ZPipeline& way = ways[k];
                if (way.host != host || way.concatenated != one ||
                    way.order != ProductOrder::kRows || way.clip != ClipRange::kZeroToOne) {
                    continue;
                }
                const std::vector<doc::Cell> names = CellsOf(way);
                view.keys = {{"host", std::get<std::string>(names[2])},
                             {"product", std::get<std::string>(names[3])}};
                PlotSeries series;
                series.label = std::string(NameOf(way.format)) +
                               (way.far_is_infinite ? ", far plane infinite" : ", finite");
                series.mark = way.far_is_infinite ? Mark::kLine : Mark::kDashed;
                series.color = CategoryColor(int(view.series.size()) / 2);
                series.x = Each(curves[k], [](const ZError& e) { return e.t_m; });
                series.y = Each(curves[k], kRmsMm);
                view.series.push_back(std::move(series));
            }
            plot.views.push_back(std::move(view));
        }
    }
    return {.selectors = {{"host", "matrices multiplied in", {"double", "float"}},
                          {"product", "product", {"one", "step by step"}}},
            .plots = {std::move(plot)}};
}

// A scene drawn with a depth buffer of one kind, read back.
struct Drawn {
    double z_rms_m = 0, z_worst_m = 0;                ///< Within faces.
    double normal_rms_deg = 0, normal_worst_deg = 0;  ///< Within faces.
    double normal_99_deg = 0, normal_999_deg = 0;     ///< 99 % and 99.9 % lie below.
    double within_paper_share = 0;        ///< Of the normals that are within 0.2 degrees.
    std::int64_t pixels = 0, judged = 0;  ///< That show a surface; whose normals are judged.
};

// Of z as read back, where both pictures show the same triangle and normals are judged: at its
// edges a pixel's centre may lie outside a triangle, and what its z is there is a matter of taste.
void JudgeZ(const GBuffer& drawn, const GBuffer& exact, const Image<float>& angle_rad,
            Drawn& out) {
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

void JudgeNormals(const Image<float>& angle_rad, Drawn& out) {
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
               Monitor& monitor, doc::Table& table) {
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
                Drawn made;
                const Image<float> angle_rad = NormalErrorRad(drawn);
                JudgeZ(drawn, exact, angle_rad, made);
                JudgeNormals(angle_rad, made);
                table.Add({camera.name, vertices == VertexPath::kDouble ? "double" : "float",
                           std::string(NameOf(format)), FarOf(infinite), 1e3 * made.z_rms_m,
                           1e3 * made.z_worst_m, made.normal_rms_deg, made.normal_99_deg,
                           made.normal_999_deg, made.normal_worst_deg, made.within_paper_share,
                           made.pixels, made.judged});
            }
        }
    }
}

}  // namespace

doc::Section StudyZPrecision(const Scene& scene, const ZPrecisionSettings& settings,
                             Monitor& monitor) {
    const ZStudySettings& c = settings.curves;
    Validate(c);
    const std::vector<ZPipeline> ways = AllZPipelines();
    std::vector<Curve> curves(ways.size());
    ParallelFor(
        std::int64_t(ways.size()), 1,
        [&](std::int64_t k, std::int64_t) {
            curves[std::size_t(k)] = MeasureZError(ways[std::size_t(k)], c);
        },
        monitor, "z against distance");
    doc::Table drawn{
        .key = "drawn",
        .columns = {doc::Name("camera", "Camera"),
                    doc::Name("vertices", "Vertices in"),
                    doc::Name("format", "Format"),
                    doc::Name("far", "Far plane"),
                    ErrorColumn("z_rms_mm", "z RMS", "mm"),
                    ErrorColumn("z_worst_mm", "z worst", "mm"),
                    ErrorColumn("normal_rms_deg", "Normal RMS", "°"),
                    ErrorColumn("normal_99_deg", "99 %", "°", "99 % of the normals err less"),
                    ErrorColumn("normal_999_deg", "99.9 %", "°"),
                    ErrorColumn("normal_worst_deg", "Worst", "°"),
                    {.key = "within_paper_share",
                     .title = "Within " + Digits(kPaperWorstNormalDeg, 1) + "°",
                     .digits = 4,
                     .better = doc::Better::kMore,
                     .meaning = "Share of the normals"},
                    {.key = "pixels", .title = "Pixels of a surface", .detail = true},
                    {.key = "judged", .title = "Normals judged", .detail = true}}};
    for (Camera camera : scene.cameras) {
        camera.width_px = settings.width_px;
        camera.height_px = settings.height_px;
        JudgeView(scene, camera, settings, monitor, drawn);
    }
    const auto metres = [](std::string key, std::string title, double value) {
        return doc::Fact{{.key = std::move(key), .title = std::move(title), .unit = "m"},
                         value};
    };
    return {
        .id = "depth",
        .title = "What the depth buffer keeps",
        .sentences = {"The paper says that its worst case is on the order of " +
                      Digits(kPaperWorstZM * 1e3, 2) + " mm for z and " +
                      Digits(kPaperWorstNormalDeg, 2) + "° for normals made from depth."},
        .facts = {metres("near_m", "Nearest depth", c.near_m),
                  metres("far_m", "Farthest depth", c.far_m),
                  metres("from_origin_m", "Camera from the origin", c.from_origin_m),
                  metres("object_from_origin_m", "Object from its own", c.object_from_origin_m),
                  {{.key = "poses", .title = "Random poses"}, c.poses},
                  {{.key = "points", .title = "Points a pose and distance"}, c.points}},
        .tables = {AllErrors(ways, curves)},
        .plots = {ErrorPlot(ways, curves)},
        .sections = {
            {.id = "depth_greatest",
             .title = "All combinations: greatest error over all distances",
             .folded = true,
             .tables = {GreatestErrors(ways, curves)}},
            {.id = "depth_drawn",
             .title = "This scene, drawn and read back",
             .sentences = {doc::Verbatim(scene.name) + " at " +
                           std::to_string(settings.width_px) + " × " +
                           std::to_string(settings.height_px) +
                           ": z against that of the same surface in double; normals made from "
                           "depth (within one face) against the face's own. The paper's figure "
                           "4."},
             .tables = {std::move(drawn)}}}};
}

}  // namespace plumb
