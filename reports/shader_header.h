// Fitted formulas as shader code to paste: one header in GLSL, HLSL or C++.
//
//       float  PlumbTotal(float cosine_visibility, float albedo)
//       float3 PlumbTotal(float cosine_visibility, float3 albedo)
//
// is the recommended formula for E(rho); the alternatives follow under their own names. What a
// formula needs (uniform or cosine visibility or both, then the albedo) is in the names of its
// arguments. Inputs are clamped to the domain and the result to [0, 1], so that no input gives
// NaN or light from nowhere.
//
// The three languages share one text; only a prologue of a few lines differs. A model's code is
// written once, beside its formula (fit/model.h).
//
// Beware   The code computes in float32. Against the library's double it is off by a few
//          float epsilons (tests/reports/shader_header_test.cpp says how many). GLSL 1.30 or
//          GLSL ES 3.00 and later.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "fit/model.h"
#include "reports/provenance.h"

namespace plumb {

enum class ShaderLanguage { kGlsl, kHlsl, kCpp };

/// One formula of the header.
struct ShaderFormula {
    static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

    Formula formula;       ///< Its model must have shader code.
    std::string function;  ///< "PlumbEscapeOfV": an identifier in all three languages.
    std::string comment;   ///< What it is, in one line. May be empty.
    double rms = kUnknown, held_out_rms = kUnknown;  ///< Of E(rho), over the maps.
    std::vector<std::string> caveats;                ///< One line each (reports/fit_caveats.h).
};

struct ShaderHeader {
    Provenance provenance;
    ShaderFormula recommended;  ///< function is ignored: it is PlumbTotal.
    std::vector<ShaderFormula> alternatives;
    double published_rms = ShaderFormula::kUnknown;  ///< [Mayaux18 eq. 12] on the same data.
};

/// The header. Throws Error if a model has no shader code, or a constant is not finite.
std::string WriteShaderHeader(const ShaderHeader& header, ShaderLanguage language);

/// "glsl", "hlsl", "h": the usual ending of such a file.
std::string Extension(ShaderLanguage language);

}  // namespace plumb
