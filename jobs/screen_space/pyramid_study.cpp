#include "jobs/screen_space/pyramid_study.h"

#include "jobs/screen_space/score_columns.h"

namespace plumb {

doc::Section StudyPyramid(const TechniqueInput& in, const ViewTruth& truth,
                          const SaoOptions& options) {
    SaoOptions raw = options;
    raw.quad_filter = raw.pack_rgb8 = raw.blur_x = raw.blur_y = false;
    const Mask seen = RegionsOf(truth).seen;
    const TruthImage& weighted = truth.near.at(FalloffOf(raw.sampling.sao.falloff));
    doc::Table table{
        .key = "pyramids",
        .columns = {
            doc::Name("filter", "Filter"),
            {.key = "bias_to_none", .title = "Bias to none", .better = doc::Better::kNearZero},
            RmseColumn("rms_to_none", "RMS to none")}};
    AddScoreColumns(table, {"bias", "rmse", "recalibrated_rmse"});
    Image<float> without;
    const auto add = [&](const std::string& name) {
        const Image<float> A = Shown(SaoObscurance(in.gbuffer, raw), in.gbuffer.view);
        if (without.Empty()) without = A;
        const ErrorScore change = ScoreErrors(A, without, {}, seen);
        std::vector<doc::Cell> row{name, change.bias, change.rmse};
        AddScore(ScoreOver(A, weighted, kTruthWeighted, "whole", seen), row);
        table.Add(std::move(row));
    };
    raw.sampling.taps.coarsest_level = 0;
    add("none");
    raw.sampling.taps.coarsest_level = options.sampling.taps.coarsest_level;
    const BoundKnob<SaoOptions> filter = SaoKnob("pyramid_filter");
    for (std::size_t k = 0; k < filter.knob.choices.size(); ++k) {
        filter.set(raw, double(k));
        add(filter.knob.choices[k]);
    }
    return {
        .id = "pyramid",
        .title = "How the z pyramid is made",
        .sentences = {"The paper's table 1 with numbers: A before any filter, against itself "
                      "without a pyramid, and against V within r weighted by its falloff. "
                      "`min` keeps the farthest of four depths, `max` the nearest."},
        .tables = {std::move(table)}};
}

}  // namespace plumb
