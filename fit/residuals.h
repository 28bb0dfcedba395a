// The curve of what a formula leaves unexplained, point by point, to be plotted or read.
#pragma once

#include <span>
#include <vector>

#include "fit/model.h"
#include "fit/samples.h"

namespace plumb {

struct Residual {
    Sample sample;
    double predicted = 0;   ///< f at the sample; may be not finite at a pole.
    double difference = 0;  ///< f - y: positive where the formula is too bright.
};

/// In the order of the samples.
std::vector<Residual> Residuals(const Formula& formula, std::span<const Sample> samples);

}  // namespace plumb
