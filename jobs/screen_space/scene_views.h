// What each camera of a scene says of the techniques: truth, pictures, scores.
//
// The first view has the full truth; the others are there for how much views differ, which the noise
// of a truth hardly moves (it is taken off every mean square): they have fewer rays.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/run_context.h"
#include "jobs/screen_space/find_closest.h"
#include "jobs/screen_space/score_technique.h"
#include "jobs/screen_space/time_techniques.h"

namespace plumb {

struct MeasuredView {
    Camera camera;
    int guard_px = 0;
    int spp = 0;         ///< Rays a pixel of the truth.
    double truth_s = 0;  ///< That it took.
    ViewTruth truth;
    Regions regions;
    GBuffer gbuffer;
};

/// Throws Error if the camera sees no surface.
MeasuredView MeasureView(const Scene& scene, const Camera& camera, int guard_px,
                         const RayCaster& caster, std::span<const Falloff> falloffs,
                         const ViewTruthOptions& options, const RunContext& run);

/// A technique in all views.
struct TechniqueScore {
    std::string name;
    Falloff falloff = Falloff::kHard;
    int samples = 0;                        ///< Depth lookups or rays a pixel.
    TimedTechnique timed;                   ///< Of the first view.
    std::vector<ScoreAgainst> scores = {};  ///< Over all views alike (score/over_views.h).
    std::vector<ViewScores> views = {};     ///< In their order.
    std::string picture, signed_error;  ///< Data URIs, of the first view; empty = not shown.
};

struct SceneScores {
    std::vector<TechniqueScore> techniques;
    Closest closest, closest_recalibrated;  ///< To V within r, over all views.
};

/// All techniques over all views: scores fill up as views are added, and then the closest is known.
class ViewBoard {
  public:
    explicit ViewBoard(SceneScores& scores) : scores_(scores) {}

    /// A of a technique, by its place, in a view that is to outlive the board.
    void Add(std::size_t technique, const MeasuredView& view, Image<float> A);

    /// Once every technique has every view.
    void Finish(std::span<const MeasuredView> views);

  private:
    SceneScores& scores_;
    std::vector<Contestant> plain_, recalibrated_;
};

}  // namespace plumb
