// The files that a finished job leaves in its folder, each whole or not at all.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "heightfield/height_field.h"
#include "jobs/light/simulate_surface.h"
#include "jobs/light/surface.h"
#include "reports/fit_report.h"
#include "reports/simulate_report.h"

namespace plumb {

/// Pictures of a surface and its light, written to `folder` as PNG and put into the report.
void WritePictures(const std::filesystem::path& folder, const HeightField& field,
                   std::span<const double> V, SurfaceReport& report);

/// report.html, report.json, scores.csv, constants.csv, choice.csv (of four maps or more) and the
/// shader headers plumb_light.glsl, .hlsl and .h. Returns the page's path.
std::filesystem::path WriteFitResults(const std::filesystem::path& folder,
                                      const FitReport& report);

/// curves.json and constants.csv of a report of curves alone (jobs/light/fit_measured.h).
void WriteCurveResults(const std::filesystem::path& folder, const FitReport& report);

/// report.html, report.json and histogram_alpha / histogram_v as JSON and CSV. Returns the
/// page's path.
std::filesystem::path WriteSimulateResults(const std::filesystem::path& folder,
                                           const SimulateReport& report);

/// Maps of the light, one pixel a cell: light.exr with the channels height_m, alpha, V, E_0 ...
/// E_K and E(rho) of each albedo (core/total_name.h), all of them the mean of the cell's two
/// facets, so that they stand at the same place. See docs/light.md.
void WriteLightMaps(const std::filesystem::path& folder, const Surface& surface,
                    const SurfaceLight& light, const std::vector<std::vector<float>>& bounces);

/// "Stone wall 7" as part of a file name: "stone_wall_7".
std::string FileNamePart(const std::string& name);

}  // namespace plumb
