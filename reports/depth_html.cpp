#include "reports/depth_html.h"

#include <algorithm>

#include "reports/page.h"
#include "reports/text.h"

namespace plumb {
namespace {

std::string NameOf(const ZErrorCurve& c) {
    return c.format + (c.far_is_infinite ? ", far plane infinite" : ", finite");
}

double Greatest(const std::vector<double>& values) {
    return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

Plot ErrorPlot(const ZPrecisionReport& report, PlotSheet& sheet) {
    Plot plot{.id = "z-error",
              .title = "Error of z against distance",
              .caption =
                  "Root mean square over random poses of camera and object; the picture's own "
                  "matrices, one depth format a curve. The paper's figure 3.",
              .x = {.label = "distance [m]", .low = {}, .high = {}, .logarithmic = true},
              .y = {.label = "RMS error of z [mm]", .low = {}, .high = {}, .logarithmic = true},
              .views = {},
              .wide = true};
    for (const char* host : {"double", "float"}) {
        for (const bool one : {true, false}) {
            PlotView view{.keys = {{"host", host}, {"product", one ? "one" : "step by step"}},
                          .series = {},
                          .x = {},
                          .y = {}};
            int color = 0;
            for (const ZErrorCurve& c : report.curves) {
                if (c.host != host || c.concatenated != one || c.order != "rows" ||
                    c.clip != "D3D") {
                    continue;
                }
                std::vector<double> mm;
                for (const double rms : c.rms_m) mm.push_back(rms * 1e3);
                view.series.push_back({.label = NameOf(c),
                                       .mark = c.far_is_infinite ? Mark::kLine : Mark::kDashed,
                                       .color = CategoryColor(color++ / 2),
                                       .x = sheet.Add(c.distance_m),
                                       .y = sheet.Add(mm),
                                       .minus = {},
                                       .high = {},
                                       .joined = false,
                                       .shape = 0});
            }
            plot.views.push_back(std::move(view));
        }
    }
    return plot;
}

}  // namespace

std::string DepthHtml(const ZPrecisionReport& report, PlotSheet& sheet) {
    std::vector<std::vector<Cell>> rows;
    for (const ZErrorCurve& c : report.curves) {
        rows.push_back({{Html(c.format), "", ""},
                        {c.far_is_infinite ? "infinite" : "finite", "", ""},
                        {Html(c.host), "", ""},
                        {c.concatenated ? "one" : "step by step", "", ""},
                        {Html(c.order), "", ""},
                        {Html(c.clip), "", ""},
                        {Digits(Greatest(c.rms_m) * 1e3), "", ""},
                        {Digits(Greatest(c.worst_m) * 1e3), "", ""}});
    }
    std::string html =
        "<p>Depths from " + Digits(report.near_m) + " m to " + Digits(report.far_m) +
        " m. The paper says that its worst case is on the order of " +
        Digits(kPaperWorstZM * 1e3, 2) + " mm for z and " + Digits(kPaperWorstNormalDeg, 2) +
        "° for normals made from depth.</p>" +
        sheet.Group({{"host", "matrices multiplied in", {"double", "float"}},
                     {"product", "product", {"one", "step by step"}}},
                    {ErrorPlot(report, sheet)}) +
        "<details><summary>All combinations: greatest error over all distances</summary>" +
        Table({{"format"},
               {"far plane", true},
               {"matrices in", true},
               {"product", true},
               {"order", true},
               {"clip space", true},
               {"RMS [mm]"},
               {"worst [mm]"}},
              rows) +
        "</details>";
    rows.clear();
    for (const DrawnPrecision& d : report.drawn) {
        rows.push_back({{Html(d.camera), "", ""},
                        {Html(d.vertices), "", ""},
                        {Html(d.format), "", ""},
                        {d.far_is_infinite ? "infinite" : "finite", "", ""},
                        {Digits(d.z_rms_m * 1e3), "", ""},
                        {Digits(d.z_worst_m * 1e3), "", ""},
                        {Digits(d.normal_rms_deg), "", ""},
                        {Digits(d.normal_99_deg), "", ""},
                        {Digits(d.normal_worst_deg), "", ""},
                        {Digits(100 * d.within_paper_share, 4), "", ""}});
    }
    return html +
           "<h3>This scene, drawn and read back</h3><p>z against that of the same surface in "
           "double; normals made from depth (within one face) against the face's own: the "
           "paper's figure 4.</p>" +
           Table({{"camera"},
                  {"vertices in", true},
                  {"format", true},
                  {"far plane", true},
                  {"z RMS [mm]"},
                  {"z worst [mm]"},
                  {"normal RMS [°]"},
                  {"99 % [°]"},
                  {"worst [°]"},
                  {"within 0.2° [%]"}},
                 rows);
}

}  // namespace plumb
