#include "reports/histogram_plots.h"

#include <cmath>

namespace plumb {

std::string AbscissaLabel(BinnedBy binned_by) {
    return binned_by == BinnedBy::kUniformVisibility ? "uniform visibility α [–]"
                                                     : "cosine visibility V [–]";
}

Column Abscissae(const BounceHistogram& histogram) {
    return BinColumn(histogram, [&](const BounceBin& bin) {
        return histogram.binned_by == BinnedBy::kUniformVisibility ? bin.alpha : bin.V;
    });
}

std::optional<BounceHistogram> PooledMeans(std::span<const BounceHistogram* const> maps) {
    if (maps.empty()) return {};
    BounceHistogram pooled{.surface = "all maps",
                           .binned_by = maps[0]->binned_by,
                           .albedos = maps[0]->albedos,
                           .bins = {}};
    const std::size_t bounces = std::size_t(maps[0]->Bounces()) + 1;
    std::vector<double> facets;
    for (const BounceHistogram* map : maps) {
        if (map->bins.size() != maps[0]->bins.size() || map->albedos != pooled.albedos ||
            map->binned_by != pooled.binned_by || std::size_t(map->Bounces()) + 1 != bounces)
            return {};
        facets.push_back(0);
        for (const BounceBin& bin : map->bins) facets.back() += double(bin.count);
    }
    for (std::size_t b = 0; b < maps[0]->bins.size(); ++b) {
        BounceBin bin;
        bin.low = maps[0]->bins[b].low;
        bin.high = maps[0]->bins[b].high;
        bin.bounce.resize(bounces);
        bin.total.resize(pooled.albedos.size());
        double sum_w = 0;
        for (std::size_t m = 0; m < maps.size(); ++m) {
            const BounceBin& from = maps[m]->bins[b];
            if (from.low != bin.low || from.high != bin.high) return {};
            if (from.count == 0) continue;
            const double w = double(from.count) / facets[m];
            sum_w += w;
            bin.count += from.count;
            bin.alpha += w * from.alpha;
            bin.V += w * from.V;
            for (std::size_t k = 0; k < bounces; ++k)
                bin.bounce[k].mean += w * from.bounce[k].mean;
            for (std::size_t r = 0; r < bin.total.size(); ++r)
                bin.total[r].mean += w * from.total[r].mean;
        }
        if (sum_w > 0) {
            bin.alpha /= sum_w;
            bin.V /= sum_w;
            for (Spread& spread : bin.bounce) spread.mean /= sum_w;
            for (Spread& spread : bin.total) spread.mean /= sum_w;
        }
        pooled.bins.push_back(std::move(bin));
    }
    return pooled;
}

std::string BounceColor(int bounce, int last) {
    return ScaleColor(last > 1 ? std::log(bounce) / std::log(last) : 0);
}

bool InLegend(int bounce) {
    return bounce <= 3 || bounce == 5 || bounce % 10 == 0;
}

std::vector<std::size_t> PlottedAlbedos(const std::vector<double>& albedos) {
    std::vector<std::size_t> tenths, all;
    for (std::size_t r = 0; r < albedos.size(); ++r) {
        all.push_back(r);
        if (std::abs(albedos[r] * 10 - std::round(albedos[r] * 10)) < 1e-9) tenths.push_back(r);
    }
    return tenths.size() >= 6 ? tenths : all;
}

}  // namespace plumb
