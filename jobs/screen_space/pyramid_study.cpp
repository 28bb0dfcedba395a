#include "jobs/screen_space/pyramid_study.h"

#include <cmath>
#include <utility>

#include "jobs/screen_space/score_technique.h"

namespace plumb {
namespace {

const std::pair<const char*, ZFilter> kFilters[] = {
    {"rotated grid", ZFilter::kRotatedGrid},
    {"rotated grid, G3D 10", ZFilter::kRotatedGridG3d10},
    {"arithmetic mean", ZFilter::kMean},
    {"harmonic mean", ZFilter::kHarmonicMean},
    {"min (farthest)", ZFilter::kMin},
    {"max (nearest)", ZFilter::kMax},
};

}  // namespace

std::vector<PyramidRow> StudyPyramid(const TechniqueInput& in, const ViewTruth& truth,
                                     const SaoOptions& options) {
    SaoOptions raw = options;
    raw.quad_filter = raw.pack_rgb8 = raw.blur_x = raw.blur_y = false;
    const Mask seen = RegionsOf(truth).seen;
    const TruthImage& weighted = truth.near.at(FalloffOf(raw.sampling.sao.falloff));
    std::vector<PyramidRow> rows;
    Image<float> without;
    const auto add = [&](std::string name) {
        const Image<float> A = Shown(SaoObscurance(in.gbuffer, raw), in.gbuffer.view);
        if (without.Empty()) without = A;
        const ErrorScore change = ScoreErrors(A, without, {}, seen);
        rows.push_back(
            {.filter = std::move(name),
             .bias_to_none = change.bias,
             .rms_to_none = change.rmse,
             .against_truth = ScoreOver(A, weighted, kTruthWeighted, "whole", seen)});
    };
    raw.sampling.taps.coarsest_level = 0;
    add("none");
    raw.sampling.taps.coarsest_level = options.sampling.taps.coarsest_level;
    for (const auto& [name, filter] : kFilters) {
        raw.sampling.taps.filter = filter;
        add(name);
    }
    return rows;
}

}  // namespace plumb
