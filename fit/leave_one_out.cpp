#include "fit/leave_one_out.h"

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {

std::vector<HeldOut> LeaveOneMapOut(std::span<const BounceHistogram> maps,
                                    std::span<const FittingMethod> methods, Monitor& monitor) {
    if (maps.size() < 2)
        throw Error(MustBe("maps to hold one out of", double(maps.size()), ">= 2"));
    std::vector<HeldOut> held_out(methods.size());
    for (HeldOut& row : held_out) {
        row.formulas.resize(maps.size());
        row.scores.maps.resize(maps.size());
    }
    ParallelFor(
        std::int64_t(methods.size() * maps.size()), 1,
        [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                const std::size_t c = i / maps.size(), m = i % maps.size();
                std::vector<BounceHistogram> others(maps.begin(), maps.end());
                others.erase(others.begin() + std::ptrdiff_t(m));
                HeldOut& row = held_out[c];
                row.formulas[m] = methods[c].learn(others);
                row.scores.maps[m] = ScoreOf(row.formulas[m], maps[m]);
            }
        },
        monitor, "leave one map out");
    for (std::size_t c = 0; c < methods.size(); ++c) {
        held_out[c].scores.formula = methods[c].name;
        held_out[c].scores.pooled = Pooled(held_out[c].scores.maps);
    }
    return held_out;
}

}  // namespace plumb
