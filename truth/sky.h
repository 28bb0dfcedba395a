// Where the sky is, and what becomes of light that cannot be followed.
#pragma once

#include <cstdint>

namespace plumb {

/// Which directions lead to the sky if nothing is in the way.
enum class Sky {
    kAllAround,  ///< All of them.
    kAbove,      ///< Those above the horizontal (z > 0). The rest should meet the ground.
    kNowhere,    ///< None: a closed room.
};

/// Rays that should not be, counted by reason. Their light belongs to no one: what they carry
/// is missing from every sum, so a furnace shows them.
struct Lost {
    std::int64_t not_a_number = 0;
    std::int64_t from_behind = 0;  ///< Met the back of a surface that has only a front.
    std::int64_t not_sky = 0;      ///< Left the scene where there is no sky.

    /// Not lost: got behind a surface where two meet in a valley, by the rounding of where rays
    /// start, was noticed by one of the above, and found its way from a hair further inside.
    std::int64_t rescued = 0;

    std::int64_t All() const { return not_a_number + from_behind + not_sky; }
    Lost& operator+=(const Lost& other) {
        not_a_number += other.not_a_number;
        from_behind += other.from_behind;
        not_sky += other.not_sky;
        rescued += other.rescued;
        return *this;
    }
};

inline bool LeadsToSky(Sky sky, double w_z) {
    return sky == Sky::kAllAround || (sky == Sky::kAbove && w_z > 0);
}

}  // namespace plumb
