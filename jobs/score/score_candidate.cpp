#include "jobs/score/score_candidate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "core/names.h"
#include "score/quantiles.h"
#include "score/ssim.h"

namespace plumb {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Mean over the channels of the map of each.
Image<float> SsimOf(const ComparedPicture& candidate, const Compared& compared) {
    const Channels& truth = compared.reference.values;
    Image<float> mean;
    for (std::size_t c = 0; c < truth.size(); ++c) {
        const Image<float> map = SsimMap(
            candidate.values[c], truth[c],
            compared.standard_error.empty() ? Image<float>() : compared.standard_error[c],
            compared.mask);
        if (c == 0) mean = Image<float>(map.Width(), map.Height(), 0);
        for (std::size_t p = 0; p < map.Pixels().size(); ++p)
            mean.Pixels()[p] += map.Pixels()[p] / float(truth.size());
    }
    return mean;
}

void AddFlip(const Compared& compared, std::size_t k, bool hdr, const FigureOptions& options,
             CandidateScore& score) {
    const Image<Rgb>& candidate = compared.candidates[k].linear;
    const FlipOptions flip{.pixels_per_degree = options.pixels_per_degree};
    if (hdr) {
        HdrFlip result = HdrFlipMap(candidate, compared.reference.linear, compared.mask,
                                    {.flip = flip, .curve = options.curve});
        score.exposures = result.exposures;
        score.flip_map = std::move(result.map);
    } else {
        score.flip_map = FlipMap(candidate, compared.reference.linear, flip);
    }
    score.flip = MeanOverTiles(score.flip_map, compared.mask, options.errors);
    score.flip_quantiles = WeightedQuantiles(score.flip_map, kFlipShares, compared.mask);
    double greatest = 0;
    for (std::size_t p = 0; p < score.flip_map.Pixels().size(); ++p) {
        if (compared.mask.Empty() || compared.mask.Pixels()[p] != 0)
            greatest = std::max(greatest, double(score.flip_map.Pixels()[p]));
    }
    score.flip_quantiles.push_back(greatest);
}

struct NamedFigure {
    std::string key;
    std::function<double(const CandidateScore&)> of;
};

double FlipQuantile(const CandidateScore& s, std::size_t k) {
    return s.flip_quantiles.empty() ? kNan : s.flip_quantiles[k];
}

const std::vector<NamedFigure>& NamedFigures() {
    using S = const CandidateScore&;
    static const std::vector<NamedFigure> figures = [] {
        std::vector<NamedFigure> all{
            {"bias", [](S s) { return s.errors.bias.value; }},
            {"mae", [](S s) { return s.errors.mae.value; }},
            {"mse", [](S s) { return s.errors.mse.value; }},
            {"rmse", [](S s) { return s.errors.rmse.value; }},
            {"psnr", [](S s) { return s.psnr_db.value; }},
            {"ssim", [](S s) { return s.ssim.value; }},
            {"max", [](S s) { return s.errors.max; }},
            {"p50", [](S s) { return s.quantiles[0].value; }},
            {"p90", [](S s) { return s.quantiles[1].value; }},
            {"p99", [](S s) { return s.quantiles[2].value; }},
            {"p999", [](S s) { return s.quantiles[3].value; }},
            {"worst_tile_rmse", [](S s) { return std::sqrt(std::max(0.0, s.worst.mse)); }},
            {"flip", [](S s) { return s.flip.value; }},
            {"flip_median", [](S s) { return FlipQuantile(s, 1); }},
            {"flip_max", [](S s) { return FlipQuantile(s, kFlipShares.size()); }},
        };
        for (std::size_t k = 0; k < RelativeForms().size(); ++k) {
            all.push_back({RelativeForms()[k].key, [k](S s) { return s.relative[k].value; }});
        }
        return all;
    }();
    return figures;
}

bool HasLight(const Compared& compared) {
    const std::vector<Rgb>& pixels = compared.reference.linear.Pixels();
    for (std::size_t p = 0; p < pixels.size(); ++p) {
        const bool counts = compared.mask.Empty() || compared.mask.Pixels()[p] != 0;
        if (counts && (pixels[p][0] > 0 || pixels[p][1] > 0 || pixels[p][2] > 0)) return true;
    }
    return false;
}

}  // namespace

CandidateScore ScoreCandidate(const Compared& compared, std::size_t k, bool hdr_flip,
                              const FigureOptions& options) {
    const ComparedPicture& candidate = compared.candidates[k];
    const Channels& truth = compared.reference.values;
    CandidateScore score{.name = candidate.name};
    score.errors = ScoreChannels(candidate.values, truth, compared.standard_error,
                                 compared.mask, options.errors);
    score.psnr_db = PsnrOf(score.errors.mse, options.peak);
    if (compared.in_unit)
        score.ssim = ScoreSsim(SsimOf(candidate, compared), compared.mask, options.errors);
    score.quantiles = AbsoluteErrorQuantiles(candidate.values, truth, kErrorShares,
                                             compared.mask, options.errors);
    for (const RelativeForm& form : RelativeForms()) {
        score.relative.push_back(ScoreRelative(form, candidate.values, truth,
                                               compared.standard_error, compared.mask,
                                               options.errors));
    }
    score.worst = FindWorstTile(candidate.values, truth, compared.standard_error, compared.mask,
                                options.errors);
    // A black reference has no exposure that shows it.
    if (options.flip != FlipMode::kNone && (!hdr_flip || HasLight(compared)))
        AddFlip(compared, k, hdr_flip, options, score);
    return score;
}

const std::vector<std::string>& FigureKeys() {
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> all;
        for (const NamedFigure& figure : NamedFigures()) all.push_back(figure.key);
        return all;
    }();
    return keys;
}

double FigureOf(const CandidateScore& score, const std::string& key) {
    return NamedFigures()[PlaceOf(key, FigureKeys(), "figure = " + key)].of(score);
}

}  // namespace plumb
