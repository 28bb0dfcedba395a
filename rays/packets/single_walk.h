// One ray through the tree, by plain scalar code.
//
//       at a node [begin, end] is the part of the ray inside the cell, t -+ w its plane
//       near child   [begin, min(end, t + w)]     if that is not empty
//       far child    [max(begin, t - w), end]     if that is not empty; kept for later if both
//
// Iterative, with a stack of the cells put off. Of the hits the nearest counts, of equally near
// ones that of the least triangle.
//
// Source   [Wald01 section 4.1], after [Sung92] K. Sung, P. Shirley, Ray Tracing with the BSP
//          Tree, Graphics Gems III. The margin w: walk_ray.h.
#pragma once

#include "rays/packets/mailboxes.h"
#include "rays/packets/packet_scene.h"
#include "rays/packets/walk_ray.h"

namespace plumb {

Hit ClosestOfSingle(const PacketScene& scene, const WalkRay& ray, Mailboxes& mailboxes,
                    WalkCounts& counts);

bool AnyOfSingle(const PacketScene& scene, const WalkRay& ray, Mailboxes& mailboxes,
                 WalkCounts& counts);

}  // namespace plumb
