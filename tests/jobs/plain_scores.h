// Errors of pictures by the plainest loops, to hold the reports' against.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "core/clock.h"
#include "jobs/truth/view_truth.h"

namespace plumb {

/// A clock that ticks: the same call takes the same time in every run.
inline Clock Ticking() {
    auto now = std::make_shared<double>(0);
    return [now] { return *now += 0.001; };
}

/// 1 where the camera sees a surface.
inline Image<int> SeenPixels(const ViewTruth& truth) {
    const Image<float>& depth = truth.pixels.depth_m;
    Image<int> seen(depth.Width(), depth.Height(), 0);
    for (std::size_t p = 0; p < seen.Pixels().size(); ++p) {
        seen.Pixels()[p] = std::isfinite(depth.Pixels()[p]);
    }
    return seen;
}

/// Those within 32 px of the frame.
inline Image<int> SeenAtBorder(const ViewTruth& truth) {
    Image<int> seen = SeenPixels(truth);
    for (int j = 0; j < seen.Height(); ++j) {
        for (int i = 0; i < seen.Width(); ++i) {
            const int from_frame =
                std::min({i, j, seen.Width() - 1 - i, seen.Height() - 1 - j});
            if (from_frame >= 32) seen(i, j) = 0;
        }
    }
    return seen;
}

/// Those of every stride-th row and column.
inline Image<int> Strided(Image<int> pixels, int stride) {
    for (int j = 0; j < pixels.Height(); ++j) {
        for (int i = 0; i < pixels.Width(); ++i) {
            if (i % stride != 0 || j % stride != 0) pixels(i, j) = 0;
        }
    }
    return pixels;
}

struct PlainErrors {
    double pixels = 0, bias = 0, mae = 0, mse = 0;
};

/// mean d, mean |d|, mean (d^2 - s^2). Without standard errors s is 0.
inline PlainErrors PlainScore(const Image<float>& A, const TruthImage& truth,
                              const Image<int>& pixels) {
    PlainErrors sums;
    for (int j = 0; j < A.Height(); ++j) {
        for (int i = 0; i < A.Width(); ++i) {
            if (pixels(i, j) == 0) continue;
            const double d = double(A(i, j)) - truth.value(i, j);
            const double s = truth.standard_error.Empty() ? 0 : truth.standard_error(i, j);
            sums.pixels += 1;
            sums.bias += d;
            sums.mae += std::abs(d);
            sums.mse += d * d - s * s;
        }
    }
    return {sums.pixels, sums.bias / sums.pixels, sums.mae / sums.pixels,
            sums.mse / sums.pixels};
}

inline double PlainRms(const Image<float>& a, const Image<float>& b, const Image<int>& pixels) {
    return std::sqrt(PlainScore(a, {b, {}}, pixels).mse);
}

}  // namespace plumb
