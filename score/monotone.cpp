#include "score/monotone.h"

#include <algorithm>
#include <cassert>

namespace plumb {
namespace {

struct Group {
    double first_x = 0, last_x = 0, sum = 0;
    double count = 0;
    double Mean() const { return sum / count; }
};

}  // namespace

double MonotoneMap::operator()(double x) const {
    assert(!levels.empty());
    const auto next =
        std::lower_bound(levels.begin(), levels.end(), x,
                         [](const Level& level, double value) { return level.last_x < value; });
    if (next == levels.end()) return levels.back().y;
    if (x >= next->first_x || next == levels.begin()) return next->y;
    const Level& back = *(next - 1);
    const double share = (x - back.last_x) / (next->first_x - back.last_x);
    return back.y + share * (next->y - back.y);
}

MonotoneMap FitMonotone(std::vector<MonotoneSample> samples) {
    std::sort(samples.begin(), samples.end(),
              [](const MonotoneSample& a, const MonotoneSample& b) {
                  return a.x != b.x ? a.x < b.x : a.y < b.y;
              });
    return FitSorted(samples);
}

MonotoneMap FitSorted(std::span<const MonotoneSample> samples) {
    std::vector<Group> groups;
    for (std::size_t k = 0; k < samples.size();) {
        Group group{.first_x = samples[k].x, .last_x = samples[k].x};
        for (; k < samples.size() && samples[k].x == group.last_x; ++k) {
            group.sum += samples[k].y;
            ++group.count;
        }
        while (!groups.empty() && groups.back().Mean() >= group.Mean()) {
            const Group& before = groups.back();
            group = {before.first_x, group.last_x, before.sum + group.sum,
                     before.count + group.count};
            groups.pop_back();
        }
        groups.push_back(group);
    }
    MonotoneMap map;
    for (const Group& group : groups) {
        map.levels.push_back({group.first_x, group.last_x, group.Mean()});
    }
    return map;
}

}  // namespace plumb
