#include "score/relative_error.h"

#include <cmath>

#include "score/pixels.h"

namespace plumb {
namespace {

double Relative(const RelativeForm& form, double c, double t, double s2) {
    const double d = c - t, eps = form.epsilon;
    switch (form.kind) {
        case RelativeKind::kSquareOverSquare:
            return (d * d - s2) / (t * t + eps);
        case RelativeKind::kSquareOverShifted:
            return (d * d - s2) / ((t + eps) * (t + eps));
        case RelativeKind::kOverShifted:
            return std::abs(d) / (std::abs(t) + eps);
        case RelativeKind::kSymmetric:
            break;
    }
    return 2 * std::abs(d) / (std::abs(c) + std::abs(t) + eps);
}

}  // namespace

const std::vector<RelativeForm>& RelativeForms() {
    using enum RelativeKind;
    static const std::vector<RelativeForm> forms{
        {"relmse", "d^2 / (t^2 + 0.01)", "relMSE of papers since [Rousselle11]; tev: RSE",
         kSquareOverSquare, 1e-2},
        {"relmse_1e4", "d^2 / (t^2 + 0.0001)", "JERI: MRSE", kSquareOverSquare, 1e-4},
        {"mrse", "d^2 / (t + 0.01)^2", "pbrt-v4: MRSE", kSquareOverShifted, 1e-2},
        {"mape", "|d| / (|t| + 0.01)", "tev: RAE; JERI: MAPE", kOverShifted, 1e-2},
        {"smape", "2 |d| / (|c| + |t| + 0.02)", "JERI: SMAPE", kSymmetric, 2e-2},
    };
    return forms;
}

Measured ScoreRelative(const RelativeForm& form, ChannelSpan candidate, ChannelSpan truth,
                       ChannelSpan standard_error, const Mask& mask,
                       const ErrorOptions& options) {
    Validate(options);
    CheckChannels({candidate}, truth, standard_error, mask);
    const Tiling tiling(truth[0].Width(), truth[0].Height(), options.tile_px);
    std::vector<double> y(std::size_t(tiling.Count()), 0);
    std::vector<std::int64_t> n(std::size_t(tiling.Count()), 0);
    ForEachCounted(tiling, standard_error, int(truth.size()), mask,
                   [&](int tile, int channel, int i, int j, double s2) {
                       const auto c = std::size_t(channel), b = std::size_t(tile);
                       y[b] += Relative(form, FinitePixel(candidate[c], i, j, "candidate"),
                                        FinitePixel(truth[c], i, j, "truth"), s2);
                       ++n[b];
                   });
    return RatioOverTiles(tiling, y, n, options.confidence);
}

}  // namespace plumb
