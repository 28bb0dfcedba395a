// What a scene's report says of its truth and of its techniques; the studies speak for themselves.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "jobs/screen_space/scene_views.h"
#include "reports/document.h"

namespace plumb {

/// Table closest; the notes of the scene.
doc::Section FindingsSection(std::span<const MeasuredView> views, const SceneScores& scores,
                             const std::vector<std::string>& notes);

/// Table views.
doc::Section TruthSection(std::span<const MeasuredView> views, double radius_m);

/// Tables techniques, rmse_by_camera, rmse_by_truth, passes, and scores: every technique, view, truth
/// and region.
doc::Section ScoresSection(std::span<const MeasuredView> views, const SceneScores& scores,
                           int rounds);

/// Of the techniques that have a picture.
doc::Section PicturesSection(const MeasuredView& first, const SceneScores& scores);

inline constexpr const char* kAllViews = "all views";

/// "cameras court and gallery"
std::string ViewsText(std::span<const MeasuredView> views);

}  // namespace plumb
