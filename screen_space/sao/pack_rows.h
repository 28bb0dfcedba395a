// Packing by rows: what a texture of 8 bits keeps of many pixels.
#pragma once

namespace plumb {

/// key[i] = min(z[i] / z_min, 1).
void KeysOfRow(const float* z_m, double z_min_m, int n, float* key);

/// A and key packed to RGB8 and unpacked, as pack_ao_z.h does.
void KeepRgb8OfRow(int n, float* A, float* key);

/// A alone; and 1 where z is the sky's, because a packed key does not tell the sky from what is far,
/// so that a filter mixes them.
void FinishRow(const float* z_m, bool keep_8_bits, int n, float* A);

}  // namespace plumb
