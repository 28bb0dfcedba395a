#include "fit/bootstrap.h"

#include <cmath>
#include <map>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/statistics.h"
#include "fit/model_fit.h"

namespace plumb {
namespace {

/// Draw number `draw` of a replicate: an index in [0, n). The bias, n / 2^32, is nothing.
std::size_t DrawIndex(std::uint64_t seed, std::int64_t replicate, std::size_t draw,
                      std::size_t n) {
    constexpr std::uint64_t kNoPixel = 0;
    return ((RandomBits(seed, kNoPixel, std::uint64_t(replicate), draw) >> 32) * n) >> 32;
}

BootstrapInterval IntervalOf(std::string_view name, const std::vector<double>& values,
                             double confidence) {
    Moments moments;
    for (double value : values) moments.Add(value);
    return {.name = std::string(name),
            .standard_error = std::sqrt(moments.Variance()),
            .low = Percentile(values, (1 - confidence) / 2),
            .high = Percentile(values, (1 + confidence) / 2)};
}

}  // namespace

void Validate(const BootstrapOptions& options) {
    if (options.replicates < 2)
        throw Error(MustBe("BootstrapOptions::replicates", options.replicates, ">= 2"));
    if (!(options.confidence > 0 && options.confidence < 1))
        throw Error(MustBe("BootstrapOptions::confidence", options.confidence, "in (0, 1)"));
}

BootstrapResult BootstrapOverMaps(const Model& model, std::span<const Sample> samples,
                                  const BootstrapOptions& bootstrap,
                                  const LeastSquaresOptions& options, Monitor& monitor) {
    Validate(bootstrap);
    std::map<int, std::size_t> index_of_map;
    for (const Sample& sample : samples) index_of_map.try_emplace(sample.map, 0);
    const std::size_t n_maps = index_of_map.size();
    if (n_maps < 2) throw Error(MustBe("maps to draw from", double(n_maps), ">= 2"));
    std::size_t next = 0;
    for (auto& [map, index] : index_of_map) index = next++;

    const std::vector<double> all = FitModel(model, samples, options).Values();
    std::vector<Parameter> parameters(model.parameters.begin(), model.parameters.end());
    for (std::size_t j = 0; j < parameters.size(); ++j) parameters[j].initial = all[j];
    Model started_there = model;
    started_there.parameters = parameters;

    std::vector<std::vector<double>> fitted(bootstrap.replicates);  // Empty where it failed.
    ParallelFor(
        bootstrap.replicates, 1,
        [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t replicate = begin; replicate < end; ++replicate) {
                std::vector<double> multiplicity(n_maps, 0);
                for (std::size_t draw = 0; draw < n_maps; ++draw)
                    ++multiplicity[DrawIndex(bootstrap.seed, replicate, draw, n_maps)];
                std::vector<Sample> drawn(samples.begin(), samples.end());
                for (Sample& sample : drawn)
                    sample.weight *= multiplicity[index_of_map.at(sample.map)];
                try {
                    const LeastSquaresFit fit = FitModel(started_there, drawn, options);
                    if (fit.converged) fitted[replicate] = fit.Values();
                } catch (const Error&) {
                    // The maps drawn leave nothing to fit: an outcome, counted below.
                }
            }
        },
        monitor, "bootstrap");

    std::erase_if(fitted, [](const std::vector<double>& values) { return values.empty(); });
    BootstrapResult result;
    result.replicates = int(fitted.size());
    result.failed = bootstrap.replicates - result.replicates;
    if (result.replicates < 2)
        throw Error(MustBe(std::string(model.name) + ": bootstrap replicates that gave a fit",
                           result.replicates, ">= 2"));
    for (std::size_t j = 0; j < parameters.size(); ++j) {
        std::vector<double> values;
        for (const std::vector<double>& replicate : fitted) values.push_back(replicate[j]);
        result.parameters.push_back(
            IntervalOf(parameters[j].name, values, bootstrap.confidence));
    }
    return result;
}

}  // namespace plumb
