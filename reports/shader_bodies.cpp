#include "reports/shader_bodies.h"

#include "fit/models/escape_bent_of_v.h"
#include "fit/models/escape_of_alpha_and_v.h"
#include "fit/models/escape_probability.h"
#include "fit/models/gtao_cubic.h"
#include "fit/models/mayaux_total.h"
#include "fit/models/uniform_cavity.h"

namespace plumb {
namespace {

struct Body {
    std::string_view model, text;
};

// 1e-20 keeps 0 / 0 away at rho = 1 and g = 0, where the numerator is 0, and is far below
// anything that a float 1 - rho can be.

constexpr std::string_view kEscapeOfV = R"(
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    float g = PlumbUnit({a} * pow(V, {b}));
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

// pow(0, 0) is undefined in GLSL and HLSL: b and c may be 0 where no sky is left.
constexpr std::string_view kEscapeOfBoth = R"(
    float alpha = PlumbUnit(uniform_visibility);
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    float g = min(alpha, V) > 0.0f ? PlumbUnit(pow(V, {b}) * pow(alpha, {c})) : 0.0f;
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

constexpr std::string_view kEscapeBentOfV = R"(
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    float g = V > 0.0f ? PlumbUnit(pow(V, {b}) * (1.0f - {c} * (1.0f - V))) : 0.0f;
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

constexpr std::string_view kEscapeOfAlpha = R"(
    float alpha = PlumbUnit(uniform_visibility);
    {T} rho = PlumbUnit(albedo);
    float V = PlumbUnit(alpha * (1.0f + {a0} * pow(1.0f - alpha, {p0})));
    float g = PlumbUnit({a} * pow(V, {b}));
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

// F0 is kept under alpha (2 - alpha), which no V exceeds.
constexpr std::string_view kEscapeOfAlphaClamped = R"(
    float alpha = PlumbUnit(uniform_visibility);
    {T} rho = PlumbUnit(albedo);
    float F0 = alpha * (1.0f + {a0} * pow(1.0f - alpha, {p0}));
    float V = PlumbUnit(min(F0, alpha * (2.0f - alpha)));
    float g = PlumbUnit({a} * pow(V, {b}));
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * g, 1e-20f)));
)";

constexpr std::string_view kCavity = R"(
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    return PlumbUnit(1.0f - (1.0f - V) * ((1.0f - rho) / max((1.0f - rho) + rho * V, 1e-20f)));
)";

constexpr std::string_view kGtaoCubic = R"(
    float V = PlumbUnit(cosine_visibility);
    {T} rho = PlumbUnit(albedo);
    {T} a = {a1} * rho + {a0};
    {T} b = {b1} * rho + {b0};
    {T} c = {c1} * rho + {c0};
    return PlumbUnit(max(((a * V + b) * V + c) * V, V));
)";

// [Mayaux18 eq. 12] under PoleGuard::kPort. With D = 1 - F0, the fraction is widened by D:
// F1 / (1 - rho tau) = F1 D / ((1 - rho) D + rho F1), which does not subtract nearly equal
// floats. The last max is the guard 1 - rho tau >= 1e-5.
constexpr std::string_view kMayauxPort = R"(
    float alpha = min(PlumbUnit(uniform_visibility), 0.999f);
    {T} rho = PlumbUnit(albedo);
    float F0 = alpha * (1.0f + {a} * pow(1.0f - alpha, {p}));
    float F1 = {A} * alpha * pow(1.0f - alpha, 1.5f) * exp(-{B} * sqrt(sqrt(alpha)));
    float D = max(1.0f - F0, 1e-5f);
    return PlumbUnit(F0 + rho * F1 * D / max((1.0f - rho) * D + rho * F1, 1e-5f * D));
)";

constexpr Body kBodies[] = {
    {EscapeOfV::kName, kEscapeOfV},
    {EscapeOfAlpha::kName, kEscapeOfAlpha},
    {EscapeOfAlphaClamped::kName, kEscapeOfAlphaClamped},
    {EscapeOfAlphaAndV::kName, kEscapeOfBoth},
    {EscapeBentOfV::kName, kEscapeBentOfV},
    {UniformCavityModel::kName, kCavity},
    {GtaoCubicModel::kName, kGtaoCubic},
    {MayauxTotalModel<PoleGuard::kPort>::kName, kMayauxPort},
};

}  // namespace

std::string_view ShaderBody(std::string_view model) {
    for (const Body& body : kBodies)
        if (body.model == model) return body.text;
    return {};
}

}  // namespace plumb
