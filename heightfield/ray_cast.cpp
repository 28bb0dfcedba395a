#include "heightfield/ray_cast.h"

#include <cassert>
#include <cmath>

namespace plumb {

double FarDistanceM(const HeightField& field) {
    return 1e6 * (field.HighestM() - field.LowestM()) +
           100 * (field.WidthM() + field.HeightM());
}

std::int64_t CastFromFacet(const WalkGrid& grid, std::int64_t facet, const Vec3& origin_m,
                           const Vec3& direction, double max_distance_m) {
    const double level = std::hypot(direction.x(), direction.y());
    // Straight up there is nothing above a height field; straight down no facet is left.
    if (level == 0) return kSky;
    const WalkGrid::Start start{facet,        origin_m.x(),          origin_m.y(),
                                origin_m.z(), direction.x() / level, direction.y() / level};
    std::int64_t hit = kSky;
    const WalkGrid::End end =
        grid.Walk(start, direction.z() / level, max_distance_m, 0,
                  [&hit](std::int64_t crossed, double t_m, double rise_m, double slope) {
                      if (rise_m < slope * t_m) return true;
                      hit = crossed;
                      return false;
                  });
    return end == WalkGrid::End::kTooFar ? kLost : hit;
}

}  // namespace plumb
