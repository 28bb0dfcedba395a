#include "reports/form_choice.h"

#include <algorithm>

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

}  // namespace plumb
