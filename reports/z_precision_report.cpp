#include "reports/z_precision_report.h"

#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/json_text.h"

namespace plumb {
namespace {

// Digits that read back to the same double.
std::string Number(double x) {
    return nlohmann::json(x).dump();
}

const char* FarOf(bool infinite) {
    return infinite ? "infinite" : "finite";
}

}  // namespace

nlohmann::ordered_json ToJson(const ZPrecisionReport& r) {
    nlohmann::ordered_json json;
    json["near_m"] = r.near_m;
    json["far_m"] = r.far_m;
    json["from_origin_m"] = r.from_origin_m;
    json["object_from_origin_m"] = r.object_from_origin_m;
    json["poses"] = r.poses;
    json["points"] = r.points;
    json["paper_worst_z_m"] = kPaperWorstZM;
    json["paper_worst_normal_deg"] = kPaperWorstNormalDeg;
    json["curves"] = nlohmann::ordered_json::array();
    for (const ZErrorCurve& c : r.curves) {
        json["curves"].push_back({{"host", c.host},
                                  {"concatenated", c.concatenated},
                                  {"order", c.order},
                                  {"clip", c.clip},
                                  {"format", c.format},
                                  {"far", FarOf(c.far_is_infinite)},
                                  {"distance_m", c.distance_m},
                                  {"rms_m", c.rms_m},
                                  {"worst_m", c.worst_m},
                                  {"mean_m", c.mean_m}});
    }
    json["scene"] = r.scene;
    json["width_px"] = r.width_px;
    json["height_px"] = r.height_px;
    json["drawn"] = nlohmann::ordered_json::array();
    for (const DrawnPrecision& d : r.drawn) {
        json["drawn"].push_back({{"camera", d.camera},
                                 {"vertices", d.vertices},
                                 {"format", d.format},
                                 {"far", FarOf(d.far_is_infinite)},
                                 {"z_rms_m", d.z_rms_m},
                                 {"z_worst_m", d.z_worst_m},
                                 {"normal_rms_deg", d.normal_rms_deg},
                                 {"normal_99_deg", d.normal_99_deg},
                                 {"normal_999_deg", d.normal_999_deg},
                                 {"normal_worst_deg", d.normal_worst_deg},
                                 {"within_paper_share", d.within_paper_share},
                                 {"pixels", d.pixels},
                                 {"judged", d.judged}});
    }
    return json;
}

std::string ToJsonText(const ZPrecisionReport& report) {
    return JsonText(ToJson(report));
}

std::string CurvesCsv(const ZPrecisionReport& report) {
    std::ostringstream out;
    out << "host,matrices,order,clip,format,far,distance_m,rms_m,worst_m,mean_m\n";
    for (const ZErrorCurve& c : report.curves) {
        for (std::size_t k = 0; k < c.distance_m.size(); ++k) {
            out << c.host << ',' << (c.concatenated ? "one" : "three") << ',' << c.order << ','
                << c.clip << ',' << c.format << ',' << FarOf(c.far_is_infinite) << ','
                << Number(c.distance_m[k]) << ',' << Number(c.rms_m[k]) << ','
                << Number(c.worst_m[k]) << ',' << Number(c.mean_m[k]) << '\n';
        }
    }
    return out.str();
}

std::string DrawnCsv(const ZPrecisionReport& report) {
    std::ostringstream out;
    out << "camera,vertices,format,far,z_rms_m,z_worst_m,normal_rms_deg,normal_99_deg,"
           "normal_999_deg,normal_worst_deg,within_paper_share,pixels,judged\n";
    for (const DrawnPrecision& d : report.drawn) {
        out << d.camera << ',' << d.vertices << ',' << d.format << ','
            << FarOf(d.far_is_infinite) << ',' << Number(d.z_rms_m) << ','
            << Number(d.z_worst_m) << ',' << Number(d.normal_rms_deg) << ','
            << Number(d.normal_99_deg) << ',' << Number(d.normal_999_deg) << ','
            << Number(d.normal_worst_deg) << ',' << Number(d.within_paper_share) << ','
            << d.pixels << ',' << d.judged << '\n';
    }
    return out.str();
}

}  // namespace plumb
