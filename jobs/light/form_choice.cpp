#include "jobs/light/form_choice.h"

#include "fit/fitting_method.h"
#include "fit/leave_one_out.h"
#include "fit/models/gtao_cubic.h"
#include "fit/models/uniform_cavity.h"
#include "fit/scores.h"
#include "jobs/light/histograms.h"

namespace plumb {
namespace {

// One to hold out and one to learn from, in the choosing half.
constexpr std::size_t kLeastMaps = 4;

template <class T>
std::vector<T> EverySecond(const std::vector<T>& all, std::size_t first) {
    std::vector<T> half;
    for (std::size_t m = first; m < all.size(); m += 2) half.push_back(all[m]);
    return half;
}

}  // namespace

std::vector<std::string_view> ComparedForms() {
    // What others have, then ours.
    std::vector<std::string_view> forms{UniformCavityModel::kName, GtaoCubicModel::kName};
    for (const Model& model : AllModels()) {
        if (model.use != ModelUse::kNone && model.name != GtaoCubicModel::kName) {
            forms.push_back(model.name);
        }
    }
    return forms;
}

std::optional<FormChoice> ChooseForm(std::span<const SurfaceLight> lights,
                                     std::span<const std::string_view> forms,
                                     const SampleOptions& sampling,
                                     const LeastSquaresOptions& options, Monitor& monitor) {
    if (lights.size() < kLeastMaps) return {};
    FormChoice choice;
    std::vector<std::string> names;
    for (const SurfaceLight& light : lights) names.push_back(light.name);
    choice.choosing = EverySecond(names, 0);
    choice.reporting = EverySecond(names, 1);
    for (const std::string_view form : forms) {
        const Model& model = FindModel(form);
        const std::vector<BounceHistogram> maps =
            HistogramsBy(BinningFor(model.inputs), lights);
        const std::vector<BounceHistogram> choosing = EverySecond(maps, 0);
        const FittingMethod method = model.parameters.empty()
                                         ? Unfitted(AtInitialValues(model, std::string(form)))
                                         : Refitted(model, sampling, options);
        const HeldOut held_out =
            LeaveOneMapOut(choosing, std::span(&method, 1), monitor).front();
        choice.forms.push_back(
            {.form = std::string(form),
             .constants = int(model.parameters.size()),
             .choosing_rms = held_out.scores.pooled.rms,
             .reporting_rms =
                 ScoreOver(method.learn(choosing), EverySecond(maps, 1)).pooled.rms});
    }
    return choice;
}

}  // namespace plumb
