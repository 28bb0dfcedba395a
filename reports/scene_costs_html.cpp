// What techniques cost: error against run time, times pass by pass, flicker.
#include <algorithm>
#include <map>

#include "reports/scene_report_page.h"

namespace plumb::page {
namespace {

PlotSeries Dots(std::string label, int i, Column x, Column y, bool joined) {
    return {.label = std::move(label),
            .mark = Mark::kDots,
            .color = CategoryColor(i),
            .x = x,
            .y = y,
            .minus = {},
            .high = {},
            .joined = joined,
            .shape = i % 5};
}

PlotSeries Curve(std::string label, std::string color, Column x, Column y,
                 Mark mark = Mark::kLine) {
    return {.label = std::move(label),
            .mark = mark,
            .color = std::move(color),
            .x = x,
            .y = y,
            .minus = {},
            .high = {},
            .joined = false,
            .shape = 0};
}

}  // namespace

std::string SweepHtml(const SceneReport& r, PlotSheet& sheet) {
    std::map<std::string, std::vector<const SweepPoint*>> by_technique;
    std::vector<std::string> order;
    for (const SweepPoint& p : r.sweep) {
        if (by_technique[p.technique].empty()) order.push_back(p.technique);
        by_technique[p.technique].push_back(&p);
    }
    const auto view = [&](const std::string& key, Measured SweepPoint::*error) {
        PlotView drawn{.keys = {{"error", key}}, .series = {}, .x = {}, .y = {}};
        for (std::size_t t = 0; t < order.size(); ++t) {
            std::vector<double> x, y;
            for (const SweepPoint* p : by_technique[order[t]]) {
                x.push_back(p->seconds.value * 1e3);
                y.push_back((p->*error).value);
            }
            drawn.series.push_back(Dots(order[t], int(t), sheet.Add(x), sheet.Add(y), false));
        }
        return drawn;
    };
    PlotView plain = view("as it is", &SweepPoint::rmse);
    double least = 1, most = 0;
    for (const SweepPoint& p : r.sweep) {
        least = std::min({least, p.rmse.value, p.recalibrated_rmse.value});
        most = std::max({most, p.rmse.value, p.recalibrated_rmse.value});
    }
    std::vector<std::pair<double, double>> front;
    for (const SweepPoint& p : r.sweep) {
        if (p.on_front) front.push_back({p.seconds.value * 1e3, p.rmse.value});
    }
    std::sort(front.begin(), front.end());
    std::vector<double> x, y;
    for (const auto& [ms, rmse] : front) {
        x.push_back(ms);
        y.push_back(rmse);
    }
    plain.series.push_back(
        Curve("Pareto front", kDataColor, sheet.Add(x), sheet.Add(y), Mark::kDashed));
    PlotView recalibrated = view("recalibrated", &SweepPoint::recalibrated_rmse);
    Plot plot{
        .id = "error-time",
        .title = "Error against run time",
        .caption =
            "Each dot is one setting of one technique: lookups or rays a pixel, "
            "pyramid, packing and filters on and off. Down and to the left is "
            "better; nothing lies below the front.",
        .x = {.label = "time of one picture [ms]", .low = {}, .high = {}, .logarithmic = true},
        .y = {.label = "RMSE against V within r",
              .low = 0.8 * least,
              .high = 1.2 * most,
              .logarithmic = true},
        .views = {std::move(plain), std::move(recalibrated)},
        .wide = true};
    std::string html = sheet.Group({{"error", "error", {"as it is", "recalibrated"}}}, {plot});
    std::vector<const SweepPoint*> sorted;
    for (const SweepPoint& p : r.sweep) {
        if (p.on_front) sorted.push_back(&p);
    }
    std::sort(sorted.begin(), sorted.end(), [](const SweepPoint* a, const SweepPoint* b) {
        return a->seconds.value < b->seconds.value;
    });
    std::vector<std::vector<Cell>> rows;
    for (const SweepPoint* p : sorted) {
        rows.push_back({Text(p->technique), Text(p->setting), Ms(p->seconds),
                        Interval95(p->rmse), Interval95(p->recalibrated_rmse)});
    }
    return html + "<h3>The Pareto front</h3>" +
           Table({{"technique"},
                  {"setting", true},
                  {"time [ms]"},
                  {"RMSE"},
                  {"recalibrated RMSE"}},
                 rows);
}

std::string TimesHtml(const SceneReport& r, PlotSheet& sheet) {
    std::vector<std::vector<Cell>> rows;
    for (const PassTimes& t : r.times) {
        std::string passes;
        for (const PassSeconds& pass : t.passes) {
            passes += (passes.empty() ? "" : " · ") + pass.name + " " +
                      Digits(pass.seconds.value * 1e3);
        }
        rows.push_back({Text(t.technique),
                        Text(std::to_string(t.width_px) + " × " + std::to_string(t.height_px) +
                             " + " + std::to_string(t.guard_px)),
                        Ms(t.seconds),
                        {Html(passes), "wrap", ""},
                        Number(t.bytes_per_pixel),
                        Number(t.ns_per_visible),
                        Number(t.copies)});
    }
    std::string html =
        "<p>On " + std::to_string(r.threads) + " threads; medians of " +
        std::to_string(r.rounds) +
        " rounds, the techniques in turns; in brackets the least and the greatest. Sizes and "
        "guard bands are those of the paper's table 3. <i>Bytes</i>: what the passes read and "
        "write, counted texel by texel, each once a pass, by the pixels shown. <i>ns a visible "
        "pixel</i>: by the pixels shown, as in that table. <i>Copies</i>: the time over that "
        "of copying as many bytes in the same run; this machine copies " +
        Digits(r.copy_bytes_per_second.value / 1e9) + " GB/s (read and written) and casts " +
        Digits(r.embree_rays_per_second.value / 1e6) +
        " million bare occlusion rays a second in this scene. One G-buffer takes " +
        Digits(r.raster_s.value * 1e3) + " ms.</p>" +
        Table({{"technique"},
               {"size + border [px]", true},
               {"time [ms]"},
               {"passes [ms]", true},
               {"bytes a pixel"},
               {"ns a visible pixel"},
               {"copies"}},
              rows);
    if (r.radii.empty()) return html;
    std::vector<double> radius, with, without, alchemy;
    for (const RadiusTime& t : r.radii) {
        radius.push_back(t.radius_m);
        with.push_back(t.with_pyramid_s.value * 1e3);
        without.push_back(t.without_pyramid_s.value * 1e3);
        alchemy.push_back(t.alchemy_s.value * 1e3);
    }
    const Column x = sheet.Add(radius);
    Plot plot{.id = "radius",
              .title = "Sampling time against radius",
              .caption = std::to_string(r.radii_width_px) + " × " +
                         std::to_string(r.radii_height_px) +
                         ", 9 taps (AlchemyAO: 12). The paper's figure 5: without a pyramid "
                         "taps of a wide disc miss the cache.",
              .x = {.label = "radius [m]", .low = 0, .high = {}},
              .y = {.label = "time [ms]", .low = 0, .high = {}},
              .views = {{.keys = {},
                         .series = {Curve("with pyramid", kOursColor, x, sheet.Add(with)),
                                    Curve("without", kPublishedColor, x, sheet.Add(without)),
                                    Curve("AlchemyAO", kDataColor, x, sheet.Add(alchemy),
                                          Mark::kDashed)},
                         .x = {},
                         .y = {}}}};
    return html + sheet.Group({}, {plot});
}

std::string FlickerHtml(const SceneReport& r) {
    std::vector<std::vector<Cell>> rows;
    for (const TemporalRow& t : r.temporal) {
        rows.push_back({Text(t.technique), WithErrorOf(t.score.candidate, 1e6),
                        WithErrorOf(t.score.truth, 1e6), WithErrorOf(t.score.flicker, 1e6)});
    }
    return "<p>The camera turns by parts of a pixel, " + std::to_string(r.temporal_frames) +
           " frames. Variance of a pixel over the frames, times 10⁶, averaged over the "
           "picture: of the technique, of the truth (which changes at edges), and of the "
           "error alone: what the eye sees as flicker.</p>" +
           Table({{"technique"}, {"technique [10⁻⁶]"}, {"truth [10⁻⁶]"}, {"flicker [10⁻⁶]"}},
                 rows);
}

}  // namespace plumb::page
