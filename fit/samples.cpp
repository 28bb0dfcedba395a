#include "fit/samples.h"

#include <cmath>
#include <cstdint>
#include <string>

#include "core/error.h"

namespace plumb {
namespace {

void RequireFinite(double value, const std::string& name) {
    if (!std::isfinite(value)) throw Error(MustBe(name, value, "finite"));
}

void RequireSize(std::size_t size, std::size_t expected, const std::string& name) {
    if (size != expected)
        throw Error(MustBe(name + ".size()", double(size), std::to_string(expected)));
}

void Validate(const SampleOptions& options) {
    if (!(options.spread_floor > 0) || !std::isfinite(options.spread_floor))
        throw Error(MustBe("SampleOptions::spread_floor", options.spread_floor, "> 0"));
}

std::string NameOfBin(const BounceHistogram& map, std::size_t bin) {
    return map.surface + ": bins[" + std::to_string(bin) + "]";
}

std::int64_t FacetsOf(const BounceHistogram& map) {
    std::int64_t n = 0;
    for (std::size_t b = 0; b < map.bins.size(); ++b) {
        const std::int64_t count = map.bins[b].count;
        if (count < 0) throw Error(MustBe(NameOfBin(map, b) + ".count", double(count), ">= 0"));
        n += count;
    }
    if (n == 0) throw Error(map.surface + ": the histogram holds no facet, nothing to fit");
    return n;
}

double WeightOf(const SampleOptions& options, std::int64_t n_bin, std::int64_t n_map,
                double variance) {
    const double share = double(n_bin) / double(n_map);
    switch (options.weighting) {
        case Weighting::kUnweighted:
            return 1;
        case Weighting::kPopulation:
            return share;
        case Weighting::kPopulationOverVariance:
            break;
    }
    return share / (variance + options.spread_floor * options.spread_floor);
}

/// Calls visit(bin, name of the bin, facets of the map, index of the map) for every bin that
/// holds a facet, its abscissae checked.
template <class Visit>
void ForEachBin(std::span<const BounceHistogram> maps, const Visit& visit) {
    for (std::size_t m = 0; m < maps.size(); ++m) {
        const std::int64_t n_map = FacetsOf(maps[m]);
        for (std::size_t b = 0; b < maps[m].bins.size(); ++b) {
            const BounceBin& bin = maps[m].bins[b];
            if (bin.count == 0) continue;
            const std::string name = NameOfBin(maps[m], b);
            RequireFinite(bin.alpha, name + ".alpha");
            RequireFinite(bin.V, name + ".V");
            visit(bin, name, n_map, int(m));
        }
    }
}

Sample SampleOf(const BounceBin& bin, Albedo rho, const Spread& spread, const std::string& name,
                const SampleOptions& options, std::int64_t n_map, int map) {
    RequireFinite(spread.mean, name + ".mean");
    RequireFinite(spread.variance, name + ".variance");
    return {.at = {UniformVisibility(bin.alpha), CosineVisibility(bin.V), rho},
            .y = spread.mean,
            .weight = WeightOf(options, bin.count, n_map, spread.variance),
            .map = map};
}

}  // namespace

std::vector<Sample> TotalSamples(std::span<const BounceHistogram> maps,
                                 const SampleOptions& options) {
    Validate(options);
    std::vector<Sample> samples;
    ForEachBin(maps,
               [&](const BounceBin& bin, const std::string& name, std::int64_t n_map, int map) {
                   const std::vector<double>& albedos = maps[map].albedos;
                   RequireSize(bin.total.size(), albedos.size(), name + ".total");
                   for (std::size_t r = 0; r < albedos.size(); ++r)
                       samples.push_back(SampleOf(bin, Albedo(albedos[r]), bin.total[r],
                                                  name + ".total[" + std::to_string(r) + "]",
                                                  options, n_map, map));
               });
    return samples;
}

std::vector<Sample> BounceSamples(std::span<const BounceHistogram> maps, int k,
                                  const SampleOptions& options) {
    Validate(options);
    if (k < 0) throw Error(MustBe("bounce", k, ">= 0"));
    std::vector<Sample> samples;
    ForEachBin(maps,
               [&](const BounceBin& bin, const std::string& name, std::int64_t n_map, int map) {
                   const std::string bounce = name + ".bounce";
                   if (bin.bounce.size() <= std::size_t(k))
                       throw Error(MustBe(bounce + ".size()", double(bin.bounce.size()),
                                          "> " + std::to_string(k)));
                   samples.push_back(SampleOf(bin, LightPoint{}.rho, bin.bounce[k],
                                              bounce + "[" + std::to_string(k) + "]", options,
                                              n_map, map));
               });
    return samples;
}

std::vector<Sample> PairSamples(BinnedBy abscissa, std::span<const double> x,
                                std::span<const double> y) {
    RequireSize(y.size(), x.size(), "y");
    std::vector<Sample> samples(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
        RequireFinite(x[i], "x[" + std::to_string(i) + "]");
        RequireFinite(y[i], "y[" + std::to_string(i) + "]");
        if (abscissa == BinnedBy::kUniformVisibility)
            samples[i].at.alpha = UniformVisibility(x[i]);
        else
            samples[i].at.V = CosineVisibility(x[i]);
        samples[i].y = y[i];
    }
    return samples;
}

}  // namespace plumb
