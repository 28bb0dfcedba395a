#include "jobs/screen_space/guard_study.h"

#include <algorithm>
#include <cmath>

#include "core/time_in_turns.h"
#include "jobs/screen_space/score_technique.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {

std::vector<int> GuardWidths(int height_px, const SaoOptions& options) {
    constexpr int kMoreWidths = 5;
    constexpr double kShareEach = 0.05;
    // A quad is 2 px; a texel of level m is 2^m.
    const int texel_px = std::max(2, 1 << options.sampling.taps.coarsest_level);
    const int step_px =
        texel_px * std::max(1, int(std::lround(kShareEach * height_px / texel_px)));
    std::vector<int> widths_px;
    for (int k = 0; k <= kMoreWidths; ++k) widths_px.push_back(k * step_px);
    return widths_px;
}

std::vector<GuardRow> StudyGuardBand(const Scene& scene, const Camera& camera,
                                     const ViewTruth& truth, const SaoOptions& options,
                                     int rounds, const Clock& clock, Monitor& monitor) {
    const Mask border = RegionsOf(truth).border;
    const TruthImage& weighted = truth.near.at(FalloffOf(options.sampling.sao.falloff));
    const std::vector<int> widths_px = GuardWidths(camera.height_px, options);
    Rasterizer rasterizer;
    GBuffer gbuffer;  // Its memory, and the passes', are used again, as an engine would.
    SaoScratch scratch;
    std::vector<GuardRow> rows;
    std::vector<Image<float>> pictures;
    std::vector<Turn> turns;
    for (const int guard_px : widths_px) {
        GuardRow row;
        row.share = double(guard_px) / camera.height_px;
        row.guard_px = guard_px;
        rows.push_back(std::move(row));
        SaoOptions aligned = options;
        aligned.sampling.taps.hash_shift_px = widths_px.back() - guard_px;
        const auto draw = [&, guard_px] {
            DrawGBuffer(rasterizer, scene, camera, SuitedTo(scene, camera, guard_px), gbuffer);
        };
        const auto sao = [&, aligned] { SaoObscurance(gbuffer, aligned, scratch); };
        draw();
        pictures.push_back(Shown(SaoObscurance(gbuffer, aligned, scratch), gbuffer.view));
        turns.push_back({draw});
        turns.push_back({sao});  // Of what was drawn just before it.
    }
    const TurnTimes times = TimeInTurns(turns, rounds, clock, monitor);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].draw_s = times.Seconds(2 * k);
        rows[k].sao_s = times.Seconds(2 * k + 1);
    }
    if (CountOf(border) == 0) return rows;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].rms_to_widest = ScoreErrors(pictures[k], pictures.back(), {}, border).rmse;
        rows[k].border = ScoreOver(pictures[k], weighted, kTruthWeighted, "border", border);
    }
    return rows;
}

}  // namespace plumb
