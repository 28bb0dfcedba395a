#include "fit/mayaux_refit.h"

#include <utility>

#include "fit/model_fit.h"

namespace plumb {
namespace {

const Model& TotalModel(PoleGuard guard) {
    switch (guard) {
        case PoleGuard::kNone:
            return ModelOf<MayauxTotalModel<PoleGuard::kNone>>();
        case PoleGuard::kDemo:
            return ModelOf<MayauxTotalModel<PoleGuard::kDemo>>();
        case PoleGuard::kPort:
            return ModelOf<MayauxTotalModel<PoleGuard::kPort>>();
        case PoleGuard::kPortHalfAlbedo:
            break;
    }
    return ModelOf<MayauxTotalModel<PoleGuard::kPortHalfAlbedo>>();
}

}  // namespace

MayauxConstants<> MayauxRefit::Constants() const {
    return {.F0 = {F0.parameters[0].value, F0.parameters[1].value},
            .F1 = {F1.parameters[0].value, F1.parameters[1].value}};
}

MayauxRefit RefitMayaux(std::span<const BounceHistogram> maps, const SampleOptions& sampling,
                        const LeastSquaresOptions& options) {
    return {
        .F0 = FitModel(ModelOf<DirectFactorModel>(), BounceSamples(maps, 0, sampling), options),
        .F1 = FitModel(ModelOf<FirstBounceModel>(), BounceSamples(maps, 1, sampling), options)};
}

Formula MayauxFormula(const MayauxConstants<>& constants, PoleGuard guard, std::string name) {
    return {.name = std::move(name),
            .model = TotalModel(guard),
            .values = {constants.F0.a, constants.F0.p, constants.F1.A, constants.F1.B}};
}

}  // namespace plumb
