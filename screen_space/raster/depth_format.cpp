#include "screen_space/raster/depth_format.h"

#include <array>
#include <bit>
#include <cmath>

#include "core/error.h"

namespace plumb {
namespace {

constexpr double kMost16 = 65535, kMost24 = 16777215;

double MostOf(DepthFormat format) {
    return format == DepthFormat::kD16 ? kMost16 : kMost24;
}

bool IsWhole(DepthFormat format) {
    return format == DepthFormat::kD16 || format == DepthFormat::kD24;
}

template <class Real>
Real Reconstruct(DepthFormat format, const DepthRange& range, Real d) {
    const bool reversed = format == DepthFormat::kD32FReversed;
    const double z_n = -range.near_m, z_f = -range.far_m;
    std::array<double, 3> c;  // [McGuire12 eq. 2]
    if (std::isinf(range.far_m)) {
        c = reversed ? std::array{z_n, 1.0, 0.0} : std::array{z_n, -1.0, 1.0};
    } else {
        c = reversed ? std::array{z_n * z_f, z_f - z_n, z_n}
                     : std::array{z_n * z_f, z_n - z_f, z_f};
    }
    return Real(c[0]) / (d * Real(c[1]) + Real(c[2]));
}

}  // namespace

std::string_view NameOf(DepthFormat format) {
    switch (format) {
        case DepthFormat::kD16:
            return "D16";
        case DepthFormat::kD24:
            return "D24";
        case DepthFormat::kD32F:
            return "D32F";
        case DepthFormat::kD32FReversed:
            return "D32F reversed";
    }
    return "";
}

void Validate(const DepthRange& range) {
    if (!(range.near_m > 0 && std::isfinite(range.near_m))) {
        throw Error(MustBe("near_m", range.near_m, "> 0 and finite"));
    }
    if (!(range.far_m > range.near_m)) {
        throw Error(MustBe("far_m", range.far_m, "> near_m"));
    }
}

DepthCurve::DepthCurve(const DepthRange& range) {
    const double n = range.near_m, f = range.far_m;
    a = std::isinf(f) ? n : n / (1 - n / f);
    b = std::isinf(f) ? 0 : -n / (f - n);
}

float KeyOf(DepthFormat format, float e) {
    switch (format) {
        case DepthFormat::kD16:
            return std::nearbyint(e * float(kMost16));
        case DepthFormat::kD24:
            return std::nearbyint(e * float(kMost24));
        case DepthFormat::kD32F:
            return e - 1;
        case DepthFormat::kD32FReversed:
            break;
    }
    return e;
}

std::uint32_t BitsOfKey(DepthFormat format, float key) {
    if (IsWhole(format)) return std::uint32_t(MostOf(format)) - std::uint32_t(key);
    return std::bit_cast<std::uint32_t>(format == DepthFormat::kD32F ? 0.f - key : key);
}

std::uint32_t EncodeDepth(DepthFormat format, double e) {
    if (IsWhole(format)) return std::uint32_t(std::nearbyint((1 - e) * MostOf(format)));
    return std::bit_cast<std::uint32_t>(float(format == DepthFormat::kD32F ? 1 - e : e));
}

double DecodeDepth(DepthFormat format, std::uint32_t bits) {
    return IsWhole(format) ? bits / MostOf(format) : double(std::bit_cast<float>(bits));
}

float ReconstructZ(DepthFormat format, const DepthRange& range, float d) {
    return Reconstruct(format, range, d);
}

double ReconstructZ(DepthFormat format, const DepthRange& range, double d) {
    return Reconstruct(format, range, d);
}

}  // namespace plumb
