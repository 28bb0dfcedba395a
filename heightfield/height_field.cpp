#include "heightfield/height_field.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/error.h"

namespace plumb {
namespace {

constexpr std::int64_t kMaxFacets = std::int64_t(1) << 30;

std::string Texel(int i, int j) {
    return "texel (" + std::to_string(i) + ", " + std::to_string(j) + ")";
}

void RequireSpacing(const char* name, double value_m) {
    if (!(std::isfinite(value_m) && value_m > 0)) {
        throw Error(MustBe(std::string("HeightField: ") + name, value_m, "finite and > 0"));
    }
}

// Applies (i, j) -> heights(Source(i, j)) to a field of the given new size.
template <class Source>
Image<double> Rearranged(const Image<double>& heights, int width, int height, Source source) {
    Image<double> out(width, height);
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const auto [si, sj] = source(i, j);
            out(i, j) = heights(si, sj);
        }
    }
    return out;
}

Diagonal Flipped(Diagonal diagonal) {
    return diagonal == Diagonal::kRising ? Diagonal::kFalling : Diagonal::kRising;
}

}  // namespace

HeightField::HeightField(Image<double> heights_m, double spacing_x_m, double spacing_y_m,
                         Boundary boundary, Diagonal diagonal)
    : heights_m_(std::move(heights_m)),
      spacing_x_m_(spacing_x_m),
      spacing_y_m_(spacing_y_m),
      boundary_(boundary),
      diagonal_(diagonal) {
    if (Width() < 2 || Height() < 2) {
        throw Error("HeightField: " + std::to_string(Width()) + " x " +
                    std::to_string(Height()) + " texels, must be at least 2 x 2");
    }
    if (Facets() > kMaxFacets) {
        throw Error("HeightField: " + std::to_string(Width()) + " x " +
                    std::to_string(Height()) + " texels have " + std::to_string(Facets()) +
                    " facets, must be at most " + std::to_string(kMaxFacets));
    }
    RequireSpacing("spacing along x in metres", spacing_x_m);
    RequireSpacing("spacing along y in metres", spacing_y_m);
    for (int j = 0; j < Height(); ++j) {
        for (int i = 0; i < Width(); ++i) {
            if (!std::isfinite(At(i, j))) {
                throw Error(
                    MustBe("HeightField: height at " + Texel(i, j), At(i, j), "finite"));
            }
        }
    }
    const auto [low, high] =
        std::minmax_element(heights_m_.Pixels().begin(), heights_m_.Pixels().end());
    lowest_m_ = *low;
    highest_m_ = *high;
}

HeightField WithAmplitude(const HeightField& field, double amplitude_m) {
    if (!(std::isfinite(amplitude_m) && amplitude_m >= 0)) {
        throw Error(MustBe("amplitude in metres", amplitude_m, "finite and >= 0"));
    }
    const double low = field.LowestM(), range = field.HighestM() - low;
    if (range == 0) {
        throw Error("the height field is flat: no amplitude can be given to it");
    }
    // Far above the relief its digits would be rounded away: then the lowest moves to 0.
    constexpr double kMostOverAmplitude = 1e6;
    const bool is_far = amplitude_m > 0 && std::abs(low) > kMostOverAmplitude * amplitude_m;
    const double base = is_far ? 0 : low;
    Image<double> heights = field.HeightsM();
    for (double& z : heights.Pixels()) z = base + (z - low) / range * amplitude_m;
    return HeightField(std::move(heights), field.SpacingXM(), field.SpacingYM(),
                       field.GetBoundary(), field.GetDiagonal());
}

HeightField MirroredX(const HeightField& field) {
    const int w = field.Width(), h = field.Height();
    return HeightField(Rearranged(field.HeightsM(), w, h,
                                  [w](int i, int j) { return std::pair(w - 1 - i, j); }),
                       field.SpacingXM(), field.SpacingYM(), field.GetBoundary(),
                       Flipped(field.GetDiagonal()));
}

HeightField QuarterTurned(const HeightField& field) {
    // (x, y) -> (-y, x): what stood in column i, row j comes to column w' - 1 - j, row i.
    const int w = field.Height(), h = field.Width();
    return HeightField(Rearranged(field.HeightsM(), w, h,
                                  [w](int i, int j) { return std::pair(j, w - 1 - i); }),
                       field.SpacingYM(), field.SpacingXM(), field.GetBoundary(),
                       Flipped(field.GetDiagonal()));
}

HeightField Shifted(const HeightField& field, int di, int dj) {
    if (field.GetBoundary() != Boundary::kWrap) {
        throw Error("Shifted: the field must wrap, or its tile has an inside and an outside");
    }
    const int w = field.Width(), h = field.Height();
    const auto wrap = [](int i, int n) { return ((i % n) + n) % n; };
    return HeightField(
        Rearranged(field.HeightsM(), w, h,
                   [&](int i, int j) { return std::pair(wrap(i - di, w), wrap(j - dj, h)); }),
        field.SpacingXM(), field.SpacingYM(), field.GetBoundary(), field.GetDiagonal());
}

}  // namespace plumb
