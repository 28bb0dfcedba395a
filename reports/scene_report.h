// What a scene's report says: screen-space techniques against a path-traced truth, and what each
// step of them costs, as one JSON document, two tables for spreadsheets and one page.
//
// Pure: the same values give the same bytes. What is in seconds differs from run to run.
//
// Symbols  A obscurance of a technique; V, r as in core/conventions.h; all errors unitless. Times
//          are medians, with the least and the greatest of the rounds (core/time_in_turns.h).
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "core/measured.h"
#include "reports/z_precision_report.h"
#include "score/errors.h"
#include "score/temporal.h"

namespace plumb {

/// One picture against one truth.
struct ScoreAgainst {
    std::string truth;   ///< "V", "V within r", "V within r, weighted"
    std::string region;  ///< "whole", "edges", "interiors", "border"
    ErrorScore error;
    Measured ssim;
    Measured recalibrated_rmse;  ///< Held out: after the best monotone change of contrast.
};

/// The score against that truth over that region; throws Error if there is none.
const ScoreAgainst& Against(const std::vector<ScoreAgainst>& scores, const std::string& truth,
                            const std::string& region);

struct PassSeconds {
    std::string name;
    Measured seconds;
};

/// What one camera says.
struct ViewScores {
    std::string camera;
    std::vector<ScoreAgainst> scores;
};

struct TechniqueScore {
    std::string name;
    std::string falloff;  ///< "hard", "linear", "sao", "quadratic", "far end"
    int samples = 0;      ///< Depth lookups or rays a pixel.
    std::vector<PassSeconds> passes;
    Measured seconds;
    std::vector<ScoreAgainst> scores;   ///< Over all views alike (score/over_views.h).
    std::vector<ViewScores> views;      ///< In the order of SceneReport::views.
    std::string picture, signed_error;  ///< Data URIs, of the first view; empty = not shown.

    /// The score against that truth over that region; throws Error if there is none.
    const ScoreAgainst& Against(const std::string& truth,
                                const std::string& region = "whole") const;
};

/// The technique or setting with the least MSE, and those that are not told apart from it: the
/// interval of the difference in MSE, paired view by view and pixel by pixel, holds 0.
struct Closest {
    std::string name;
    std::vector<std::string> ties;
};

/// One step from the ideal to the shipped.
struct BudgetRow {
    std::string step;
    std::string what;                 ///< One sentence.
    ScoreAgainst score;               ///< Against V within r.
    ScoreAgainst weighted;            ///< The same weighted by the technique's own falloff.
    double rms_change = 0;            ///< Of the picture, against the step before.
    std::optional<Measured> seconds;  ///< Of one whole picture, where one is made.
};

/// One way to make the z pyramid: [McGuire12] table 1.
struct PyramidRow {
    std::string filter;
    Measured bias_to_none,
        rms_to_none;  ///< Of A before any filter, against A without a pyramid.
    ScoreAgainst against_truth;
};

/// One width of the border that is drawn but not shown.
struct GuardRow {
    double share = 0;  ///< Of the picture's height.
    int guard_px = 0;
    Measured rms_to_widest;  ///< Of A near the frame, against A with the widest border.
    ScoreAgainst border;     ///< Near the frame, against V within r, weighted.
    Measured draw_s, sao_s;
};

/// One setting of one technique.
struct SweepPoint {
    std::string technique, setting;
    Measured seconds;
    Measured rmse, recalibrated_rmse;  ///< Against V within r, of the first view.
    bool on_front = false;             ///< No other is both faster and better.
};

/// What a pass reads and writes, each datum once.
struct PassBytes {
    std::string name;
    double read = 0, written = 0;
};

/// SAO pass by pass at one size of picture: [McGuire12] tables 2 and 3.
struct PassTimes {
    std::string technique;
    int width_px = 0, height_px = 0, guard_px = 0;
    std::vector<PassSeconds> passes;
    Measured seconds;
    std::vector<PassBytes> traffic;
    double bytes_per_pixel = 0;  ///< All of `traffic`, by the pixels shown.
    double ns_per_visible = 0;   ///< By the pixels shown: the border is not visible.
    double copies = 0;           ///< Time over that of copying those bytes, same run.
};

/// Sampling time against radius: [McGuire12] figure 5.
struct RadiusTime {
    double radius_m = 0;
    Measured with_pyramid_s, without_pyramid_s, alchemy_s;
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

/// One camera. Of several the first has the times, the pictures and the studies.
struct SceneView {
    std::string camera;
    int width_px = 0, height_px = 0, guard_px = 0;
    std::int64_t seen = 0;  ///< Pixels that show a surface.
    SceneTruth truth;
};

struct SceneReport {
    std::string tool_version, command;
    std::string scene, scene_sha256;
    int threads = 0, rounds = 0;
    std::uint64_t seed = 1;
    double radius_m = 0;
    std::int64_t triangles = 0;
    std::vector<std::string> notes;

    std::vector<SceneView> views;     ///< At least one.
    Measured raster_s;                ///< One G-buffer.
    Measured embree_rays_per_second;  ///< Bare occlusion rays of this machine, same run.
    Measured copy_bytes_per_second;

    std::vector<TechniqueScore> techniques;
    Closest closest, closest_recalibrated;  ///< To V within r, over all views.
    std::string budget_technique;
    int budget_taps = 0;             ///< In place of an integral.
    std::int64_t budget_pixels = 0;  ///< Scored.
    std::vector<BudgetRow> budget;
    std::optional<BudgetRow> no_border;  ///< The last step without a guard band.
    std::vector<PyramidRow> pyramids;
    std::vector<GuardRow> guards;
    std::vector<SweepPoint> sweep;
    Closest
        cheapest;  ///< Of the sweep: the fastest within `cheapest_within` of the least RMSE.
    double cheapest_within = 0.05;
    std::vector<PassTimes> times;
    std::vector<RadiusTime> radii;
    int radii_width_px = 0, radii_height_px = 0;
    std::vector<TemporalRow> temporal;
    int temporal_frames = 0;
    std::optional<ZPrecisionReport> precision;  ///< [McGuire12] figures 3 and 4.
};

std::string ToJsonText(const SceneReport& report);

/// One line a technique, view, truth and region; the view kAllViews first.
std::string ScoresCsv(const SceneReport& report);
std::string SweepCsv(const SceneReport& report);
std::string ToHtml(const SceneReport& report);
void WriteTable(std::ostream& out, const SceneReport& report);

inline constexpr const char* kAllViews = "all views";

/// "gtao (not told apart from it: hbao and bitmask)"
std::string WithTies(const Closest& closest);

/// "cameras court and gallery"
std::string ViewsText(const SceneReport& report);

/// "0.119 (0.102 to 0.134)": value and interval, as many digits.
std::string WithInterval(const Measured& figure, int significant = 3, double scale = 1);

}  // namespace plumb
