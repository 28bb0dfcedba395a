#include "jobs/screen_space/error_budget.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/time_in_turns.h"
#include "jobs/bench_facts.h"
#include "jobs/screen_space/layered_obscurance.h"
#include "jobs/screen_space/score_columns.h"
#include "reports/text.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {
namespace {

// Pixels of every stride-th column and row that show a surface.
Mask Sparse(const Mask& seen, int stride_px) {
    Mask mask(seen.Width(), seen.Height(), 0);
    for (int j = 0; j < seen.Height(); j += stride_px) {
        for (int i = 0; i < seen.Width(); i += stride_px) mask(i, j) = seen(i, j);
    }
    return mask;
}

// What was not made weighs nothing anyway; scores want numbers.
Image<float> Filled(Image<float> image) {
    for (float& value : image.Pixels()) {
        if (std::isnan(value)) value = 1;
    }
    return image;
}

double RmsDifference(const Image<float>& a, const Image<float>& b, const Mask& mask) {
    return ScoreErrors(a, b, {}, mask).rmse.value;
}

// A before any filter at the pixels of the mask, the taps many.
Image<float> SparseObscurance(const GBuffer& gbuffer, const SaoOptions& options,
                              const Mask& mask, Monitor& monitor) {
    const ZPyramid pyramid = BuildZPyramid(gbuffer, options);
    const int guard_px = gbuffer.view.guard_px;
    Image<float> A(mask.Width(), mask.Height(), 1);
    ParallelFor(
        mask.Height(), 1,
        [&](std::int64_t begin, std::int64_t end) {
            for (int j = int(begin); j < int(end); ++j) {
                for (int i = 0; i < mask.Width(); ++i) {
                    if (mask(i, j) == 0) continue;
                    A(i, j) = float(ObscuranceOfPixel(gbuffer, pyramid, options.sampling,
                                                      i + guard_px, j + guard_px));
                }
            }
        },
        monitor, "error budget");
    return A;
}

// A configuration that makes a whole picture, and what is said of it.
struct WholePicture {
    std::string step, what;
    SaoOptions options;
};

class Budget {
  public:
    Budget(const ViewTruth& truth, Falloff falloff, int stride_px)
        : near_(truth.near.at(Falloff::kHard)),
          weighted_(truth.near.at(falloff)),
          mask_(Sparse(RegionsOf(truth).seen, stride_px)),
          steps{.key = "budget",
                .columns = {doc::Name("step", "Step"),
                            {.key = "what", .title = "What is switched on"},
                            TimeColumn("ms", "Time", "ms"),
                            {.key = "rms_change",
                             .title = "Moves",
                             .meaning = "RMS change of the picture by the step alone"}},
                .steps = "rmse",
                .ticks = "recalibrated_rmse"} {
        AddScoreColumns(steps, {"bias", "rmse", "psnr_db", "recalibrated_rmse"});
        AddScoreColumns(steps, {"rmse"}, "own_", "To its own: ");
        // The ideal and the truth come of the same rays: nothing is taken off.
        Add("ideal", "visibility weighted by the falloff, path-traced", weighted_.value,
            {near_.value, {}});
    }

    const Mask& Pixels() const { return mask_; }

    std::vector<doc::Cell> Row(std::string step, std::string what, const Image<float>& A,
                               const TruthImage& near) const {
        std::vector<doc::Cell> row{std::move(step),
                                   std::move(what),
                                   {},
                                   last_.Empty() ? 0 : RmsDifference(A, last_, mask_)};
        AddScore(ScoreOver(A, near, kTruthNear, "whole", mask_), row);
        AddScore(ScoreOver(A, weighted_, kTruthWeighted, "whole", mask_), row);
        return row;
    }
    std::vector<doc::Cell> Row(std::string step, std::string what,
                               const Image<float>& A) const {
        return Row(std::move(step), std::move(what), A, near_);
    }

    void Add(std::string step, std::string what, const Image<float>& A,
             const TruthImage& near) {
        steps.Add(Row(std::move(step), std::move(what), A, near));
        last_ = A;
    }
    void Add(std::string step, std::string what, const Image<float>& A) {
        Add(std::move(step), std::move(what), A, near_);
    }

  private:
    const TruthImage& near_;
    const TruthImage& weighted_;
    Mask mask_;
    Image<float> last_;

