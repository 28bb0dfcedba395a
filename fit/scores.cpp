#include "fit/scores.h"

#include <algorithm>
#include <cmath>

#include "fit/residuals.h"

namespace plumb {

Score ScoreOf(const Formula& formula, std::span<const Sample> samples) {
    Score score;
    double sum_w = 0, sum_wd2 = 0;
    for (const Residual& residual : Residuals(formula, samples)) {
        const double w = residual.sample.weight, d = residual.difference;
        if (!(w > 0)) continue;
        ++score.samples;
        if (!std::isfinite(residual.predicted)) {
            ++score.poles;
            continue;
        }
        score.out_of_range += residual.predicted < 0 || residual.predicted > 1;
        score.max_abs = std::max(score.max_abs, std::abs(d));
        sum_w += w;
        sum_wd2 += w * d * d;
    }
    if (sum_w > 0) score.rms = std::sqrt(sum_wd2 / sum_w);
    return score;
}

Score ScoreOf(const Formula& formula, const BounceHistogram& map) {
    return ScoreOf(formula, TotalSamples(std::span(&map, 1)));
}

ScoreRow ScoreOver(const Formula& formula, std::span<const BounceHistogram> maps) {
    ScoreRow row{.formula = formula.name, .maps = {}, .pooled = {}};
    for (const BounceHistogram& map : maps) row.maps.push_back(ScoreOf(formula, map));
    row.pooled = Pooled(row.maps);
    return row;
}

Score Pooled(std::span<const Score> scores) {
    Score pooled;
    double sum_squares = 0;
    for (const Score& score : scores) {
        sum_squares += score.rms * score.rms;
        pooled.max_abs = std::max(pooled.max_abs, score.max_abs);
        pooled.samples += score.samples;
        pooled.poles += score.poles;
        pooled.out_of_range += score.out_of_range;
    }
    if (!scores.empty()) pooled.rms = std::sqrt(sum_squares / double(scores.size()));
    return pooled;
}

}  // namespace plumb
