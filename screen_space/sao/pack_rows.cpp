#include "screen_space/sao/pack_rows.h"

#include "screen_space/gbuffer.h"
#include "screen_space/sao/pack_ao_z.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/sao/pack_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {
namespace {

// Loops for the compiler to vectorize, once for each kind of machine.

void Keys(const float* HWY_RESTRICT z, double z_min_m, int n, float* HWY_RESTRICT key) {
    const float per_z = float(1 / z_min_m);
    for (int i = 0; i < n; ++i) {
        const float k = z[i] * per_z;
        key[i] = k < 1 ? k : 1;
    }
}

void KeepRgb8(int n, float* HWY_RESTRICT A, float* HWY_RESTRICT key) {
    for (int i = 0; i < n; ++i) {
        A[i] = float(ToByte(A[i])) / 255;
        const int high = HighOfKey(key[i]);
        key[i] = KeyOfBytes<float>(ToByte(float(high) / 256), ToByte(LowOfKey(key[i], high)));
    }
}

void Finish(const float* HWY_RESTRICT z, bool keep_8_bits, int n, float* HWY_RESTRICT A) {
    if (keep_8_bits) {
        for (int i = 0; i < n; ++i) A[i] = float(ToByte(A[i])) / 255;
    }
    for (int i = 0; i < n; ++i) A[i] = z[i] == GBuffer::kSkyZ ? 1.0f : A[i];
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Keys);
HWY_EXPORT(KeepRgb8);
HWY_EXPORT(Finish);

}  // namespace

void KeysOfRow(const float* z_m, double z_min_m, int n, float* key) {
    HWY_DYNAMIC_DISPATCH(Keys)(z_m, z_min_m, n, key);
}

void KeepRgb8OfRow(int n, float* A, float* key) {
    HWY_DYNAMIC_DISPATCH(KeepRgb8)(n, A, key);
}

void FinishRow(const float* z_m, bool keep_8_bits, int n, float* A) {
    HWY_DYNAMIC_DISPATCH(Finish)(z_m, keep_8_bits, n, A);
}

}  // namespace plumb

#endif
