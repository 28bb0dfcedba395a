// What a depth buffer keeps of z and of normals: figures 3 and 4 of [McGuire12] as numbers.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace plumb {

/// Errors of z against the distance, for one way from vertex to depth buffer (figure 3).
struct ZErrorCurve {
    std::string host;  ///< "double" or "float": of the matrix products.
    bool concatenated = true;
    std::string order;   ///< "rows" or "columns".
    std::string clip;    ///< "GL" or "D3D".
    std::string format;  ///< "D24" ...
    bool far_is_infinite = true;
    std::vector<double> distance_m, rms_m, worst_m, mean_m;
};

/// A scene drawn with a depth buffer of one kind, read back (figure 4).
struct DrawnPrecision {
    std::string camera, vertices, format;  ///< vertices: "double" or "float".
    bool far_is_infinite = true;
    double z_rms_m = 0, z_worst_m = 0;                ///< Within faces.
    double normal_rms_deg = 0, normal_worst_deg = 0;  ///< Within faces.
    double normal_99_deg = 0, normal_999_deg = 0;     ///< 99 % and 99.9 % lie below.
    double within_paper_share = 0;        ///< Of the normals that are within 0.2 degrees.
    std::int64_t pixels = 0, judged = 0;  ///< That show a surface; whose normals are judged.
};

struct ZPrecisionReport {
    double near_m = 0, far_m = 0, from_origin_m = 0, object_from_origin_m = 0;
    int poses = 0, points = 0;
    std::vector<ZErrorCurve> curves;
    std::string scene;
    int width_px = 0, height_px = 0;
    std::vector<DrawnPrecision> drawn;
};

/// The paper's claims, to stand beside the worst cases.
inline constexpr double kPaperWorstZM = 0.002, kPaperWorstNormalDeg = 0.2;

nlohmann::ordered_json ToJson(const ZPrecisionReport& report);
std::string ToJsonText(const ZPrecisionReport& report);

/// One row a curve and distance; words as words. For a spreadsheet.
std::string CurvesCsv(const ZPrecisionReport& report);
std::string DrawnCsv(const ZPrecisionReport& report);

}  // namespace plumb
