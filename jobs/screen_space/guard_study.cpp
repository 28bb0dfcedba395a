#include "jobs/screen_space/guard_study.h"

#include <algorithm>
#include <cmath>

#include "jobs/screen_space/score_technique.h"
#include "screen_space/raster/draw_gbuffer.h"

namespace plumb {

std::vector<GuardRow> StudyGuardBand(const Scene& scene, const Camera& camera,
                                     const ViewTruth& truth, const SaoOptions& options,
                                     const PassClock& clock) {
    constexpr double kShares[] = {0.25, 0.2, 0.15, 0.1, 0.05, 0};
    const Mask border = RegionsOf(truth).border;
    const TruthImage& weighted = truth.near.at(FalloffOf(options.sampling.sao.falloff));
    std::vector<GuardRow> rows;
    Image<float> widest;
    for (const double share : kShares) {
        GuardRow row;
        row.share = share;
        row.guard_px = int(std::lround(share * camera.height_px));
        const double begin_s = clock();
        const GBuffer gbuffer = DrawGBuffer(scene, camera, {.guard_px = row.guard_px});
        const double drawn_s = clock();
        const Image<float> A = Shown(SaoObscurance(gbuffer, options), gbuffer.view);
        row.sao_s = clock() - drawn_s;
        row.draw_s = drawn_s - begin_s;
        if (widest.Empty()) widest = A;
        if (CountOf(border) > 0) {
            row.rms_to_widest = ScoreErrors(A, widest, {}, border).rmse;
            row.border = ScoreOver(A, weighted, kTruthWeighted, "border", border);
        }
        rows.push_back(std::move(row));
    }
    std::reverse(rows.begin(), rows.end());
    return rows;
}

}  // namespace plumb
