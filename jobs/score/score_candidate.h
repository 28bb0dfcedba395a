// Every figure of one candidate.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/measured.h"
#include "jobs/score/compared.h"
#include "score/errors.h"
#include "score/flip_hdr.h"
#include "score/relative_error.h"
#include "score/worst_tile.h"

namespace plumb {

enum class FlipMode { kByFile, kLdr, kHdr, kNone };

inline constexpr std::array kErrorShares{0.5, 0.9, 0.99, 0.999};
inline constexpr std::array kFlipShares{0.25, 0.5, 0.75};  ///< Weighted quantiles.

struct FigureOptions {
    double peak = 1;  ///< Of PSNR. > 0
    FlipMode flip = FlipMode::kByFile;
    double pixels_per_degree = kFlipPixelsPerDegree;
    ToneCurve curve = ToneCurve::kAces;
    ErrorOptions errors = {};
};

struct CandidateScore {
    std::string name;
    ErrorScore errors = {};
    Measured psnr_db = {};  ///< With the peak of the options.
    Measured ssim = {};     ///< NaN for data outside [0, 1] and where no window is whole.
    std::vector<Measured> quantiles = {};  ///< Of kErrorShares.
    std::vector<Measured> relative = {};   ///< Of RelativeForms().
    WorstTile worst = {};

    Measured flip = {};                       ///< NaN if it was not taken.
    std::vector<double> flip_quantiles = {};  ///< Of kFlipShares, then the greatest.
    std::optional<ToneExposures> exposures = {};

    Image<float> flip_map = {};
};

CandidateScore ScoreCandidate(const Compared& compared, std::size_t candidate, bool hdr_flip,
                              const FigureOptions& options);

/// A figure by the key that --fail-over and --fail-under name it by, in the order of FigureKeys().
const std::vector<std::string>& FigureKeys();
double FigureOf(const CandidateScore& score, const std::string& key);

}  // namespace plumb
