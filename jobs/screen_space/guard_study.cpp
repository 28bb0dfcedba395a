#include "jobs/screen_space/guard_study.h"

#include <algorithm>
#include <cmath>

#include "jobs/screen_space/score_technique.h"
#include "screen_space/raster/draw_gbuffer.h"

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
                                     const PassClock& clock) {
    const Mask border = RegionsOf(truth).border;
    const TruthImage& weighted = truth.near.at(FalloffOf(options.sampling.sao.falloff));
    const std::vector<int> widths_px = GuardWidths(camera.height_px, options);
    std::vector<GuardRow> rows;
    std::vector<Image<float>> pictures;
    for (const int guard_px : widths_px) {
        SaoOptions aligned = options;
        aligned.sampling.taps.hash_shift_px = widths_px.back() - guard_px;
        GuardRow row;
        row.share = double(guard_px) / camera.height_px;
        row.guard_px = guard_px;
        const double begin_s = clock();
        const GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = guard_px});
        const double drawn_s = clock();
        pictures.push_back(Shown(SaoObscurance(gbuffer, aligned), gbuffer.view));
        row.sao_s = clock() - drawn_s;
        row.draw_s = drawn_s - begin_s;
        rows.push_back(std::move(row));
    }
    if (CountOf(border) == 0) return rows;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        rows[k].rms_to_widest = ScoreErrors(pictures[k], pictures.back(), {}, border).rmse;
        rows[k].border = ScoreOver(pictures[k], weighted, kTruthWeighted, "border", border);
    }
    return rows;
}

}  // namespace plumb
