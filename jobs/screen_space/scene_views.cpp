#include "jobs/screen_space/scene_views.h"

#include <cmath>

#include "core/error.h"
#include "jobs/screen_space/score_technique.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {
namespace {

double RmsError(const TruthImage& truth, const Mask& mask) {
    double squares = 0, n = 0;
    for (std::size_t p = 0; p < mask.Pixels().size(); ++p) {
        if (mask.Pixels()[p] == 0) continue;
        const double error = truth.standard_error.Pixels()[p];
        squares += error * error;
        ++n;
    }
    return n > 0 ? std::sqrt(squares / n) : 0;
}

}  // namespace

MeasuredView MeasureView(const Scene& scene, const Camera& camera, int guard_px,
                         const RayCaster& caster, std::span<const Falloff> falloffs,
                         const ViewTruthOptions& options, const Clock& clock,
                         Monitor& monitor) {
    MeasuredView view;
    view.camera = camera;
    const double begin_s = clock();
    view.truth = MeasureViewTruth(caster, scene, camera, falloffs, options, monitor);
    const double seconds = clock() - begin_s;
    view.regions = RegionsOf(view.truth);
    if (CountOf(view.regions.seen) == 0) {
        throw Error(scene.name + ": camera " + camera.name +
                    " sees no surface: there is nothing to score");
    }
    view.gbuffer = DrawGBuffer(scene, camera, SuitedTo(scene, camera, guard_px));
    view.summary = {.camera = camera.name,
                    .width_px = camera.width_px,
                    .height_px = camera.height_px,
                    .guard_px = guard_px,
                    .seen = CountOf(view.regions.seen),
                    .truth = {.spp = options.spp,
                              .nets = kTruthNets,
                              .seconds = seconds,
                              .rms_error_V = RmsError(view.truth.V, view.regions.seen),
                              .rms_error_near = RmsError(view.truth.near.at(Falloff::kHard),
                                                         view.regions.seen),
                              .lost = view.truth.lost.All(),
                              .picture_V = {},
                              .picture_near = {}}};
    return view;
}

void ViewBoard::Add(std::size_t technique, const MeasuredView& view, Falloff falloff,
                    Image<float> A) {
    plain_.resize(techniques_.size());
    recalibrated_.resize(techniques_.size());
    Image<float> recalibrated;
    ViewScores scores{view.camera.name,
                      ScoreAll(A, view.truth, view.regions, falloff, &recalibrated)};
    techniques_[technique].views.push_back(std::move(scores));
    plain_[technique].pictures.push_back(std::move(A));
    recalibrated_[technique].pictures.push_back(std::move(recalibrated));
}

void ViewBoard::Finish(std::span<const MeasuredView> views, SceneReport& report) {
    std::vector<ComparedView> compared;
    for (const MeasuredView& view : views) {
        compared.push_back({&view.truth.near.at(Falloff::kHard), &view.regions.seen});
    }
    for (std::size_t t = 0; t < techniques_.size(); ++t) {
        techniques_[t].scores = OverViews(techniques_[t].views);
        plain_[t].name = recalibrated_[t].name = techniques_[t].name;
    }
    report.closest = FindClosest(plain_, compared);
    report.closest_recalibrated = FindClosest(recalibrated_, compared);
}

}  // namespace plumb
