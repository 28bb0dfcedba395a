#include "heightfield/ray_cast.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace plumb {

namespace {

// Rise of the point in which a line of sight enters a facet's plane; where it skims the plane,
// of the edge that it leaves by.
double HeightWhereMet(const WalkGrid::Crossing& crossing, double slope) {
    const double closing = slope - crossing.grade;
    if (closing == 0) return crossing.rise_m;
    const double t_m = (crossing.rise_m - crossing.grade * crossing.t_m) / closing;
    return slope * std::clamp(t_m, 0.0, crossing.t_m);
}

}  // namespace

double FarDistanceM(const HeightField& field) {
    return 1e6 * (field.HighestM() - field.LowestM()) +
           100 * (field.WidthM() + field.HeightM());
}

std::int64_t CastFromFacet(const WalkGrid& grid, std::int64_t facet, const Vec3& origin_m,
                           const Vec3& direction, double max_distance_m, double* height_m) {
    const double level = std::hypot(direction.x(), direction.y());
    // Straight up there is nothing above a height field; straight down no facet is left.
    if (level == 0) return kSky;
    const WalkGrid::Start start{facet,        origin_m.x(),          origin_m.y(),
                                origin_m.z(), direction.x() / level, direction.y() / level};
    std::int64_t hit = kSky;
    const WalkGrid::End end = grid.Walk(start, direction.z() / level, max_distance_m, 0,
                                        [&](const WalkGrid::Crossing& crossing, double slope) {
                                            if (crossing.rise_m < slope * crossing.t_m)
                                                return true;
                                            hit = crossing.facet;
                                            if (height_m)
                                                *height_m =
                                                    start.z_m + HeightWhereMet(crossing, slope);
                                            return false;
                                        });
    return end == WalkGrid::End::kTooFar ? kLost : hit;
}

}  // namespace plumb
