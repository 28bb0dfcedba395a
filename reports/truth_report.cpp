#include "reports/truth_report.h"

#include "reports/columns.h"

namespace plumb {

doc::Document DocumentOf(const TruthReport& report) {
    doc::Table table{
        .key = "quantities",
        .columns = {doc::Name("name", "Quantity"), doc::Value("mean", "Mean", 5),
                    doc::ErrorOf("rms_standard_error", "Standard error", 3,
                                 "root mean square over pixels"),
                    doc::ErrorOf("rms_below_95", "95 % interval, below", 3,
                                 "from the value down to its end, root mean square"),
                    doc::ErrorOf("rms_above_95", "above", 3,
                                 "from the value up to its end, root mean square")}};
    for (const TruthQuantity& q : report.quantities) {
        table.Add({q.name, q.mean, q.rms_error, q.rms_below, q.rms_above});
    }
    doc::Section section{.id = "truth",
                         .title = "Means over the pixels that show a surface",
                         .listed = !report.notes.empty(),
                         .tables = {std::move(table)}};
    for (const std::string& note : report.notes) {
        section.sentences.push_back("Note: " + doc::Verbatim(note) + ".");
    }
    const auto fact = [&](const char* key, const char* title, doc::Cell value) {
        section.facts.push_back({{.key = key, .title = title}, std::move(value)});
    };
    fact("spp", "Samples a pixel", report.spp);
    fact("stopped_by", "Stopped by", report.stopped_by);
    fact("lost_walks", "Lost walks", report.lost_walks);
    fact("nets", "Independent nets", report.nets);
    fact("width_px", "Width, px", report.width_px);
    fact("height_px", "Height, px", report.height_px);
    fact("pixels_that_show_a_surface", "Pixels that show a surface", report.pixels_seen);
    fact("pixels_that_show_a_back", "Pixels that show a back", report.seen_from_behind);
    fact("zero_area_triangles_kept_out", "Triangles without area, kept out",
         report.zero_area_triangles);
    return {.kind = "truth",
            .title = "Truth of " + report.scene,
            .subtitle = "Path-traced, camera " + report.camera,
            .provenance = {.version = report.tool_version,
                           .command = report.command,
                           .seed = report.seed,
                           .inputs = {{report.scene, report.scene_sha256}}},
            .sections = {std::move(section)}};
}

}  // namespace plumb
