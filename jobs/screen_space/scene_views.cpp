#include "jobs/screen_space/scene_views.h"

#include "core/error.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {

MeasuredView MeasureView(const Scene& scene, const Camera& camera, int guard_px,
                         const RayCaster& caster, std::span<const Falloff> falloffs,
                         const ViewTruthOptions& options, const RunContext& run) {
    MeasuredView view;
    view.camera = camera;
    view.guard_px = guard_px;
    view.spp = options.spp;
    const double begin_s = run.clock();
    view.truth = MeasureViewTruth(caster, scene, camera, falloffs, options, run.monitor);
    view.truth_s = run.clock() - begin_s;
    view.regions = RegionsOf(view.truth);
    if (CountOf(view.regions.seen) == 0) {
        throw Error(scene.name + ": camera " + camera.name +
                    " sees no surface: there is nothing to score");
    }
    view.gbuffer = DrawGBuffer(scene, camera, SuitedTo(scene, camera, guard_px));
    return view;
}

void ViewBoard::Add(std::size_t technique, const MeasuredView& view, Image<float> A) {
    plain_.resize(scores_.techniques.size());
    recalibrated_.resize(scores_.techniques.size());
    TechniqueScore& scored = scores_.techniques[technique];
    Image<float> recalibrated;
    scored.views.push_back({view.camera.name, ScoreAll(A, view.truth, view.regions,
                                                       scored.falloff, &recalibrated)});
    plain_[technique].pictures.push_back(std::move(A));
    recalibrated_[technique].pictures.push_back(std::move(recalibrated));
}

void ViewBoard::Finish(std::span<const MeasuredView> views) {
    std::vector<ComparedView> compared;
    for (const MeasuredView& view : views) {
        compared.push_back({&view.truth.near.at(Falloff::kHard), &view.regions.seen});
    }
    for (std::size_t t = 0; t < plain_.size(); ++t) {
        TechniqueScore& technique = scores_.techniques[t];
        technique.scores = OverViews(technique.views);
        plain_[t].name = recalibrated_[t].name = technique.name;
    }
    scores_.closest = FindClosest(plain_, compared);
    scores_.closest_recalibrated = FindClosest(recalibrated_, compared);
}

}  // namespace plumb
