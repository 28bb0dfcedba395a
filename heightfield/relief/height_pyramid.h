// The heights of a field and the highest of every square of 2, 4, 8, ... cells a side, laid out
// so that many rays can look them up at once.
//
//       corner (i, j)        heights[j * corner_pitch + i],    0 <= i <= cells_x, 0 <= j <= cells_y
//       level l >= 1 over    tops[((rows - (rows >> (l - 1)) + (j >> l)) << pitch_bits) + (i >> l)]
//       cell (i, j)
//
// where rows = 2^k is twice the rows that level 1 is given, so that level l + 1 begins where
// level l, half as many rows, ends: the place of a level is a shift, not a table.
//
// Source   [Tevs08] (maximum mip-maps). Heights stand at the corners of cells, so a square's top
//          bounds its triangles and its bilinear patches alike.
// Symbols  i, j column and row of a cell; T float or double.
// Beware   The layout is that of heightfield/facet_walk.h: a wrapped field's first column and row
//          stand again behind its last, a falling field is stored as its mirror image in y.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "heightfield/height_field.h"

namespace plumb {

template <class T>
class HeightPyramid {
  public:
    /// Cost: one pass over the heights; memory: 2.5 to 4 numbers a texel, of which 1.3 are
    /// touched. Throws Error if the field has more than 2^15 cells along a side.
    explicit HeightPyramid(const HeightField& field);

    int CellsX() const { return cells_x_; }
    int CellsY() const { return cells_y_; }
    int Levels() const { return levels_; }  ///< Above the cells themselves, level 0.
    Boundary GetBoundary() const { return boundary_; }
    bool Falling() const { return falling_; }
    double SpacingXM() const { return spacing_x_m_; }
    double SpacingYM() const { return spacing_y_m_; }
    T HighestM() const { return highest_m_; }
    T LowestM() const { return lowest_m_; }
    double FarM() const { return far_m_; }  ///< FarDistanceM of the field.

    const T* Heights() const { return heights_m_.data(); }
    int CornerPitch() const { return cells_x_ + 1; }
    const T* Tops() const { return tops_m_.get(); }
    int PitchBits() const { return pitch_bits_; }
    int Rows() const { return rows_; }

    T Corner(int i, int j) const {
        return heights_m_[std::size_t(j) * std::size_t(CornerPitch()) + std::size_t(i)];
    }
    /// Highest corner of square (bi, bj) of level l >= 1.
    T TopOf(int level, int bi, int bj) const { return tops_m_[TopIndex(level, bi, bj)]; }

    /// The facet, in HeightField's numbering, that is half `upper` of cell (i, j) as stored here.
    std::int64_t FacetNumber(int i, int j, int upper) const {
        return falling_ ? 2 * (std::int64_t(cells_y_ - 1 - j) * cells_x_ + i) + (1 - upper)
                        : 2 * (std::int64_t(j) * cells_x_ + i) + upper;
    }

  private:
    std::size_t TopIndex(int level, int bi, int bj) const {
        return (std::size_t(rows_ - (rows_ >> (level - 1)) + bj) << pitch_bits_) +
               std::size_t(bi);
    }

    int cells_x_, cells_y_, levels_ = 1, pitch_bits_ = 0, rows_ = 2;
    double spacing_x_m_, spacing_y_m_, far_m_;
    Boundary boundary_;
    bool falling_;
    T highest_m_, lowest_m_;
    std::vector<T> heights_m_;
    std::unique_ptr<T[]> tops_m_;
};

extern template class HeightPyramid<float>;
extern template class HeightPyramid<double>;

}  // namespace plumb
