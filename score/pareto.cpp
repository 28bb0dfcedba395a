#include "score/pareto.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.h"

namespace plumb {
namespace {

void Check(std::span<const TimedError> points) {
    for (const TimedError& point : points) {
        if (std::isnan(point.time_s))
            throw Error(MustBe(point.name + ": time_s", point.time_s, "a number"));
        if (std::isnan(point.error))
            throw Error(MustBe(point.name + ": error", point.error, "a number"));
    }
}

}  // namespace

std::vector<std::size_t> ParetoFront(std::span<const TimedError> points) {
    Check(points);
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return points[a].time_s != points[b].time_s ? points[a].time_s < points[b].time_s
                                                    : points[a].error < points[b].error;
    });
    std::vector<std::size_t> front;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k : order) {
        if (points[k].error < least) {
            front.push_back(k);
            least = points[k].error;
        }
    }
    return front;
}

std::size_t CheapestWithin(std::span<const TimedError> points, double tolerance) {
    assert(!points.empty() && tolerance >= 0);
    const std::vector<std::size_t> front = ParetoFront(points);
    assert(!front.empty());
    const double bound = points[front.back()].error * (1 + tolerance);
    return *std::find_if(front.begin(), front.end(),
                         [&](std::size_t k) { return points[k].error <= bound; });
}

}  // namespace plumb
