// Scenes that strain a renderer: thin, long or very many shapes. Metres, +z up.
#pragma once

#include <cstdint>

#include "core/scene.h"

namespace plumb {

/// Upright bars 4 mm thick and 60 mm apart, 1 m high, over a plane: thinner than a pixel.
Scene Fence(int bars = 120);

/// A plate cut into slivers as long as it and 1 / count as wide, wavy so that each has a normal
/// of its own.
Scene Slivers(int count = 1'000'000);

/// Small triangles standing on a plane at random, 3 to 6 cm large.
Scene Forest(int triangles = 1'000'000, std::uint64_t seed = 1);

}  // namespace plumb
