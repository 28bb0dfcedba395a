#include "jobs/light/curves.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "fit/model_fit.h"
#include "fit/models/bounce_curve.h"
#include "fit/models/direct_factor.h"
#include "fit/models/first_bounce.h"

namespace plumb {
namespace {

CurveFit Curve(std::string title, int bounce, const Model& model,
               const std::vector<Sample>& samples, const LeastSquaresOptions& options,
               std::optional<Formula> published) {
    CurveFit curve;
    curve.title = std::move(title);
    curve.bounce = bounce;
    curve.fit = FitModel(model, samples, options);
    curve.fitted = Fitted(model, curve.fit, curve.title);
    if (published) curve.published_score = ScoreOf(*published, samples);
    curve.published = std::move(published);
    return curve;
}

}  // namespace

void FitCurves(const std::function<std::vector<Sample>(int k)>& samples_of, int bounces,
               const LeastSquaresOptions& options, FitReport& report) {
    const Formula F0 = AtInitialValues(ModelOf<DirectFactorModel>(), "F0, published");
    const Formula F1 = AtInitialValues(ModelOf<FirstBounceModel>(), "F1, published");
    report.curves.push_back(
        Curve("F0", 0, ModelOf<DirectFactorModel>(), samples_of(0), options, F0));
    if (bounces < 1) return;
    const std::vector<Sample> first = samples_of(1);
    report.curves.push_back(Curve("F1", 1, ModelOf<FirstBounceModel>(), first, options, F1));
    report.curves.push_back(
        Curve("F1, free exponents", 1, ModelOf<FreeFirstBounceModel>(), first, options,
              AtInitialValues(ModelOf<FreeFirstBounceModel>(), "F1, published")));
    for (int k = 1; k <= std::min(bounces, kMayaux18Bounces); ++k) {
        report.bounce_family.push_back(Curve("E_" + std::to_string(k), k,
                                             ModelOf<BounceCurveModel>(), samples_of(k),
                                             options, std::nullopt));
    }
}

}  // namespace plumb
