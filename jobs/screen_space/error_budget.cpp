#include "jobs/screen_space/error_budget.h"

#include <algorithm>
#include <cmath>

#include "jobs/screen_space/layered_obscurance.h"
#include "jobs/screen_space/score_technique.h"
#include "screen_space/raster/draw_gbuffer.h"

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
    double squares = 0, n = 0;
    for (std::size_t p = 0; p < mask.Pixels().size(); ++p) {
        if (mask.Pixels()[p] == 0) continue;
        const double d = double(a.Pixels()[p]) - double(b.Pixels()[p]);
        squares += d * d;
        ++n;
    }
    return n > 0 ? std::sqrt(squares / n) : 0;
}

class Budget {
  public:
    Budget(const Scene& scene, const Camera& camera, const RayCaster& caster,
           const ViewTruth& truth, Falloff falloff, int stride_px, const PassClock& clock)
        : scene_(scene),
          camera_(camera),
          caster_(caster),
          truth_(truth),
          weighted_(truth.near.at(falloff)),
          mask_(Sparse(RegionsOf(truth).seen, stride_px)),
          clock_(clock) {}

    void Row(std::string step, std::string what, const Image<float>& A, double seconds) {
        BudgetRow row;
        row.step = std::move(step);
        row.what = std::move(what);
        row.score = ScoreOver(A, weighted_, kTruthWeighted, "whole", mask_);
        row.rms_change = last_.Empty() ? 0 : RmsDifference(A, last_, mask_);
        row.seconds = seconds;
        row.pixels = row.score.error.pixels;
        last_ = A;
        rows.push_back(std::move(row));
    }

    void Ideal() {
        // Against itself it has no error; what its falloff costs is its distance from V within r.
        Row("ideal", "visibility weighted by the falloff, path-traced", weighted_.value, 0);
        rows.back().score = ScoreOver(weighted_.value, truth_.near.at(Falloff::kHard),
                                      kTruthNear, "whole", mask_);
    }

    GBuffer Draw(int guard_px) const {
        return DrawGBuffer(scene_, camera_, {.guard_px = guard_px});
    }

    void AllLayers(const GBuffer& gbuffer, const SaoOptions& options, int stride_px,
                   Monitor& monitor) {
        const TechniqueInput in{gbuffer, scene_, camera_, caster_};
        const double begin_s = clock_();
        const Image<float> A =
            LayeredObscurance(in, options, {.stride_px = stride_px}, monitor);
        Row("estimator", "the estimator's integral over all layers of depth", Filled(A),
            clock_() - begin_s);
    }

    void Sao(std::string step, std::string what, const GBuffer& gbuffer,
             const SaoOptions& options) {
        const double begin_s = clock_();
        const Image<float> A = SaoObscurance(gbuffer, options);
        const double seconds = clock_() - begin_s;
        Row(std::move(step), std::move(what), Shown(A, gbuffer.view), seconds);
    }

    std::vector<BudgetRow> rows;

  private:
    const Scene& scene_;
    const Camera& camera_;
    const RayCaster& caster_;
    const ViewTruth& truth_;
    const TruthImage& weighted_;
    Mask mask_;
    const PassClock& clock_;
    Image<float> last_;
};

}  // namespace

std::vector<BudgetRow> MakeErrorBudget(const SaoOptions& shipped, const Scene& scene,
                                       const Camera& camera, const RayCaster& caster,
                                       const ViewTruth& truth, const BudgetOptions& options,
                                       const PassClock& clock, Monitor& monitor) {
    const Falloff falloff = FalloffOf(shipped.sampling.sao.falloff);
    Budget budget(scene, camera, caster, truth, falloff, options.stride_px, clock);
    budget.Ideal();

    SaoOptions now = shipped;
    now.sampling.taps.samples = options.many_taps;
    now.sampling.taps.turns = 0;
    now.sampling.taps.phi = PhiArithmetic::kExact;
    now.sampling.taps.coarsest_level = 0;
    now.sampling.normals = NormalSource::kFace;
    now.quad_filter = now.pack_rgb8 = now.blur_x = now.blur_y = false;
    const int wide_px = std::max(options.guard_px,
                                 int(std::lround(options.wide_guard_share * camera.height_px)));
    const GBuffer wide = budget.Draw(wide_px);
    budget.AllLayers(wide, now, options.stride_px, monitor);
    budget.Sao("one layer", "the depth buffer's nearest surface only", wide, now);
    monitor.Progress("error budget", 0.4);
    const GBuffer gbuffer = budget.Draw(options.guard_px);
    budget.Sao("border", "a guard band of " + std::to_string(options.guard_px) + " px", gbuffer,
               now);
    now.sampling.normals = shipped.sampling.normals;
    budget.Sao("normals",
               shipped.sampling.normals == NormalSource::kDepth ? "normals made from depth"
                                                                : "the normals as shipped",
               gbuffer, now);
    monitor.Progress("error budget", 0.8);
    now.sampling.taps = shipped.sampling.taps;
    now.sampling.taps.coarsest_level = 0;
    budget.Sao("taps", std::to_string(shipped.sampling.taps.samples) + " taps a pixel", gbuffer,
               now);
    now.sampling.taps.coarsest_level = shipped.sampling.taps.coarsest_level;
    budget.Sao("pyramid", "taps read the z pyramid", gbuffer, now);
    if (shipped.quad_filter) {
        now.quad_filter = true;
        budget.Sao("quads", "2 x 2 quads averaged", gbuffer, now);
    }
    if (shipped.pack_rgb8) {
        now.pack_rgb8 = true;
        budget.Sao("RGB8", "A and z packed into 8-bit channels", gbuffer, now);
    }
    if (shipped.blur_x) {
        now.blur_x = true;
        budget.Sao("filter x", "bilateral filter along x", gbuffer, now);
    }
    if (shipped.blur_y) {
        now.blur_y = true;
        budget.Sao("filter y", "bilateral filter along y: as shipped", gbuffer, now);
    }
    // Not a step on the way, but what the guard band saves.
    budget.Sao("no border", "as shipped, but without a guard band", budget.Draw(0), now);
    monitor.Progress("error budget", 1);
    return std::move(budget.rows);
}

}  // namespace plumb
