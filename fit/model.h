// A formula of light with free constants, as a value: what a fit moves and a score judges.
//
//       y = f(p; alpha, V, rho)       p the free constants, most f use only some of the three
//
// A model is written once, as a struct in a header of its own:
//
//       struct EscapeOfV {
//           static constexpr std::string_view kName = "escape of V";
//           static constexpr std::array<Parameter, 2> kParameters{{{"a", 1, 0.1, 4}, ...}};
//           template <class T>
//           static T Evaluate(const T* p, CosineVisibility V, Albedo rho);
//       };
//
// and listed once more in fit/CMakeLists.txt. The signature of Evaluate is the declaration of what the
// model reads: any of UniformVisibility, CosineVisibility, Albedo, in this order. A model that
// reads the albedo predicts the total E(rho), one that does not predicts a curve such as E_1.
// T is double, or the dual numbers that give a fit its exact derivatives. Two more members may be
// there: kUse, what `plumb fit` does with the model, and kShader, its code for shaders, once for
// all languages: the body of a function in the common part of GLSL, HLSL and C++. In it
//
//       {name}     stands for the fitted constant of that name, as a float literal
//       {T}        for the type of the albedo and of the result: float, or three floats
//
// and these are at hand: the arguments that the model reads (uniform_visibility,
// cosine_visibility, albedo), PlumbUnit(x), which clamps to [0, 1] and makes NaN 0, and max,
// min, pow, exp, sqrt. Operators work between floats and {T}.
//
// Symbols  p parameters; alpha, V, rho, E as in core/conventions.h. All unitless.
// Beware   A model holds pointers to static data only: it is cheap to copy and never dangles.
//          In a shader pow(0, y) is defined for y > 0 only, x / 0 never: guard.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/visibility.h"

namespace plumb {

/// One free constant of a model.
struct Parameter {
    std::string_view name;  ///< The paper's symbol.
    double initial = 0;     ///< The published value where there is one; a fit starts here.
    double low = 0;         ///< A fit stays within [low, high]. Starts are spread
    double high = 0;        ///< logarithmically where 0 < low <= high / 100.
};

/// Where a model is evaluated. What is not known is NaN, so that a model that needs it shows.
struct LightPoint {
    UniformVisibility alpha{std::numeric_limits<double>::quiet_NaN()};
    CosineVisibility V{std::numeric_limits<double>::quiet_NaN()};
    Albedo rho{std::numeric_limits<double>::quiet_NaN()};
};

/// Which members of a LightPoint a model reads.
struct ModelInputs {
    bool alpha = false, V = false, rho = false;
    friend bool operator==(const ModelInputs&, const ModelInputs&) = default;
};

/// What `plumb fit` does with a model besides knowing it by name.
enum class ModelUse {
    kNone,      ///< Nothing: it is a baseline, or a part of another.
    kRefitted,  ///< Its constants are fitted, held out, and compared with the others' forms.
    kForm,      ///< The same, but reported only where all forms are asked for.
};

struct Model {
    std::string_view name;
    ModelInputs inputs;
    std::span<const Parameter> parameters;  ///< Empty: nothing to fit.

    /// f(p; at). p has parameters.size() values.
    double (*evaluate)(const double* p, const LightPoint& at) = nullptr;

    /// f(p; at), with df/dp_j written to gradient[j].
    double (*differentiate)(const double* p, const LightPoint& at, double* gradient) = nullptr;

    ModelUse use = ModelUse::kNone;
    std::string_view shader = {};  ///< Empty: there is no code for it.
};

/// Every model there is, in the order of fit/CMakeLists.txt.
std::span<const Model> AllModels();

/// The model of that name. Throws Error, listing the names there are, if there is none.
const Model& FindModel(std::string_view name);

/// The model that the struct M describes.
template <class M>
const Model& ModelOf() {
    return FindModel(M::kName);
}

/// A model with its constants filled in: a function of (alpha, V, rho), and its name.
struct Formula {
    std::string name;
    Model model;
    std::vector<double> values;  ///< One per parameter of the model.

    double operator()(const LightPoint& at) const { return model.evaluate(values.data(), at); }
};

/// The model at its initial values (the published constants where there are any).
Formula AtInitialValues(const Model& model, std::string name);

}  // namespace plumb
