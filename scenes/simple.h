// Scenes of a few shapes, whose light is known or easily judged. Metres, +z up.
#pragma once

#include "core/scene.h"

namespace plumb {

/// A cube of 1 m on a plane of 20 m.
Scene BoxOnPlane();

/// A ball of radius 0.8 m, its centre 1 m over a plane of 20 m: at the distance x from the point
/// below it, V = 1 - R^2 h / (x^2 + h^2)^(3/2).
Scene BallOverPlane();

/// Goral's room: a cube of 1 m open to the front, red left and green right wall, two blocks.
Scene CornellBox();

/// Floor and wall at a right angle, 40 m each way: V = 1/2 near the corner.
Scene Wedge();

/// A trench 1 m wide, 1 m deep and 40 m long in level ground.
Scene TrenchScene();

}  // namespace plumb
