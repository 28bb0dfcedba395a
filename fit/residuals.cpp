#include "fit/residuals.h"

namespace plumb {

std::vector<Residual> Residuals(const Formula& formula, std::span<const Sample> samples) {
    std::vector<Residual> residuals;
    residuals.reserve(samples.size());
    for (const Sample& sample : samples) {
        const double predicted = formula(sample.at);
        residuals.push_back(
            {.sample = sample, .predicted = predicted, .difference = predicted - sample.y});
    }
    return residuals;
}

}  // namespace plumb
