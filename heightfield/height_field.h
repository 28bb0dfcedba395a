// A height field: heights on a grid, and the one surface that they mean.
//
// Heights stand at texel centres. The surface is the triangulated grid: between four
// neighbouring centres lies a cell, cut in two by one diagonal, the same for the whole field.
// These triangles, the facets, are exact: what is cast against here, what light lives on, and
// the very triangles that truth/ gets.
//
//        (i,j+1) +---------+ (i+1,j+1)      Diagonal::kRising: (i,j) to (i+1,j+1)
//                | upper ./|                facet 2c     lower: (i,j) (i+1,j) (i+1,j+1)
//                |    ./   |                facet 2c + 1 upper: (i,j) (i+1,j+1) (i,j+1)
//                | ./ lower|                c = j * CellsX() + i
//          (i,j) +---------+ (i+1,j)
//
// Symbols  i, j column and row of a texel or of the cell to the right of and above it; s_x, s_y
//          spacing (m); lengths in metres.
// Beware   Along x a field of n texels has n cells if it wraps (the last joins the first) and
//          n - 1 if it is open or mirrored. A mirror lies on the first and last row of texel
//          centres: the field continues with period 2 (n - 1) texels.
//          Diagonal::kFalling is stored as the mirror image in y of a rising field would be:
//          lower (i,j) (i+1,j) (i,j+1), upper (i+1,j) (i+1,j+1) (i,j+1).
#pragma once

#include <cstdint>

#include "core/image.h"
#include "core/vec.h"

namespace plumb {

/// What lies beyond the border: the field again, its mirror image, or nothing (open sky).
enum class Boundary { kWrap, kMirror, kOpen };

/// Which corners of a cell its diagonal joins; see the figure above.
enum class Diagonal { kRising, kFalling };

class HeightField {
  public:
    /// Throws Error, naming the value and the rule, unless: at least 2 x 2 texels (an open or
    /// mirrored field of one row has no surface, a wrapped one of one texel no slope), at most
    /// 2^30 facets, spacings finite and > 0, every height finite (the first bad texel is
    /// named).
    HeightField(Image<double> heights_m, double spacing_x_m, double spacing_y_m,
                Boundary boundary = Boundary::kWrap, Diagonal diagonal = Diagonal::kRising);

    int Width() const { return heights_m_.Width(); }    ///< Texels along x.
    int Height() const { return heights_m_.Height(); }  ///< Texels along y.
    double SpacingXM() const { return spacing_x_m_; }
    double SpacingYM() const { return spacing_y_m_; }
    Boundary GetBoundary() const { return boundary_; }
    Diagonal GetDiagonal() const { return diagonal_; }

    int CellsX() const { return boundary_ == Boundary::kWrap ? Width() : Width() - 1; }
    int CellsY() const { return boundary_ == Boundary::kWrap ? Height() : Height() - 1; }
    std::int64_t Facets() const { return 2 * std::int64_t(CellsX()) * CellsY(); }

    /// Extent of the surface along x and y: CellsX() s_x and CellsY() s_y.
    double WidthM() const { return CellsX() * spacing_x_m_; }
    double HeightM() const { return CellsY() * spacing_y_m_; }

    /// Height of texel (i, j), 0 <= i < Width(), 0 <= j < Height().
    double At(int i, int j) const { return heights_m_(i, j); }
    const Image<double>& HeightsM() const { return heights_m_; }
    double LowestM() const { return lowest_m_; }
    double HighestM() const { return highest_m_; }

  private:
    Image<double> heights_m_;
    double spacing_x_m_, spacing_y_m_;
    Boundary boundary_;
    Diagonal diagonal_;
    double lowest_m_ = 0, highest_m_ = 0;
};

/// The same shape with its heights stretched so that highest - lowest = amplitude_m, the lowest
/// kept. Throws Error if amplitude_m is negative or not finite, or if the field is flat.
HeightField WithAmplitude(const HeightField& field, double amplitude_m);

/// Images of a field under the symmetries of the square grid, diagonal included, so that facets
/// map onto facets: mirrored in x; turned by a quarter (x to y); and every tile of a wrapped
/// field moved by (di, dj) texels.
HeightField MirroredX(const HeightField& field);
HeightField QuarterTurned(const HeightField& field);
HeightField Shifted(const HeightField& field, int di, int dj);

}  // namespace plumb
