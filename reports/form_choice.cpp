#include "reports/form_choice.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace plumb {

const FormScore& FormChoice::Winner() const {
    return *std::min_element(
        forms.begin(), forms.end(),
        [](const FormScore& a, const FormScore& b) { return a.choosing_rms < b.choosing_rms; });
}

int FormChoice::RankOnReporting(const FormScore& score) const {
    return 1 + int(std::count_if(forms.begin(), forms.end(), [&](const FormScore& other) {
               return other.reporting_rms < score.reporting_rms;
           }));
}

nlohmann::ordered_json ToJson(const FormChoice& choice) {
    nlohmann::ordered_json forms = nlohmann::ordered_json::array();
    for (const FormScore& score : choice.forms)
        forms.push_back({{"form", score.form},
                         {"constants", score.constants},
                         {"choosing_rms", score.choosing_rms},
                         {"reporting_rms", score.reporting_rms}});
    return {{"choosing_maps", choice.choosing},
            {"reporting_maps", choice.reporting},
            {"winner", choice.Winner().form},
            {"forms", forms}};
}

}  // namespace plumb
