#include "fit/model_fit.h"

#include <cmath>
#include <utility>

#include "core/error.h"

namespace plumb {
namespace {

void RequireInput(const Model& model, bool reads, double value, const char* input,
                  std::size_t sample) {
    if (reads && !std::isfinite(value))
        throw Error(MustBe(
            std::string(model.name) + ": sample " + std::to_string(sample) + ", " + input,
            value, "finite, the model reads it"));
}

}  // namespace

LeastSquaresFit FitModel(const Model& model, std::span<const Sample> samples,
                         const LeastSquaresOptions& options) {
    if (model.parameters.empty())
        throw Error(std::string(model.name) + ": has no free constant, nothing to fit");
    std::vector<double> y, weights;
    std::vector<LightPoint> points;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const Sample& sample = samples[i];
        if (sample.weight == 0) continue;
        RequireInput(model, model.inputs.alpha, sample.at.alpha.value, "alpha", i);
        RequireInput(model, model.inputs.V, sample.at.V.value, "V", i);
        RequireInput(model, model.inputs.rho, sample.at.rho.value, "rho", i);
        points.push_back(sample.at);
        y.push_back(sample.y);
        weights.push_back(sample.weight);
    }
    const std::size_t n = model.parameters.size();
    const auto predict = [&](const double* p, double* f, double* jacobian) {
        for (std::size_t i = 0; i < points.size(); ++i)
            f[i] = jacobian ? model.differentiate(p, points[i], jacobian + i * n)
                            : model.evaluate(p, points[i]);
    };
    return Minimize({.name = std::string(model.name),
                     .parameters = model.parameters,
                     .y = y,
                     .weights = weights,
                     .predict = predict},
                    options);
}

Formula Fitted(const Model& model, const LeastSquaresFit& fit, std::string name) {
    return {.name = std::move(name), .model = model, .values = fit.Values()};
}

std::vector<LeastSquaresFit> FitBounceFamily(std::span<const BounceHistogram> maps,
                                             const SampleOptions& sampling, int bounces,
                                             const LeastSquaresOptions& options) {
    std::vector<LeastSquaresFit> fits;
    for (int k = 1; k <= bounces; ++k)
        fits.push_back(
            FitModel(ModelOf<BounceCurveModel>(), BounceSamples(maps, k, sampling), options));
    return fits;
}

}  // namespace plumb
