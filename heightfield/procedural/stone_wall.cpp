#include "heightfield/procedural/stone_wall.h"

#include <algorithm>
#include <cmath>

#include "core/conventions.h"
#include "heightfield/procedural/noise.h"

namespace plumb {
namespace {

using namespace procedural;

enum Stream : std::uint64_t {
    kCourseBorder = 1,
    kCourseCount,
    kCourseShift,
    kJoint,
    kStone,
    kWarpU,
    kWarpV,
    kOutline,
    kMortar,
    kFace,
    kGrain,
    kFacet,
};

// The outline of one stone, in course heights, and where the point lies in it.
struct Stone {
    std::uint64_t hash = 0;  // Its identity.
    double x = 0, y = 0;     // From the middle of the stone to the point.
    double half_x = 0, half_y = 0;
};

// Lower border of course k, k any integer: the jitter has period `courses`.
double CourseBorder(const StoneWall& wall, std::int64_t k) {
    const double r = Uniform(wall.seed, kCourseBorder, Wrap(k, wall.courses), 0) - 0.5;
    return double(k) + 0.5 * wall.irregularity * r;
}

Stone FindStone(const StoneWall& wall, double u, double v) {
    const double y = v * wall.courses;
    auto k = std::int64_t(std::floor(y));
    if (y < CourseBorder(wall, k)) {
        --k;
    } else if (y >= CourseBorder(wall, k + 1)) {
        ++k;
    }
    const std::int64_t course = Wrap(k, wall.courses);
    const double one_more_or_less = Uniform(wall.seed, kCourseCount, course, 0);
    const int n = wall.stones_per_course +
                  (wall.irregularity > 0 ? int(std::floor(3 * one_more_or_less)) - 1 : 0);
    const double shift = 0.5 * double(course % 2) +
                         0.3 * wall.irregularity * Uniform(wall.seed, kCourseShift, course, 0);
    auto joint = [&](std::int64_t i) {
        const double r = Uniform(wall.seed, kJoint, Wrap(i, n), course) - 0.5;
        return double(i) + 0.6 * wall.irregularity * r;
    };
    const double x = u * n + shift;
    auto i = std::int64_t(std::floor(x));
    if (x < joint(i)) {
        --i;
    } else if (x >= joint(i + 1)) {
        ++i;
    }

    const double heights_per_unit = double(wall.courses) / n;
    const double left = joint(i) * heights_per_unit, right = joint(i + 1) * heights_per_unit;
    double low = CourseBorder(wall, k), high = CourseBorder(wall, k + 1);
    std::uint64_t hash = Hash(wall.seed, kStone, Wrap(i, n), course);
    // Only a course high enough for two.
    if (high - low > 0.95 && Uniform(Mix(hash + 1)) < 0.5 * wall.irregularity) {
        const double split = low + (high - low) * (0.42 + 0.16 * Uniform(Mix(hash + 2)));
        if (y < split) {
            high = split;
        } else {
            low = split;
            hash = Mix(hash + 3);
        }
    }
    return {hash, x * heights_per_unit - (left + right) / 2, y - (low + high) / 2,
            (right - left) / 2, (high - low) / 2};
}

// How far the point lies inside the rounded box of the stone, negative outside.
double DepthInside(const Stone& stone, double joint_width) {
    const double a = std::max(stone.half_x - joint_width / 2, 0.02);
    const double b = std::max(stone.half_y - joint_width / 2, 0.02);
    const double radius = std::min(a, b) * (0.25 + 0.5 * Uniform(Mix(stone.hash + 4)));
    const double qx = std::abs(stone.x) - a + radius, qy = std::abs(stone.y) - b + radius;
    const double outside = std::hypot(std::max(qx, 0.0), std::max(qy, 0.0));
    return radius - outside - std::min(std::max(qx, qy), 0.0);
}

double FaceHeight(const StoneWall& wall, const Stone& stone, double u, double v) {
    auto r = [&](std::uint64_t n) { return Uniform(Mix(stone.hash + n)); };
    const double qx = stone.x / stone.half_x, qy = stone.y / stone.half_y;
    double z = 0.82 + wall.unevenness * (0.3 * (r(10) - 0.5) + 0.16 * (r(11) - 0.5) * qx +
                                         0.16 * (r(12) - 0.5) * qy);
    // A face is what is left when a few planes have split pieces off it.
    double split_off = 0;
    for (std::uint64_t f = 0; f < 5; ++f) {
        const double angle = 2 * kPi * r(20 + 3 * f);
        const double beyond = qx * std::cos(angle) + qy * std::sin(angle) - 0.5 * r(21 + 3 * f);
        split_off = std::max(split_off, beyond * (0.1 + 0.35 * r(22 + 3 * f)));
    }
    const double swell =
        Fbm(stone.hash, kFace, u, v, {.n_x = 2 * wall.courses, .n_y = 2 * wall.courses});
    const double scars =
        RidgedFbm(stone.hash, kFacet, u, v,
                  {.n_x = 3 * wall.courses, .n_y = 4 * wall.courses, .count = 4, .gain = 0.55});
    const double grain =
        Fbm(wall.seed, kGrain, u, v,
            {.n_x = 12 * wall.courses, .n_y = 12 * wall.courses, .count = 3, .gain = 0.7});
    z += wall.relief * (0.45 * swell - 0.7 * split_off + 0.13 * (scars - 0.5) + 0.16 * grain);
    return z;
}

}  // namespace

void Validate(const StoneWall& wall) {
    RequireInRange("StoneWall::courses", wall.courses, 2, 64, "in [2, 64]");
    RequireInRange("StoneWall::stones_per_course", wall.stones_per_course, 2, 64, "in [2, 64]");
    RequireInRange("StoneWall::irregularity", wall.irregularity, 0, 1, "in [0, 1]");
    RequireInRange("StoneWall::mortar", wall.mortar, 0.02, 0.4, "in [0.02, 0.4]");
    RequireInRange("StoneWall::edge", wall.edge, 0.01, 0.3, "in [0.01, 0.3]");
    RequireInRange("StoneWall::unevenness", wall.unevenness, 0, 1, "in [0, 1]");
    RequireInRange("StoneWall::relief", wall.relief, 0, 1, "in [0, 1]");
}

double StoneWallHeight(const StoneWall& wall, double u, double v) {
    u = Fraction(u), v = Fraction(v);
    const Octaves bends{.n_x = wall.stones_per_course, .n_y = wall.courses, .count = 3};
    const double warp = 0.5 * wall.irregularity / wall.courses;
    const double warped_u = u + warp * Fbm(wall.seed, kWarpU, u, v, bends);
    const double warped_v = v + warp * Fbm(wall.seed, kWarpV, u, v, bends);
    const Stone stone = FindStone(wall, warped_u, warped_v);

    const double fray =
        0.5 * wall.mortar * wall.irregularity *
        Fbm(wall.seed, kOutline, u, v,
            {.n_x = 4 * wall.courses, .n_y = 4 * wall.courses, .count = 4, .gain = 0.6});
    // The face jumps on the border to the next stone; there p is 0, whatever the noise says, so
    // that z does not.
    const double to_next =
        std::min(stone.half_x - std::abs(stone.x), stone.half_y - std::abs(stone.y));
    const double p =
        SmoothStep(0, wall.edge, std::min(DepthInside(stone, wall.mortar) + fray, to_next));
    const double mortar =
        0.12 + 0.2 * Fbm(wall.seed, kMortar, u, v,
                         {.n_x = 5 * wall.courses, .n_y = 5 * wall.courses, .gain = 0.75});
    return p > 0 ? mortar + p * (FaceHeight(wall, stone, u, v) - mortar) : mortar;
}

HeightField MakeStoneWall(const StoneWall& wall, const Tile& tile) {
    Validate(wall);
    return SampleTile(tile, [&](double u, double v) { return StoneWallHeight(wall, u, v); });
}

}  // namespace plumb
