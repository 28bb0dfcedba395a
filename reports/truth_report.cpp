#include "reports/truth_report.h"

#include <iomanip>
#include <nlohmann/json.hpp>

#include "reports/json_text.h"

namespace plumb {

std::string ToJsonText(const TruthReport& report) {
    nlohmann::ordered_json json;
    json["tool_version"] = report.tool_version;
    json["command"] = report.command;
    json["scene"] = {{"name", report.scene}, {"sha256", report.scene_sha256}};
    json["camera"] = {{"name", report.camera},
                      {"width_px", report.width_px},
                      {"height_px", report.height_px}};
    json["seed"] = report.seed;
    json["nets"] = report.nets;
    json["spp"] = report.spp;
    json["stopped_by"] = report.stopped_by;
    json["quantities"] = nlohmann::ordered_json::array();
    for (const TruthQuantity& q : report.quantities) {
        json["quantities"].push_back({{"name", q.name},
                                      {"mean", q.mean},
                                      {"rms_standard_error", q.rms_error},
                                      {"rms_below_95", q.rms_below},
                                      {"rms_above_95", q.rms_above}});
    }
    json["pixels_that_show_a_surface"] = report.pixels_seen;
    json["pixels_that_show_a_back"] = report.seen_from_behind;
    json["zero_area_triangles_kept_out"] = report.zero_area_triangles;
    json["lost_walks"] = report.lost_walks;
    json["notes"] = report.notes;
    return JsonText(json);
}

void WriteTable(std::ostream& out, const TruthReport& report) {
    const auto flags = out.flags();
    const auto precision = out.precision();
    out << "quantity         mean  standard error (rms)  95 % interval (rms)\n" << std::fixed;
    for (const TruthQuantity& q : report.quantities) {
        out << std::left << std::setw(12) << q.name << std::right << std::setw(10)
            << std::setprecision(5) << q.mean << std::setw(12) << std::setprecision(6)
            << q.rms_error << "            -" << q.rms_below << " +" << q.rms_above << "\n";
    }
    out << "\n"
        << report.spp << " samples a pixel, stopped by " << report.stopped_by << "; lost walks "
        << report.lost_walks << "\n";
    for (const std::string& note : report.notes) out << "note: " << note << "\n";
    out.flags(flags);
    out.precision(precision);
}

}  // namespace plumb
