#include "heightfield/relief/height_pyramid.h"

#include <algorithm>
#include <string>

#include "core/error.h"
#include "heightfield/ray_cast.h"

namespace plumb {
namespace {

// Places of tops are 32-bit numbers where T is float.
constexpr int kMostCells = 1 << 15;
// Room for squares of so many cells a side over a field of few rows.
constexpr int kFewestRows = 64;

}  // namespace

template <class T>
HeightPyramid<T>::HeightPyramid(const HeightField& field)
    : cells_x_(field.CellsX()),
      cells_y_(field.CellsY()),
      spacing_x_m_(field.SpacingXM()),
      spacing_y_m_(field.SpacingYM()),
      far_m_(FarDistanceM(field)),
      boundary_(field.GetBoundary()),
      falling_(field.GetDiagonal() == Diagonal::kFalling),
      highest_m_(T(field.HighestM())),
      lowest_m_(T(field.LowestM())) {
    if (std::max(cells_x_, cells_y_) > kMostCells) {
        throw Error("HeightPyramid: " + std::to_string(cells_x_) + " x " +
                    std::to_string(cells_y_) + " cells, must be at most " +
                    std::to_string(kMostCells) + " along a side");
    }
    const int columns = cells_x_ + 1, rows = cells_y_ + 1;
    heights_m_.resize(std::size_t(columns) * std::size_t(rows));
    for (int j = 0; j < rows; ++j) {
        const int row = (falling_ ? cells_y_ - j : j) % field.Height();
        for (int i = 0; i < columns; ++i) {
            heights_m_[std::size_t(j) * columns + i] = T(field.At(i % field.Width(), row));
        }
    }

    while (rows_ < std::max(cells_y_, kFewestRows)) rows_ *= 2;
    while ((2 << pitch_bits_) < cells_x_) ++pitch_bits_;
    const int size = std::max(cells_x_, cells_y_);
    while ((1 << levels_) < std::min(size, rows_)) ++levels_;
    tops_m_ = std::make_unique_for_overwrite<T[]>(std::size_t(rows_) << pitch_bits_);
    int wide = (cells_x_ + 1) / 2, high = (cells_y_ + 1) / 2;
    for (int bj = 0; bj < high; ++bj) {
        for (int bi = 0; bi < wide; ++bi) {
            T top = Corner(2 * bi, 2 * bj);
            for (int j = 2 * bj; j <= std::min(2 * bj + 2, cells_y_); ++j) {
                for (int i = 2 * bi; i <= std::min(2 * bi + 2, cells_x_); ++i) {
                    top = std::max(top, Corner(i, j));
                }
            }
            tops_m_[TopIndex(1, bi, bj)] = top;
        }
    }
    for (int level = 2; level <= levels_; ++level) {
        const int of_wide = wide, of_high = high;
        wide = (wide + 1) / 2, high = (high + 1) / 2;
        for (int bj = 0; bj < high; ++bj) {
            for (int bi = 0; bi < wide; ++bi) {
                const int i_1 = std::min(2 * bi + 1, of_wide - 1);
                const int j_1 = std::min(2 * bj + 1, of_high - 1);
                tops_m_[TopIndex(level, bi, bj)] =
                    std::max({tops_m_[TopIndex(level - 1, 2 * bi, 2 * bj)],
                              tops_m_[TopIndex(level - 1, i_1, 2 * bj)],
                              tops_m_[TopIndex(level - 1, 2 * bi, j_1)],
                              tops_m_[TopIndex(level - 1, i_1, j_1)]});
            }
        }
    }
}

template class HeightPyramid<float>;
template class HeightPyramid<double>;

}  // namespace plumb
