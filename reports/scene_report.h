// What a scene's report says: screen-space techniques against a path-traced truth, and what each
// step of them costs, as one JSON document, two tables for spreadsheets and one page.
//
// Pure: the same values give the same bytes. What is in seconds differs from run to run.
//
// Symbols  A obscurance of a technique; V, r as in core/conventions.h; all errors unitless.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "reports/z_precision_report.h"
#include "score/errors.h"
#include "score/temporal.h"

namespace plumb {

/// One picture against one truth.
struct ScoreAgainst {
    std::string truth;   ///< "V", "V within r", "V within r, weighted"
    std::string region;  ///< "whole", "edges", "interiors", "border"
    ErrorScore error;
    Figure ssim;
    Figure recalibrated_rmse;  ///< Held out: after the best monotone change of contrast.
};

struct PassSeconds {
    std::string name;
    double seconds = 0;  ///< Median over the rounds.
};

struct TechniqueScore {
    std::string name;
    std::string falloff;  ///< "hard", "linear", "sao", "quadratic", "far end"
    int samples = 0;      ///< Depth lookups or rays a pixel.
    std::vector<PassSeconds> passes;
    double seconds = 0;
    std::vector<ScoreAgainst> scores;
    std::string picture, signed_error;  ///< Data URIs; empty = not shown.

    /// The score against that truth over that region; throws Error if there is none.
    const ScoreAgainst& Against(const std::string& truth,
                                const std::string& region = "whole") const;
};

/// One step from the ideal to the shipped.
struct BudgetRow {
    std::string step;
    std::string what;         ///< One sentence.
    ScoreAgainst score;       ///< Against V within r, weighted by the technique's own falloff.
    double rms_change = 0;    ///< Of the picture, against the step before.
    double seconds = 0;       ///< Of one picture.
    std::int64_t pixels = 0;  ///< Scored.
};

/// One way to make the z pyramid: [McGuire12] table 1.
struct PyramidRow {
    std::string filter;
    Figure bias_to_none, rms_to_none;  ///< Of A before any filter, against A without a pyramid.
    ScoreAgainst against_truth;
};

/// One width of the border that is drawn but not shown.
struct GuardRow {
    double share = 0;  ///< Of the picture's height.
    int guard_px = 0;
    Figure rms_to_widest;  ///< Of A near the frame, against A with the widest border.
    ScoreAgainst border;   ///< Near the frame, against V within r, weighted.
    double draw_s = 0, sao_s = 0;
};

/// One setting of one technique.
struct SweepPoint {
    std::string technique, setting;
    double seconds = 0;
    double rmse = 0, recalibrated_rmse = 0;  ///< Against V within r.
    bool on_front = false;                   ///< No other is both faster and better.
};

/// SAO pass by pass at one size of picture: [McGuire12] tables 2 and 3.
struct PassTimes {
    std::string technique;
    int width_px = 0, height_px = 0, guard_px = 0;
    std::vector<PassSeconds> passes;
    double seconds = 0;
    double bytes_per_pixel = 0;  ///< Read and written at least, of the drawn picture.
    double ns_per_visible = 0;   ///< Per pixel that shows a surface.
    double copies = 0;           ///< Time over that of copying those bytes, same run.
};

/// Sampling time against radius: [McGuire12] figure 5.
struct RadiusTime {
    double radius_m = 0;
    double with_pyramid_s = 0, without_pyramid_s = 0, alchemy_s = 0;
};

struct TemporalRow {
    std::string technique;
    TemporalScore score;
};

struct SceneTruth {
    int spp = 0, nets = 0;
    double seconds = 0;
    double rms_error_V = 0, rms_error_near = 0;  ///< Root mean square standard errors.
    std::int64_t lost = 0;
    std::string picture_V, picture_near;
};

struct SceneReport {
    std::string tool_version, command;
    std::string scene, scene_sha256, camera;
    int width_px = 0, height_px = 0, guard_px = 0, threads = 0;
    std::uint64_t seed = 1;
    double radius_m = 0;
    std::int64_t triangles = 0, pixels = 0, seen = 0;
    std::vector<std::string> notes;

    SceneTruth truth;
    double raster_s = 0;                ///< One G-buffer.
    double embree_rays_per_second = 0;  ///< Bare occlusion rays of this machine, same run.
    double copy_bytes_per_second = 0;

    std::vector<TechniqueScore> techniques;
    std::string budget_technique;
    std::vector<BudgetRow> budget;
    std::vector<PyramidRow> pyramids;
    std::vector<GuardRow> guards;
    std::vector<SweepPoint> sweep;
    std::string cheapest;  ///< Of the sweep: the fastest within `cheapest_within` of the least.
    double cheapest_within = 0.05;
    std::vector<PassTimes> times;
    std::vector<RadiusTime> radii;
    std::vector<TemporalRow> temporal;
    int temporal_frames = 0;
    std::optional<ZPrecisionReport> precision;  ///< [McGuire12] figures 3 and 4.
};

std::string ToJsonText(const SceneReport& report);
std::string ScoresCsv(const SceneReport& report);  ///< One line a technique, truth, region.
std::string SweepCsv(const SceneReport& report);
std::string ToHtml(const SceneReport& report);
void WriteTable(std::ostream& out, const SceneReport& report);

}  // namespace plumb
