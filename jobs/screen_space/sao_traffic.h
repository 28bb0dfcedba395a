// The bytes that the passes of SAO touch, counted texel by texel on a picture.
//
//       z pyramid   reads z and of each level the sources of the next; writes every level
//       sample      reads the texels that some tap or normal meets, each once; writes A
//       quads       reads A and z, writes A
//       pack, key   reads z (and A, to keep it in bytes), writes the key (and A)
//       blur        reads A and the key as far as its taps reach, z, and normals if it weighs by
//                   them; writes A
//
// A datum counts once a pass, as if the cache never lost one: what a memory of any size must move at
// least. The taps of the sampling pass are those of tap_lookup.h, so that SAO is charged only the
// levels that its discs reach, and AlchemyAO, which has no pyramid, the copy of z alone.
//
// Symbols  4 bytes a float; 12 a normal.
// Cost     one lookup a tap, on all cores: some seconds at 2560 x 1600.
#pragma once

#include <string>
#include <vector>

#include "screen_space/gbuffer.h"
#include "screen_space/sao/sao_passes.h"

namespace plumb {

/// What a pass reads and writes, each datum once.
struct PassBytes {
    std::string name;
    double read = 0, written = 0;
};

/// In the order and with the names of the passes as they are timed.
std::vector<PassBytes> SaoTraffic(const GBuffer& gbuffer, const SaoOptions& options);

double TotalBytes(const std::vector<PassBytes>& traffic);

}  // namespace plumb
