#include "formfactor/histogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.h"
#include "core/parallel.h"
#include "core/statistics.h"

namespace plumb {
namespace {

// The b whose [b / bins, (b + 1) / bins) holds x, the last interval closed. The product may
// round across an edge (0.29 * 100 < 29); the edges themselves decide.
int IntervalOf(double x, int bins) {
    int b = std::clamp(int(x * bins), 0, bins - 1);
    if (b > 0 && x < double(b) / bins) --b;
    if (b < bins - 1 && x >= double(b + 1) / bins) ++b;
    return b;
}

}  // namespace

HistogramBuilder::HistogramBuilder(std::string surface, BinnedBy binned_by, int bins,
                                   std::span<const double> alpha, std::span<const double> V) {
    const bool both = binned_by == BinnedBy::kBothVisibilities;
    if (bins < 1 || bins > (both ? 1000 : 100000)) {
        throw Error(MustBe("histogram: bins", bins, both ? "in [1, 1000]" : "in [1, 100000]"));
    }
    if (alpha.empty() || alpha.size() != V.size()) {
        throw Error("histogram: alpha and V must hold one value a facet, and at least one");
    }
    histogram_.surface = std::move(surface);
    histogram_.binned_by = binned_by;
    histogram_.bins.resize(std::size_t(both ? bins * bins : bins));
    for (std::size_t b = 0; b < histogram_.bins.size(); ++b) {
        const int row = int(b) / (both ? bins : 1);
        histogram_.bins[b].low = double(row) / bins;
        histogram_.bins[b].high = double(row + 1) / bins;
    }

    const auto interval = [bins](double x) { return IntervalOf(x, bins); };
    std::vector<std::uint32_t> bin_of(alpha.size());
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        bin_of[i] =
            std::uint32_t(both ? interval(alpha[i]) * bins + interval(V[i])
                          : binned_by == BinnedBy::kUniformVisibility ? interval(alpha[i])
                                                                      : interval(V[i]));
    }
    order_.resize(alpha.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return bin_of[a] < bin_of[b]; });
    for (std::uint32_t i : order_) {
        BounceBin& bin = histogram_.bins[bin_of[i]];
        ++bin.count;
        bin.alpha += alpha[i];
        bin.V += V[i];
    }
    bin_begin_.push_back(0);
    for (BounceBin& bin : histogram_.bins) {
        if (bin.count > 0) bin.alpha /= double(bin.count), bin.V /= double(bin.count);
        bin_begin_.push_back(bin_begin_.back() + std::size_t(bin.count));
    }
}

template <class T>
void HistogramBuilder::Add(std::span<const T> values, std::vector<Spread> BounceBin::*member) {
    ParallelFor(std::int64_t(histogram_.bins.size()), 1,
                [&](std::int64_t first, std::int64_t last) {
                    for (std::size_t b = std::size_t(first); b < std::size_t(last); ++b) {
                        Moments moments;
                        std::vector<double> in_bin;
                        in_bin.reserve(bin_begin_[b + 1] - bin_begin_[b]);
                        for (std::size_t k = bin_begin_[b]; k < bin_begin_[b + 1]; ++k) {
                            in_bin.push_back(values[order_[k]]);
                            moments.Add(in_bin.back());
                        }
                        Spread spread{moments.Mean(), moments.Variance()};
                        if (!in_bin.empty()) {
                            spread.p05 = Percentile(in_bin, 0.05);
                            spread.p50 = Percentile(in_bin, 0.50);
                            spread.p95 = Percentile(in_bin, 0.95);
                        }
                        (histogram_.bins[b].*member).push_back(spread);
                    }
                });
}

void HistogramBuilder::AddBounce(std::span<const double> E_k) {
    Add(E_k, &BounceBin::bounce);
}

void HistogramBuilder::AddTotal(double albedo, std::span<const float> E) {
    histogram_.albedos.push_back(albedo);
    Add(E, &BounceBin::total);
}

double FloorOf(const BounceHistogram& histogram, int k, bool total) {
    double sum = 0, count = 0;
    for (const BounceBin& bin : histogram.bins) {
        if (bin.count < 2) continue;
        const Spread& spread = (total ? bin.total : bin.bounce)[std::size_t(k)];
        sum += double(bin.count) * spread.variance;
        count += double(bin.count);
    }
    return count > 0 ? std::sqrt(sum / count) : 0;
}

}  // namespace plumb
