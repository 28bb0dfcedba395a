#include "reports/truth_bench_report.h"

#include <nlohmann/json.hpp>

#include "reports/json_text.h"
#include "reports/text.h"

namespace plumb {
namespace {

long long Whole(std::int64_t n) {
    return n;
}

}  // namespace

nlohmann::ordered_json ToJson(const TruthBench& b) {
    nlohmann::ordered_json json;
    json["scene"] = b.scene;
    json["camera"] = b.camera;
    json["width_px"] = b.width_px;
    json["height_px"] = b.height_px;
    json["rays_per_pixel"] = b.rays_per_pixel;
    json["rounds"] = b.rounds;
    json["triangles"] = b.triangles;
    json["receivers"] = b.receivers;
    json["differing_rays"] = b.differing_rays;
    for (const TruthSpeed& s : b.speeds) {
        json["speeds"].push_back({{"threads", s.threads},
                                  {"rays_per_second", s.rays_per_second},
                                  {"bare_stream_rays_per_second", s.bare_stream_per_second},
                                  {"bare_single_rays_per_second", s.bare_single_per_second},
                                  {"share", s.share},
                                  {"share_low", s.share_low},
                                  {"share_high", s.share_high}});
    }
    const TruthFurnace& f = b.furnace;
    json["furnace"] = {{"cells", f.cells},       {"paths", f.paths},
                       {"bounces", f.bounces},   {"lost", f.lost},
                       {"rescued", f.rescued},   {"under_way", f.under_way},
                       {"deficit", f.Deficit()}, {"seconds", f.seconds}};
    const TruthConvergence& c = b.convergence;
    json["convergence"] = {{"receivers", c.receivers},
                           {"reference_rays", c.reference_rays},
                           {"slope_nets", c.slope_nets},
                           {"slope_independent", c.slope_independent}};
    for (const TruthConvergence::Point& p : c.points) {
        json["convergence"]["points"].push_back({{"rays", p.rays},
                                                 {"rms_error_nets", p.nets},
                                                 {"rms_error_independent", p.independent}});
    }
    return json;
}

void WriteTable(std::ostream& out, const TruthBench& b) {
    out << Line("%s, view %s, %d x %d pixels, %lld triangles; V of %lld pixels, %d rays each\n",
                b.scene.c_str(), b.camera.c_str(), b.width_px, b.height_px, Whole(b.triangles),
                Whole(b.receivers), b.rays_per_pixel);
    out << "threads   Mrays/s   bare stream   bare single   share of the stream (range)\n";
    for (const TruthSpeed& s : b.speeds) {
        out << Line("%7d %9.2f %13.2f %13.2f   %.3f (%.3f to %.3f)\n", s.threads,
                    s.rays_per_second * 1e-6, s.bare_stream_per_second * 1e-6,
                    s.bare_single_per_second * 1e-6, s.share, s.share_low, s.share_high);
    }
    out << Line("rays that the two see differently: %lld\n", Whole(b.differing_rays));
    const TruthFurnace& f = b.furnace;
    out << Line("\nfurnace, noisy field of %d x %d cells, %lld paths of up to %lld bounces\n",
                f.cells, f.cells, Whole(f.paths), Whole(f.bounces));
    out << Line("  deficit %.2g a path (lost %lld), rescued %lld, under way %lld, %.1f s\n",
                f.Deficit(), Whole(f.lost), Whole(f.rescued), Whole(f.under_way), f.seconds);
    const TruthConvergence& c = b.convergence;
    out << Line("\nrms error of V, %lld pixels, against %lld rays each\n", Whole(c.receivers),
                Whole(c.reference_rays));
    out << "     rays   Owen nets   independent\n";
    for (const TruthConvergence::Point& p : c.points) {
        out << Line("%9lld %11.5f %13.5f\n", Whole(p.rays), p.nets, p.independent);
    }
    out << Line("    slope %11.3f %13.3f\n", c.slope_nets, c.slope_independent);
}

std::string ToJsonText(const TruthBench& bench) {
    return JsonText(ToJson(bench));
}

}  // namespace plumb
