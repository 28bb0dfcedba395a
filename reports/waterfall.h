// A waterfall: what each step adds to an error or takes from it, as a drawing within a page.
#pragma once

#include <string>
#include <vector>

namespace plumb {

struct WaterfallStep {
    std::string name;
    double value = 0;   ///< After the step: the bar runs from the last value to this one.
    double marked = 0;  ///< A second figure, drawn as a tick.
};

/// Inline SVG, one row a step, the first bar from 0; rising bars are warm, falling ones cool. The
/// caption calls the value and the tick by these names.
std::string WaterfallSvg(const std::vector<WaterfallStep>& steps, const std::string& value_name,
                         const std::string& tick_name);

}  // namespace plumb
