#include "fit/fitting_method.h"

#include <utility>

#include "fit/mayaux_refit.h"
#include "fit/model_fit.h"

namespace plumb {

FittingMethod Unfitted(Formula formula) {
    std::string name = formula.name;
    return {.name = std::move(name),
            .learn = [formula = std::move(formula)](std::span<const BounceHistogram>) {
                return formula;
            }};
}

FittingMethod Refitted(const Model& model, const SampleOptions& sampling,
                       const LeastSquaresOptions& options) {
    const std::string name = std::string(model.name) + ", refitted";
    return {.name = name, .learn = [=](std::span<const BounceHistogram> maps) {
                return Fitted(model, FitModel(model, TotalSamples(maps, sampling), options),
                              name);
            }};
}

FittingMethod RefittedAsPublished(PoleGuard guard, const SampleOptions& sampling,
                                  const LeastSquaresOptions& options) {
    const Formula published = MayauxFormula(kMayaux18, guard, "");
    const std::string name = std::string(published.model.name) + ", curves refitted";
    return {.name = name, .learn = [=](std::span<const BounceHistogram> maps) {
                return MayauxFormula(RefitMayaux(maps, sampling, options).Constants(), guard,
                                     name);
            }};
}

}  // namespace plumb
