// What a depth buffer stores, and the camera's z that comes back out of it.
//
//       e(t) = a / t + b        1 at the near plane, 0 at the far plane
//       a = n f / (f - n),  b = -n / (f - n)        or  a = n,  b = 0  if f is infinite
//       stored: d = 1 - e, rounded;  reversed: e, rounded
//
//       z(d) = c_0 / (d c_1 + c_2)                                          [McGuire12 eq. 2]
//       c = [z_n z_f, z_n - z_f, z_f]               or  c = [z_n, -1, 1]
//       reversed (ours): d -> 1 - d, so  c = [z_n z_f, z_f - z_n, z_n]  or  c = [z_n, 1, 0]
//
// Everything between the planes is computed from e, which keeps its relative precision far
// away, and rounded once when it is stored.
//
// Symbols  t = -z distance from the camera's plane (m); n, f of the near and the far plane;
//          z_n = -n, z_f = -f; e, d unitless.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

namespace plumb {

enum class DepthFormat {
    kD16,           ///< 16 bit whole numbers, d (2^16 - 1) rounded.
    kD24,           ///< 24 bit whole numbers, d (2^24 - 1) rounded.
    kD32F,          ///< float of d.
    kD32FReversed,  ///< float of e = 1 - d: as precise far away as near.
};

std::string_view NameOf(DepthFormat format);

struct DepthRange {
    double near_m = 0.01;                                    ///< n. > 0, finite
    double far_m = std::numeric_limits<double>::infinity();  ///< f. > n; may be infinite

    friend bool operator==(const DepthRange&, const DepthRange&) = default;
};

/// Throws Error, naming field, value and rule.
void Validate(const DepthRange& range);

/// a and b of e(t).
struct DepthCurve {
    double a = 1, b = 0;

    explicit DepthCurve(const DepthRange& range);
    double E(double t_m) const { return a / t_m + b; }
    double DistanceM(double e) const { return a / (e - b); }
};

/// What a depth test compares: greater is nearer. The value of the far plane is KeyOf(.., 0);
/// only what is nearer is ever drawn, so that nothing at or beyond the far plane is.
float KeyOf(DepthFormat format, float e);

/// The bits that the buffer holds: the whole number, or the bits of the float.
std::uint32_t BitsOfKey(DepthFormat format, float key);

/// Of e in [0, 1]; rounded once, unlike the rasterizer, which knows e only in float.
std::uint32_t EncodeDepth(DepthFormat format, double e);

/// d as stored, in [0, 1] (e if the format is reversed).
double DecodeDepth(DepthFormat format, std::uint32_t bits);

/// z(d), < 0, as a shader computes it in float, or in double. -infinity where the buffer is
/// empty and the far plane infinite.
float ReconstructZ(DepthFormat format, const DepthRange& range, float d);
double ReconstructZ(DepthFormat format, const DepthRange& range, double d);

}  // namespace plumb
