// A hall of Sponza's kind: two storeys of arches on columns around an open court, with curtains,
// vases, balusters and floor tiles; about 250 000 triangles at human scale. Metres, +z up.
#pragma once

#include "core/scene.h"

namespace plumb {

/// `detail` scales the number of segments along every curve: 1 gives about 250 000 triangles,
/// 0.5 a quarter of that. [0.1, 4]
Scene Atrium(double detail = 1);

}  // namespace plumb
