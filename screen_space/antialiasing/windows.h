// Windows of an enlarged picture: the m x m samples that one pixel of the small one stands for.
//
//       sample (X, Y) belongs to pixel (floor(X / m), floor(Y / m))
//
// Symbols  m, n = m^2 samples a pixel; (x, y) pixels of the picture shown, (X, Y) samples.
#pragma once

#include <array>
#include <string>

#include "core/error.h"
#include "core/image.h"

namespace plumb {

inline constexpr int kMaxEnlargement = 8;  ///< m
inline constexpr int kMaxSamples = kMaxEnlargement * kMaxEnlargement;

/// Throws Error unless m is in [1, 8].
inline void CheckEnlargement(int m) {
    if (m < 1 || m > kMaxEnlargement) {
        throw Error(MustBe("enlargement m", m, "in [1, 8]"));
    }
}

/// Throws Error unless m is in [1, 8] and divides both sides of the enlarged picture.
inline void CheckWindows(int m, int width, int height, const std::string& what) {
    CheckEnlargement(m);
    if (width % m != 0 || height % m != 0) {
        throw Error(what + " = " + std::to_string(width) + " x " + std::to_string(height) +
                    ", must be a multiple of m = " + std::to_string(m));
    }
}

/// `out` gets the n samples of pixel (x, y), row by row.
template <class T>
void ReadWindow(const Image<T>& samples, int m, int x, int y, std::array<T, kMaxSamples>& out) {
    for (int j = 0; j < m; ++j) {
        const T* row = &samples(x * m, y * m + j);
        for (int i = 0; i < m; ++i) out[std::size_t(j * m + i)] = row[i];
    }
}

}  // namespace plumb