  public:
    doc::Table steps;
};

// The steps after the integrals: the switches that are on, each switched on after the other.
std::vector<WholePicture> StepsTo(const SaoOptions& shipped) {
    std::vector<BoundKnob<SaoOptions>> switches;
    for (const char* name : {"pyramid", "quads", "packing", "filter_x", "filter_y"}) {
        const BoundKnob<SaoOptions> bound = SaoKnob(name);
        if (bound.get(shipped) != 0) switches.push_back(bound);
    }
    std::vector<WholePicture> steps;
    for (std::size_t on = 0; on <= switches.size(); ++on) {
        SaoOptions now = shipped;
        for (std::size_t k = on; k < switches.size(); ++k) switches[k].set(now, 0);
        if (on == 0) {
            steps.push_back(
                {"taps", std::to_string(shipped.sampling.taps.samples) + " taps a pixel", now});
        } else {
            const Knob& knob = switches[on - 1].knob;
            steps.push_back({knob.name, knob.meaning, now});
        }
    }
    return steps;
}

// As shipped, the taps many and nothing after them.
SaoOptions Integral(const SaoOptions& shipped, int many_taps) {
    SaoOptions options = shipped;
    options.sampling.taps.samples = many_taps;
    options.sampling.taps.turns = 0;
    options.sampling.taps.phi = PhiArithmetic::kExact;
    options.sampling.taps.coarsest_level = 0;
    options.sampling.normals = NormalSource::kFace;
    options.quad_filter = options.pack_rgb8 = options.blur_x = options.blur_y = false;
    return options;
}

}  // namespace

doc::Section MakeErrorBudget(const std::string& technique, const SaoOptions& shipped,
                             const Scene& scene, const Camera& camera, const RayCaster& caster,
                             const ViewTruth& truth, const BudgetOptions& options,
                             const RunContext& run) {
    Budget budget(truth, FalloffOf(shipped.sampling.sao.falloff), options.stride_px);
    const GBuffer gbuffer =
        DrawGBuffer(scene, camera, SuitedTo(scene, camera, options.guard_px));
    SaoOptions integral = Integral(shipped, options.many_taps);
    {
        const int wide_px = std::max(
            options.guard_px, int(std::lround(options.wide_guard_share * camera.height_px)));
        const GBuffer wide = DrawGBuffer(scene, camera, SuitedTo(scene, camera, wide_px));
        SaoOptions aligned = integral;
        aligned.sampling.taps.hash_shift_px = options.guard_px - wide_px;
        budget.Add("estimator", "the estimator's integral over all layers of depth",
                   Filled(LayeredObscurance({wide, scene, camera, caster}, aligned,
                                            {.stride_px = options.stride_px}, run.monitor)));
        budget.Add("one layer", "the depth buffer's nearest surface only",
                   SparseObscurance(wide, aligned, budget.Pixels(), run.monitor));
    }
    budget.Add("border", "no more of a border than the shipped picture's",
               SparseObscurance(gbuffer, integral, budget.Pixels(), run.monitor));
    integral.sampling.normals = shipped.sampling.normals;
    budget.Add("normals",
               shipped.sampling.normals == NormalSource::kDepth ? "normals made from depth"
                                                                : "the normals as shipped",
               SparseObscurance(gbuffer, integral, budget.Pixels(), run.monitor));

    std::vector<WholePicture> steps = StepsTo(shipped);
    const std::size_t first_whole = budget.steps.rows.size();
    for (const WholePicture& step : steps) {
        budget.Add(step.step, step.what,
                   Shown(SaoObscurance(gbuffer, step.options), gbuffer.view));
    }
    const GBuffer borderless = DrawGBuffer(scene, camera, SuitedTo(scene, camera, 0));
    SaoOptions without = shipped;
    without.sampling.taps.hash_shift_px = options.guard_px;
    doc::Table no_border{
        .key = "no_border", .title = "Without a guard band", .columns = budget.steps.columns};
    no_border.Add(budget.Row("no border", "As shipped, but without a guard band",
                             SaoObscurance(borderless, without)));

    SaoScratch scratch;  // As an engine keeps its targets.
    std::vector<Turn> turns;
    for (const WholePicture& step : steps) {
        turns.push_back({[&, &with = step.options] { SaoObscurance(gbuffer, with, scratch); }});
    }
    turns.push_back({[&] { SaoObscurance(borderless, without, scratch); }});
    const TurnTimes times = TimeInTurns(turns, options.rounds, run.clock, run.monitor);
    constexpr std::size_t kMs = 2;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        budget.steps.rows[first_whole + k][kMs] = 1e3 * times.Seconds(k);
    }
    no_border.rows[0][kMs] = 1e3 * times.Seconds(steps.size());
    return {.id = "budget",
            .title = "Error budget",
            .sentences =
                {technique + ", one approximation switched on after the other, " +
                 Count(options.many_taps) +
                 " taps in place of an integral. All rows are scored against V within r: the "
                 "first is what the technique's falloff costs, the last the technique as "
                 "shipped. *To its own*: against V within r weighted by that falloff."},
            .facts = {{{.key = "budget_technique", .title = "Technique"}, technique},
                      {{.key = "budget_pixels", .title = "Pixels scored"},
                       CountOf(budget.Pixels())},
                      {{.key = "budget_taps", .title = "Taps in place of an integral"},
                       options.many_taps}},
            .tables = {std::move(budget.steps), std::move(no_border)}};
}

}  // namespace plumb
