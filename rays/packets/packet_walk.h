// A packet of rays through the tree, several at once in the lanes of SIMD registers.
//
// At each node the steps of single_walk.h are taken for all rays of the packet; a child is
// visited if any ray needs it. The others come along with an empty part [begin, end] and are
// neither tested nor changed: each ray is tested against the triangles that it would meet
// alone, in the same order, by the same operations on floats. So a packet gives the bits of its
// single rays, on any number of lanes.
//
// Source   [Wald01 section 3.3 and 4.1].
// Beware   No multiplication is fused with an addition, on machines that could too.
#pragma once

#include "rays/packets/mailboxes.h"
#include "rays/packets/packet.h"
#include "rays/packets/packet_scene.h"

namespace plumb {

/// The most lanes of this machine: 4, 8 or 16; 1 where rays can only travel one by one.
int MostLanes();

/// ReadyToWalk of every place. Bit i of the answer: the ray in place i enters the box.
std::uint64_t MakeReady(const BspBox& box, Packet& packet);

/// The rays whose [begin, end] is not empty, all of the kind `packet.kind`. Of `lanes` 4, 8 or
/// 16, or the most of them that this machine has, which must be 4 at least.
void ClosestOfPacket(const PacketScene& scene, int lanes, Packet& packet, Mailboxes& mailboxes,
                     WalkCounts& counts);
void AnyOfPacket(const PacketScene& scene, int lanes, Packet& packet, Mailboxes& mailboxes,
                 WalkCounts& counts);

}  // namespace plumb
