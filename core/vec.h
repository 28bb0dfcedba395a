// Vectors, by Eigen. Every room may include this; nothing here is ours but the names.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace plumb {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;

}  // namespace plumb
