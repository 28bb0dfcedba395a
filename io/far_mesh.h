// Meshes far from the origin of their coordinates, brought near it before they become float.
//
// A box at UTM coordinates (500000, 5400000) lies where floats are half a metre apart, and rays
// start a part of that distance off surfaces. So what lies further away than 16 times its own
// extent is moved by an origin, in double:
//
//       v' = v - o,     o = the middle of the box of all v, rounded to steps of the extent
//
// OBJ is text, which keeps what it was written with: its vertices are moved before a reader that
// works in float gets them. Other formats are moved after their reader; what that has rounded is lost.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/vec.h"

namespace plumb {

/// o of the box from `low` to `high`; zero if that is near enough.
Vec3 OriginFor(const Vec3& low, const Vec3& high);

struct NearObj {
    std::string text;  ///< The file with `origin` taken from its vertices.
    Vec3 origin;       ///< In the file's own unit and axes.
};

/// Nothing if the vertices are near, or not as OBJ has them; that is left to its reader.
std::optional<NearObj> BringNear(const std::string& obj);

}  // namespace plumb
