#include "reports/raster_bench_report.h"

#include <nlohmann/json.hpp>

#include "reports/json_text.h"
#include "reports/text.h"

namespace plumb {
nlohmann::ordered_json ToJson(const RasterBench& b) {
    nlohmann::ordered_json json;
    json["scene"] = b.scene;
    json["triangles"] = b.triangles;
    json["vertices"] = b.vertices;
    json["width_px"] = b.width_px;
    json["height_px"] = b.height_px;
    json["threads"] = b.threads;
    json["rounds"] = b.rounds;
    json["views"] = nlohmann::ordered_json::array();
    for (const ViewBench& v : b.views) {
        json["views"].push_back({{"camera", v.camera},
                                 {"visibility_s", v.visibility_s},
                                 {"depth_s", v.depth_s},
                                 {"gbuffer_s", v.gbuffer_s},
                                 {"copy_s", v.copy_s},
                                 {"covered", v.covered}});
    }
    json["sizes"] = nlohmann::ordered_json::array();
    for (const SizeBench& s : b.sizes) {
        json["sizes"].push_back({{"legs_px", s.legs_px},
                                 {"triangles", s.triangles},
                                 {"triangles_per_second", s.triangles_per_second},
                                 {"pixels_per_second", s.pixels_per_second},
                                 {"copy_ratio", s.copy_ratio}});
    }
    json["copy_bytes_per_second"] = b.copy_bytes_per_second;
    json["copy_one_thread_bytes_per_second"] = b.copy_one_thread_bytes_per_second;
    return json;
}

void WriteTable(std::ostream& out, const RasterBench& b) {
    out << Line("%s, %lld triangles, %lld vertices, %d x %d pixels, %d threads, %d rounds\n\n",
                b.scene.c_str(), static_cast<long long>(b.triangles),
                static_cast<long long>(b.vertices), b.width_px, b.height_px, b.threads,
                b.rounds);
    out << "view        depth + triangle [ms]  depth [ms]  G-buffer [ms]  / copying depth + "
           "triangle  covered\n";
    for (const ViewBench& v : b.views) {
        out << Line("  %-10s %20.2f %11.2f %14.2f %27.1f %8.2f\n", v.camera.c_str(),
                    1e3 * v.visibility_s, 1e3 * v.depth_s, 1e3 * v.gbuffer_s,
                    v.visibility_s / v.copy_s, v.covered);
    }
    out << "\none thread, depth alone, right triangles\n";
    out << "  legs [px]  triangles  Mtri/s  Mpix/s  / copying 4 bytes a pixel\n";
    for (const SizeBench& s : b.sizes) {
        out << Line("  %9.0f %10lld %7.2f %7.0f %26.2f\n", s.legs_px,
                    static_cast<long long>(s.triangles), s.triangles_per_second * 1e-6,
                    s.pixels_per_second * 1e-6, s.copy_ratio);
    }
    out << Line("\ncopying memory: %.1f GB/s with one thread, %.1f GB/s with all\n",
                b.copy_one_thread_bytes_per_second * 1e-9, b.copy_bytes_per_second * 1e-9);
}

std::string ToJsonText(const RasterBench& bench) {
    return JsonText(ToJson(bench));
}

}  // namespace plumb
