#include "jobs/screen_space/guard_study.h"

#include <algorithm>
#include <cmath>

#include "core/time_in_turns.h"
#include "jobs/bench_facts.h"
#include "jobs/screen_space/score_columns.h"
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

doc::Section StudyGuardBand(const Scene& scene, const Camera& camera, const ViewTruth& truth,
                            const SaoOptions& options, int rounds, const RunContext& run) {
    const Mask border = RegionsOf(truth).border;
    const TruthImage& weighted = truth.near.at(FalloffOf(options.sampling.sao.falloff));
    const std::vector<int> widths_px = GuardWidths(camera.height_px, options);
    Rasterizer rasterizer;
    GBuffer gbuffer;  // Its memory, and the passes', are used again, as an engine would.
    SaoScratch scratch;
    std::vector<Image<float>> pictures;
    std::vector<Turn> turns;
    for (const int guard_px : widths_px) {
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
    const TurnTimes times = TimeInTurns(turns, rounds, run.clock, run.monitor);
    doc::Table table{
        .key = "guard_bands",
        .columns = {doc::Name("guard_px", "Border"),
                    {.key = "share_of_height", .title = "Of the height", .digits = 2},
                    TimeColumn("draw_ms", "G-buffer", "ms"),
                    TimeColumn("sao_ms", "SAO", "ms"),
                    RmseColumn("rms_to_widest", "RMS to the widest")}};
    table.columns[0].unit = "px";
    AddScoreColumns(table, {"bias", "rmse"});
    for (std::size_t k = 0; k < widths_px.size(); ++k) {
        std::vector<doc::Cell> row{widths_px[k], double(widths_px[k]) / camera.height_px,
                                   1e3 * times.Seconds(2 * k), 1e3 * times.Seconds(2 * k + 1)};
        if (CountOf(border) > 0) {
            row.push_back(ScoreErrors(pictures[k], pictures.back(), {}, border).rmse);
            AddScore(ScoreOver(pictures[k], weighted, kTruthWeighted, "border", border), row);
        }
        row.resize(table.columns.size());
        table.Add(std::move(row));
    }
    return {
        .id = "guard",
        .title = "The guard band",
        .sentences = {"Border drawn but not shown, in whole texels of the pyramid, the "
                      "pattern of taps held to the frame; figures of the pixels within 32 px "
                      "of the frame, as shipped, against V within r weighted by the falloff. "
                      "What is left of the RMSE is what lies beyond the frame."},
        .tables = {std::move(table)}};
}

}  // namespace plumb
