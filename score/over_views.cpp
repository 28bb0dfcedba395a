#include "score/over_views.h"

#include <cassert>
#include <cmath>
#include <vector>

#include "core/distributions.h"
#include "core/statistics.h"

namespace plumb {
namespace {

std::vector<Measured> Each(std::span<const ErrorScore> views, Measured ErrorScore::*member) {
    std::vector<Measured> figures;
    for (const ErrorScore& view : views) figures.push_back(view.*member);
    return figures;
}

}  // namespace

Measured MeanOverViews(std::span<const Measured> views, double confidence) {
    assert(!views.empty() && confidence > 0 && confidence < 1);
    if (views.size() == 1) return views.front();
    const double n = double(views.size());
    Moments moments;
    double noise2 = 0;
    for (const Measured& view : views) {
        moments.Add(view.value);
        noise2 += view.noise_error * view.noise_error;
    }
    const double error = std::sqrt(moments.Variance() / n), mean = moments.Mean();
    const double half = StudentQuantile(0.5 + confidence / 2, n - 1) * error;
    return {.value = mean,
            .standard_error = error,
            .interval = {mean - half, mean + half},
            .noise_error = std::sqrt(noise2) / n};
}

Measured MeanSquareOverViews(std::span<const Measured> views, double confidence) {
    Measured mean = MeanOverViews(views, confidence);
    if (views.size() == 1 || !(mean.value > 0)) return mean;
    const double half = (mean.interval.high - mean.value) / mean.value;
    mean.interval = {mean.value * std::exp(-half), mean.value * std::exp(half)};
    return mean;
}

Measured RootMeanSquareOverViews(std::span<const Measured> views, double confidence) {
    if (views.size() == 1) return views.front();
    std::vector<Measured> squares(views.begin(), views.end());
    for (Measured& square : squares) {
        square.noise_error *= 2 * square.value;
        square.value *= square.value;
    }
    return RmseOf(MeanSquareOverViews(squares, confidence));
}

ErrorScore ScoreOverViews(std::span<const ErrorScore> views, double confidence) {
    assert(!views.empty());
    if (views.size() == 1) return views.front();
    ErrorScore score = views.front();
    score.pixels = 0;
    score.tiles = 0;
    double truth_variance = 0, mae_noise_bias = 0;
    for (const ErrorScore& view : views) {
        score.pixels += view.pixels;
        score.tiles += view.tiles;
        truth_variance += view.truth_variance;
        mae_noise_bias += view.mae_noise_bias;
        score.max_at_least = std::max(score.max_at_least, view.max_at_least);
        if (view.max <= score.max) continue;
        score.max = view.max;
        score.max_column = view.max_column;
        score.max_row = view.max_row;
    }
    score.truth_variance = truth_variance / double(views.size());
    score.mae_noise_bias = mae_noise_bias / double(views.size());
    score.bias = MeanOverViews(Each(views, &ErrorScore::bias), confidence);
    score.mae = MeanOverViews(Each(views, &ErrorScore::mae), confidence);
    score.mae.interval.low = std::max(0.0, score.mae.interval.low - score.mae_noise_bias);
    score.mse = MeanSquareOverViews(Each(views, &ErrorScore::mse), confidence);
    score.rmse = RmseOf(score.mse);
    score.psnr_db = PsnrOf(score.mse, 1);
    score.psnr_paper_db = PsnrOf(score.mse, kPaperPeak);
    return score;
}

}  // namespace plumb
