#include "reports/bench_report.h"

#include <nlohmann/json.hpp>

#include "reports/json_text.h"
#include "reports/text.h"

namespace plumb {
nlohmann::ordered_json ToJson(const LightBench& b) {
    nlohmann::ordered_json json;
    json["map"] = b.map;
    json["width_texels"] = b.width_texels;
    json["height_texels"] = b.height_texels;
    json["facets"] = b.facets;
    json["threads"] = b.threads;
    json["bounces"] = b.bounces;
    json["casting"] = {{"rays", b.casting.rays},
                       {"walk_rays_per_second", b.casting.walk_rays_per_second},
                       {"embree_rays_per_second", b.casting.embree_rays_per_second},
                       {"time_ratio", b.casting.time_ratio},
                       {"time_ratio_low", b.casting.time_ratio_low},
                       {"time_ratio_high", b.casting.time_ratio_high},
                       {"agreement", b.casting.agreement}};
    for (const SimulationBench& s : b.simulations) {
        json["simulations"].push_back({{"method", s.method},
                                       {"per_facet", s.per_facet},
                                       {"links_s", s.links_s},
                                       {"bounces_s", s.bounces_s},
                                       {"total_s", s.total_s},
                                       {"units_per_second", s.units_per_second},
                                       {"links", s.links},
                                       {"bytes_per_link", s.bytes_per_link},
                                       {"peak_memory_bytes", s.peak_memory_bytes}});
    }
    json["gather_bytes_per_second"] = b.gather_bytes_per_second;
    json["copy_bytes_per_second"] = b.copy_bytes_per_second;
    json["convergence"] = ToJson(b.convergence);
    return json;
}

void WriteTable(std::ostream& out, const LightBench& b) {
    out << Line("%s, %d x %d texels, %lld facets, %d bounces, %d threads\n\n", b.map.c_str(),
                b.width_texels, b.height_texels, static_cast<long long>(b.facets), b.bounces,
                b.threads);
    out << Line("casting, one thread, %lld cosine rays, in turns\n",
                static_cast<long long>(b.casting.rays));
    out << Line("  facet walk              %8.2f Mrays/s\n",
                b.casting.walk_rays_per_second * 1e-6);
    out << Line("  Embree rtcIntersect1    %8.2f Mrays/s   (quads, ROBUST)\n",
                b.casting.embree_rays_per_second * 1e-6);
    out << Line("  time ratio              %8.2f           (%.2f to %.2f over the rounds)\n",
                b.casting.time_ratio, b.casting.time_ratio_low, b.casting.time_ratio_high);
    out << Line("  same cell or both sky   %8.4f\n\n", b.casting.agreement);
    out << "simulation           links [s]  bounces [s]  total [s]   M/s   links  bytes/link  "
           "peak "
           "[GiB]\n";
    for (const SimulationBench& s : b.simulations) {
        out << Line("  %-6s %5d a facet %9.1f %12.1f %10.1f %5.2f %6.0fM %11.2f %11.2f\n",
                    s.method.c_str(), s.per_facet, s.links_s, s.bounces_s, s.total_s,
                    s.units_per_second * 1e-6, double(s.links) * 1e-6, s.bytes_per_link,
                    s.peak_memory_bytes / (1024.0 * 1024 * 1024));
    }
    out << Line(
        "\none bounce streams its links at %.1f GB/s; a copy of memory runs at %.1f GB/s\n",
        b.gather_bytes_per_second * 1e-9, b.copy_bytes_per_second * 1e-9);
    out << Line("\nerror of V against time (%s, middle of the map, %lld facets)\n",
                b.convergence.reference.c_str(), static_cast<long long>(b.convergence.facets));
    out << "  method  a facet   time [s]    rms error of V   of E(1/2)\n";
    for (const ConvergencePoint& p : b.convergence.points) {
        out << Line("  %-7s %7d %10.3f %17.5f %11.5f\n", p.method.c_str(), p.per_facet,
                    p.seconds, p.rms_V, p.rms_E_half);
    }
}

std::string ToJsonText(const LightBench& report) {
    return JsonText(ToJson(report));
}

}  // namespace plumb
