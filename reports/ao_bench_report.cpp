#include "reports/ao_bench_report.h"

#include <nlohmann/json.hpp>

#include "reports/json_text.h"
#include "reports/text.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

Json ToJson(const Spread3& s) {
    return {{"median", s.median}, {"low", s.low}, {"high", s.high}};
}

std::string Range(const Spread3& s, double scale = 1) {
    return Digits(s.median * scale) + " (" + Digits(s.low * scale) + " to " +
           Digits(s.high * scale) + ")";
}

}  // namespace

std::string ToJsonText(const AoBench& b) {
    Json json{{"scene", b.scene},
              {"camera", b.camera},
              {"threads", b.threads},
              {"rounds", b.rounds},
              {"copy_bytes_per_second", b.copy_bytes_per_second},
              {"sizes", Json::array()}};
    for (const AoSizeBench& s : b.sizes) {
        json["sizes"].push_back({{"width_px", s.width_px},
                                 {"height_px", s.height_px},
                                 {"guard_px", s.guard_px},
                                 {"sao_s", ToJson(s.sao_s)},
                                 {"alchemy_s", ToJson(s.alchemy_s)},
                                 {"sample_0.1m_s", ToJson(s.sample_near_s)},
                                 {"sample_1.5m_s", ToJson(s.sample_far_s)},
                                 {"sample_1.5m_no_pyramid_s", ToJson(s.sample_far_full_s)},
                                 {"alchemy_sample_1.5m_s", ToJson(s.alchemy_sample_s)},
                                 {"radius_ratio", ToJson(s.radius_ratio)},
                                 {"pyramid_ratio", ToJson(s.pyramid_ratio)},
                                 {"alchemy_ratio", ToJson(s.alchemy_ratio)},
                                 {"bytes_per_pixel", s.bytes_per_pixel},
                                 {"times_of_a_copy", s.copies}});
    }
    return JsonText(json);
}

void WriteTable(std::ostream& out, const AoBench& b) {
    out << b.scene << ", camera " << b.camera << ", " << b.threads << " threads, " << b.rounds
        << " rounds: median (least to greatest)\n";
    const auto line = [&](const std::string& name, const std::string& value) {
        out << "  " << Left(name, 52) << value << "\n";
    };
    for (const AoSizeBench& s : b.sizes) {
        out << "\n" << s.width_px << " x " << s.height_px << " + " << s.guard_px << " px\n";
        line("SAO, 11 taps, all passes [ms]", Range(s.sao_s, 1e3));
        line("AlchemyAO, 12 taps, all passes [ms]", Range(s.alchemy_s, 1e3));
        line("AlchemyAO over SAO, all passes (the paper: 7.1)", Range(s.alchemy_ratio));
        line("sampling, 9 taps, radius 0.1 m [ms]", Range(s.sample_near_s, 1e3));
        line("sampling, 9 taps, radius 1.5 m [ms]", Range(s.sample_far_s, 1e3));
        line("sampling, 9 taps, radius 1.5 m, no pyramid [ms]",
             Range(s.sample_far_full_s, 1e3));
        line("radius 1.5 m over 0.1 m, with pyramid", Range(s.radius_ratio));
        line("without pyramid over with, radius 1.5 m", Range(s.pyramid_ratio));
        line("SAO over copying the " + Digits(s.bytes_per_pixel) + " bytes a pixel it moves",
             Digits(s.copies));
    }
}

}  // namespace plumb
