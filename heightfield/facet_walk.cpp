#include "heightfield/facet_walk.h"

namespace plumb {

WalkGrid::WalkGrid(const HeightField& field)
    : cells_x_(field.CellsX()),
      cells_y_(field.CellsY()),
      spacing_x_m_(field.SpacingXM()),
      spacing_y_m_(field.SpacingYM()),
      boundary_(field.GetBoundary()),
      falling_(field.GetDiagonal() == Diagonal::kFalling),
      highest_m_(field.HighestM()) {
    const int columns = cells_x_ + 1, rows = cells_y_ + 1;
    corners_m_.resize(std::size_t(columns) * rows);
    for (int j = 0; j < rows; ++j) {
        const int row = (falling_ ? cells_y_ - j : j) % field.Height();
        for (int i = 0; i < columns; ++i) {
            corners_m_[std::size_t(j) * columns + i] = field.At(i % field.Width(), row);
        }
    }
    for (int bits = kBlockBits;; bits += kBlockBits) {
        const int side = 1 << bits;
        Level level{bits, (cells_x_ + side - 1) / side, {}};
        const int block_rows = (cells_y_ + side - 1) / side;
        level.highest_m.reserve(std::size_t(level.columns) * block_rows);
        for (int bj = 0; bj < block_rows; ++bj) {
            for (int bi = 0; bi < level.columns; ++bi) {
                double highest = field.LowestM();
                for (int j = bj * side; j <= std::min((bj + 1) * side, cells_y_); ++j) {
                    for (int i = bi * side; i <= std::min((bi + 1) * side, cells_x_); ++i) {
                        highest = std::max(highest, Corner(i, j));
                    }
                }
                level.highest_m.push_back(highest);
            }
        }
        const bool whole = level.highest_m.size() == 1;
        levels_.push_back(std::move(level));
        if (whole) break;
    }
}

}  // namespace plumb
