#include "jobs/screen_space/error_budget.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/time_in_turns.h"
#include "jobs/screen_space/layered_obscurance.h"
#include "jobs/screen_space/score_technique.h"
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
          mask_(Sparse(RegionsOf(truth).seen, stride_px)) {}

    const Mask& Pixels() const { return mask_; }

    BudgetRow Row(std::string step, std::string what, const Image<float>& A) const {
        BudgetRow row;
        row.step = std::move(step);
        row.what = std::move(what);
        row.score = ScoreOver(A, near_, kTruthNear, "whole", mask_);
        row.weighted = ScoreOver(A, weighted_, kTruthWeighted, "whole", mask_);
        row.rms_change = last_.Empty() ? 0 : RmsDifference(A, last_, mask_);
        return row;
    }

    void Add(std::string step, std::string what, const Image<float>& A) {
        rows.push_back(Row(std::move(step), std::move(what), A));
        last_ = A;
    }

    void AddIdeal() {
        Add("ideal", "visibility weighted by the falloff, path-traced", weighted_.value);
        rows.back().score =
            ScoreOver(weighted_.value, {near_.value, {}}, kTruthNear, "whole", mask_);
    }

    std::vector<BudgetRow> rows;

  private:
    const TruthImage& near_;
    const TruthImage& weighted_;
    Mask mask_;
    Image<float> last_;
};

// The steps after the integrals, each switched on after the other.
std::vector<WholePicture> StepsTo(const SaoOptions& shipped) {
    SaoOptions now = shipped;
    now.sampling.taps.coarsest_level = 0;
    now.quad_filter = now.pack_rgb8 = now.blur_x = now.blur_y = false;
    std::vector<WholePicture> steps;
    steps.push_back(
        {"taps", std::to_string(shipped.sampling.taps.samples) + " taps a pixel", now});
    now.sampling.taps.coarsest_level = shipped.sampling.taps.coarsest_level;
    steps.push_back({"pyramid", "taps read the z pyramid", now});
    const auto on = [&](bool SaoOptions::*pass, const char* step, const char* what) {
        if (!(shipped.*pass)) return;
        now.*pass = true;
        steps.push_back({step, what, now});
    };
    on(&SaoOptions::quad_filter, "quads", "2 x 2 quads averaged");
    on(&SaoOptions::pack_rgb8, "RGB8", "A and z packed into 8-bit channels");
    on(&SaoOptions::blur_x, "filter x", "bilateral filter along x");
    on(&SaoOptions::blur_y, "filter y", "bilateral filter along y: as shipped");
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

ErrorBudget MakeErrorBudget(const SaoOptions& shipped, const Scene& scene, const Camera& camera,
                            const RayCaster& caster, const ViewTruth& truth,
                            const BudgetOptions& options, const Clock& clock,
                            Monitor& monitor) {
    Budget budget(truth, FalloffOf(shipped.sampling.sao.falloff), options.stride_px);
    budget.AddIdeal();
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
                                            {.stride_px = options.stride_px}, monitor)));
        budget.Add("one layer", "the depth buffer's nearest surface only",
                   SparseObscurance(wide, aligned, budget.Pixels(), monitor));
    }
    budget.Add("border", "no more of a border than the shipped picture's",
               SparseObscurance(gbuffer, integral, budget.Pixels(), monitor));
    integral.sampling.normals = shipped.sampling.normals;
    budget.Add("normals",
               shipped.sampling.normals == NormalSource::kDepth ? "normals made from depth"
                                                                : "the normals as shipped",
               SparseObscurance(gbuffer, integral, budget.Pixels(), monitor));

    std::vector<WholePicture> steps = StepsTo(shipped);
    const std::size_t first_whole = budget.rows.size();
    for (const WholePicture& step : steps) {
        budget.Add(step.step, step.what,
                   Shown(SaoObscurance(gbuffer, step.options), gbuffer.view));
    }
    const GBuffer borderless = DrawGBuffer(scene, camera, SuitedTo(scene, camera, 0));
    SaoOptions without = shipped;
    without.sampling.taps.hash_shift_px = options.guard_px;
    ErrorBudget result;
    result.no_border = budget.Row("no border", "as shipped, but without a guard band",
                                  SaoObscurance(borderless, without));

    SaoScratch scratch;  // As an engine keeps its targets.
    std::vector<Turn> turns;
    for (const WholePicture& step : steps) {
        turns.push_back({[&, &with = step.options] { SaoObscurance(gbuffer, with, scratch); }});
    }
    turns.push_back({[&] { SaoObscurance(borderless, without, scratch); }});
    const TurnTimes times = TimeInTurns(turns, options.rounds, clock, monitor);
    for (std::size_t k = 0; k < steps.size(); ++k) {
        budget.rows[first_whole + k].seconds = times.Seconds(k);
    }
    result.no_border.seconds = times.Seconds(steps.size());
    result.rows = std::move(budget.rows);
    result.pixels = CountOf(budget.Pixels());
    return result;
}

}  // namespace plumb
