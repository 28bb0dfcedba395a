#include "core/statistics.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/distributions.h"

namespace plumb {

void Moments::Merge(const Moments& later) {
    if (later.n_ == 0) return;
    const double n = double(n_), m = double(later.n_), between = later.mean_ - mean_;
    mean_ += between * (m / (n + m));
    m2_ += later.m2_ + between * between * (n * m / (n + m));
    n_ += later.n_;
}

double Moments::StandardError() const {
    return n_ < 2 ? std::numeric_limits<double>::infinity()
                  : std::sqrt(Variance() / double(n_));
}

double Moments::HalfWidth(double confidence) const {
    if (n_ < 2) return std::numeric_limits<double>::infinity();
    return StudentQuantile((1 + confidence) / 2, double(n_ - 1)) * StandardError();
}

double Percentile(std::vector<double> values, double share) {
    assert(!values.empty() && 0 <= share && share <= 1);
    const double position = share * double(values.size() - 1);
    const auto lower = values.begin() + std::ptrdiff_t(position);
    std::nth_element(values.begin(), lower, values.end());
    const double fraction = position - std::floor(position);
    if (fraction == 0) return *lower;
    const double above = *std::min_element(lower + 1, values.end());
    return *lower + fraction * (above - *lower);
}

}  // namespace plumb
