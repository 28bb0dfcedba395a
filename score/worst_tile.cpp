#include "score/worst_tile.h"

#include <algorithm>

#include "core/distributions.h"
#include "core/error.h"
#include "core/intervals.h"

namespace plumb {

WorstTile FindWorstTile(ChannelSpan candidate, ChannelSpan truth, ChannelSpan standard_error,
                        const Mask& mask, const ErrorOptions& options, int tile_px) {
    if (tile_px < 1) throw Error(MustBe("tile_px", tile_px, ">= 1"));
    ErrorOptions tiled = options;
    tiled.tile_px = tile_px;
    const std::vector<TileError> errors =
        ScoreTiles(candidate, truth, standard_error, mask, tiled);
    const Tiling tiling(truth[0].Width(), truth[0].Height(), tile_px);
    WorstTile worst;
    for (const TileError& error : errors) worst.tiles += error.numbers > 0;
    if (worst.tiles == 0) return worst;
    const double z = NormalQuantile(1 - SidakLevel(1 - options.confidence, worst.tiles));
    bool first = true;
    for (int b = 0; b < tiling.Count(); ++b) {
        const TileError& error = errors[std::size_t(b)];
        if (error.numbers == 0) continue;
        worst.mse_at_least = std::max(worst.mse_at_least, error.mse - z * error.noise_error);
        if (!first && error.mse <= worst.mse) continue;
        first = false;
        worst.mse = error.mse;
        worst.noise_error = error.noise_error;
        worst.column_px = b % tiling.Columns() * tile_px;
        worst.row_px = b / tiling.Columns() * tile_px;
    }
    worst.width_px = std::min(tile_px, tiling.width_px - worst.column_px);
    worst.height_px = std::min(tile_px, tiling.height_px - worst.row_px);
    return worst;
}

}  // namespace plumb
