// The list of models, and the one place where they meet the dual numbers of Ceres.
#include <ceres/jet.h>

#include <array>
#include <concepts>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/names.h"
#include "fit/model.h"
#include "fit/models/bounce_curve.h"
#include "fit/models/direct_factor.h"
#include "fit/models/escape_alternatives.h"
#include "fit/models/escape_bent_of_v.h"
#include "fit/models/escape_of_alpha_and_v.h"
#include "fit/models/escape_probability.h"
#include "fit/models/first_bounce.h"
#include "fit/models/gtao_cubic.h"
#include "fit/models/mayaux_total.h"
#include "fit/models/plain_visibility.h"
#include "fit/models/uniform_cavity.h"

namespace plumb {
namespace {

template <class M, class... Inputs>
concept Reads = requires(const double* p, Inputs... inputs) {
    { M::Evaluate(p, inputs...) } -> std::same_as<double>;
};

/// What the signature of M::Evaluate says that M reads.
template <class M>
consteval ModelInputs InputsOf() {
    if constexpr (Reads<M, UniformVisibility, CosineVisibility, Albedo>)
        return {.alpha = true, .V = true, .rho = true};
    else if constexpr (Reads<M, UniformVisibility, Albedo>)
        return {.alpha = true, .rho = true};
    else if constexpr (Reads<M, CosineVisibility, Albedo>)
        return {.V = true, .rho = true};
    else if constexpr (Reads<M, UniformVisibility, CosineVisibility>)
        return {.alpha = true, .V = true};
    else if constexpr (Reads<M, UniformVisibility>)
        return {.alpha = true};
    else {
        static_assert(Reads<M, CosineVisibility>, "a model reads alpha, V or both, then rho");
        return {.V = true};
    }
}

template <class M, class T>
T EvaluateAt(const T* p, const LightPoint& at) {
    constexpr ModelInputs kInputs = InputsOf<M>();
    if constexpr (kInputs.alpha && kInputs.V && kInputs.rho)
        return M::Evaluate(p, at.alpha, at.V, at.rho);
    else if constexpr (kInputs.alpha && kInputs.rho)
        return M::Evaluate(p, at.alpha, at.rho);
    else if constexpr (kInputs.V && kInputs.rho)
        return M::Evaluate(p, at.V, at.rho);
    else if constexpr (kInputs.alpha && kInputs.V)
        return M::Evaluate(p, at.alpha, at.V);
    else if constexpr (kInputs.alpha)
        return M::Evaluate(p, at.alpha);
    else
        return M::Evaluate(p, at.V);
}

template <class M>
double Differentiate(const double* p, const LightPoint& at, double* gradient) {
    constexpr int kN = int(M::kParameters.size());
    if constexpr (kN == 0) {
        return EvaluateAt<M, double>(p, at);
    } else {
        using Dual = ceres::Jet<double, kN>;
        std::array<Dual, kN> x;
        for (int j = 0; j < kN; ++j) x[j] = Dual(p[j], j);
        const Dual y = EvaluateAt<M, Dual>(x.data(), at);
        for (int j = 0; j < kN; ++j) gradient[j] = y.v[j];
        return y.a;
    }
}

template <class M>
Model Erased() {
    return {.name = M::kName,
            .inputs = InputsOf<M>(),
            .parameters = M::kParameters,
            .evaluate = &EvaluateAt<M, double>,
            .differentiate = &Differentiate<M>};
}

}  // namespace

std::span<const Model> AllModels() {
    static const std::vector<Model> kModels{
        Erased<DirectFactorModel>(),
        Erased<FirstBounceModel>(),
        Erased<FreeFirstBounceModel>(),
        Erased<BounceCurveModel>(),
        Erased<MayauxTotalModel<PoleGuard::kNone>>(),
        Erased<MayauxTotalModel<PoleGuard::kDemo>>(),
        Erased<MayauxTotalModel<PoleGuard::kPort>>(),
        Erased<MayauxTotalModel<PoleGuard::kPortHalfAlbedo>>(),
        Erased<EscapeOfV>(),
        Erased<EscapeOfAlpha>(),
        Erased<EscapeOfAlphaClamped>(),
        Erased<EscapeBentOfV>(),
        Erased<EscapeOfAlphaAndV>(),
        Erased<EscapeLinearOfV>(),
        Erased<TwoEscapesLinearOfV>(),
        Erased<EscapePowerOfAlpha>(),
        Erased<EscapeOfClosures>(),
        Erased<EscapeScaledOfBoth>(),
        Erased<EscapeRaisedOfBoth>(),
        Erased<TwoEscapesOfBoth>(),
        Erased<PlainAlphaModel>(),
        Erased<PlainVModel>(),
        Erased<GtaoCubicModel>(),
        Erased<GtaoCubicFedAlphaModel>(),
        Erased<UniformCavityModel>(),
    };
    return kModels;
}

const Model& FindModel(std::string_view name) {
    std::vector<std::string> names;
    for (const Model& model : AllModels()) {
        if (model.name == name) return model;
        names.emplace_back(model.name);
    }
    // Some names have a comma.
    throw Error("model = " + std::string(name) + ", " + MustBeOneOf(name, names, "; "));
}

Formula AtInitialValues(const Model& model, std::string name) {
    Formula formula{.name = std::move(name), .model = model, .values = {}};
    for (const Parameter& parameter : model.parameters)
        formula.values.push_back(parameter.initial);
    return formula;
}

}  // namespace plumb
