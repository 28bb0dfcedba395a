#include "score/other_tools.h"

#include <algorithm>
#include <cmath>

#include "score/pixels.h"

namespace plumb {
namespace {

/// visit(c, t) of every number of both.
template <class Visit>
double ForEachPair(ChannelSpan candidate, ChannelSpan reference, const Visit& visit) {
    CheckChannels({candidate}, reference, {}, {});
    double n = 0;
    for (std::size_t k = 0; k < reference.size(); ++k) {
        for (std::size_t p = 0; p < reference[k].Pixels().size(); ++p) {
            visit(double(candidate[k].Pixels()[p]), double(reference[k].Pixels()[p]));
            ++n;
        }
    }
    return n;
}

bool MatchUnbounded(double c, double t) {
    return (std::isnan(c) && std::isnan(t)) || (std::isinf(c) && std::isinf(t));
}

}  // namespace

IdiffFigures FiguresOfIdiff(ChannelSpan candidate, ChannelSpan reference) {
    IdiffFigures figures;
    double sum = 0, squares = 0;
    const double n = ForEachPair(candidate, reference, [&](double c, double t) {
        if (MatchUnbounded(c, t)) return;
        const double d = std::abs(c - t);
        sum += d;
        squares += d * d;
        figures.max = std::isnan(figures.max) || std::isnan(d) ? NAN : std::max(figures.max, d);
        figures.peak = std::max({figures.peak, std::abs(c), std::abs(t)});
    });
    figures.mean = sum / n;
    figures.rms = std::sqrt(squares / n);
    figures.psnr_db = 20 * std::log10(figures.peak / figures.rms);
    return figures;
}

PbrtFigures FiguresOfPbrt(ChannelSpan candidate, ChannelSpan reference) {
    PbrtFigures figures;
    const auto finite = [](double x) { return std::isinf(x) ? 0 : x; };
    const double n = ForEachPair(candidate, reference, [&](double c, double t) {
        const double d = finite(c) - finite(t), shifted = finite(t) + 0.01;
        figures.mae += std::abs(d);
        figures.mse += d * d;
        const double relative = d * d / (shifted * shifted);
        if (std::isfinite(relative)) figures.mrse += relative;
    });
    return {figures.mae / n, figures.mse / n, figures.mrse / n};
}

FalcorFigures FiguresOfFalcor(ChannelSpan candidate, ChannelSpan reference) {
    FalcorFigures figures;
    const double n = ForEachPair(candidate, reference, [&](double c, double t) {
        const double d = c - t;
        figures.mse += d * d;
        figures.rmse += d * d / (c * c + 1e-3);
        figures.mape += std::abs(d / (c + 1e-3));
    });
    const double mse = figures.mse / n;
    return {.mse = mse, .rmse = figures.rmse / n, .mae = mse, .mape = 100 * figures.mape / n};
}

}  // namespace plumb
