// The code of each model, once for all shader languages.
//
// The text is that of a function's body in the common part of GLSL, HLSL and C++. In it
//
//       {name}     stands for the fitted constant of that name, as a float literal
//       {T}        for the type of the albedo and of the result: float, or three floats
//
// and these are at hand: the arguments that the model reads (uniform_visibility,
// cosine_visibility, albedo), PlumbUnit(x), which clamps to [0, 1] and makes NaN 0, and max,
// min, pow, exp, sqrt. Operators work between floats and {T}.
//
// Beware   pow(0, y) is defined for y > 0 only, x / 0 never: guard. A model added here must be
//          added to the list of tests/reports/shader_header_test.cpp, which compares it with
//          the library and compiles it in every language.
#pragma once

#include <string_view>

namespace plumb {

/// The body of the model of that name (Model::name). Empty if there is none.
std::string_view ShaderBody(std::string_view model);

}  // namespace plumb
