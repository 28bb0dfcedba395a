// How fast SAO and its baseline are, as ratios that travel between machines.
//
// Every ratio is the median over the rounds of one run, in which what is compared takes turns.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

namespace plumb {

/// A median with the least and the greatest of the rounds.
struct Spread3 {
    double median = 0, low = 0, high = 0;
};

/// One size of picture with its guard band. Sampling passes have 9 taps, AlchemyAO its 12.
struct AoSizeBench {
    int width_px = 0, height_px = 0, guard_px = 0;
    Spread3 sao_s;               ///< All passes, s = 11, as in the supplement.
    Spread3 alchemy_s;           ///< All passes of the baseline.
    Spread3 sample_near_s;       ///< Sampling pass, radius 0.1 m, with pyramid.
    Spread3 sample_far_s;        ///< The same at 1.5 m.
    Spread3 sample_far_full_s;   ///< At 1.5 m on full-resolution depth.
    Spread3 alchemy_sample_s;    ///< Sampling pass of the baseline at 1.5 m.
    Spread3 radius_ratio;        ///< 1.5 m over 0.1 m, with pyramid.
    Spread3 pyramid_ratio;       ///< Without over with pyramid, 1.5 m.
    Spread3 alchemy_ratio;       ///< The baseline over SAO, all passes. The paper: 7.1.
    double bytes_per_pixel = 0;  ///< That SAO's passes read and write at least.
    double copies = 0;           ///< Time of SAO over that of copying as many bytes.
};

struct AoBench {
    std::string scene, camera;
    int threads = 0, rounds = 0;
    double copy_bytes_per_second = 0;
    std::vector<AoSizeBench> sizes;
};

/// As the paper measured it at 1080p on its machine (16.10 ms over 2.26 ms).
inline constexpr double kPaperAlchemyRatio = 7.1;

std::string ToJsonText(const AoBench& bench);
void WriteTable(std::ostream& out, const AoBench& bench);

}  // namespace plumb
