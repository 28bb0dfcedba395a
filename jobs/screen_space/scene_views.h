// What each camera of a scene says of the techniques: truth, pictures, scores.
//
// The first view has the full truth; the others are there for how much views differ, which the noise
// of a truth hardly moves (it is taken off every mean square): they have fewer rays.
#pragma once

#include <string>
#include <vector>

#include "jobs/screen_space/find_closest.h"
#include "jobs/screen_space/technique.h"
#include "jobs/truth/view_truth.h"
#include "reports/scene_report.h"
#include "score/regions.h"

namespace plumb {

struct MeasuredView {
    Camera camera;
    ViewTruth truth;
    Regions regions;
    GBuffer gbuffer;
    SceneView summary;
};

/// Throws Error if the camera sees no surface.
MeasuredView MeasureView(const Scene& scene, const Camera& camera, int guard_px,
                         const RayCaster& caster, std::span<const Falloff> falloffs,
                         const ViewTruthOptions& options, const Clock& clock, Monitor& monitor);

/// All techniques over all views: scores fill up as views are added, and then the closest is known.
class ViewBoard {
  public:
    explicit ViewBoard(std::vector<TechniqueScore>& techniques) : techniques_(techniques) {}

    /// A of a technique, by its place, in a view that is to outlive the board.
    void Add(std::size_t technique, const MeasuredView& view, Falloff falloff, Image<float> A);

    /// Once every technique has every view. Fills `scores` of all techniques.
    void Finish(std::span<const MeasuredView> views, SceneReport& report);

  private:
    std::vector<TechniqueScore>& techniques_;
    std::vector<Contestant> plain_, recalibrated_;
};

}  // namespace plumb
