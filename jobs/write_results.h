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

namespace plumb {

/// Pictures of a surface and its light, written to `folder` as PNG and put into the report.
void WritePictures(const std::filesystem::path& folder, const HeightField& field,
                   std::span<const double> V, SurfaceReport& report);

/// constants.csv and, but for a report of curves alone (jobs/light/fit_measured.h), scores.csv,
/// choice.csv (of four maps or more) and the shader headers plumb_light.glsl, .hlsl and .h.
/// `document` is that of the report.
void WriteFitTables(const std::filesystem::path& folder, const FitReport& report,
                    const doc::Document& document);

/// histogram_alpha and histogram_v as JSON and CSV.
void WriteHistograms(const std::filesystem::path& folder, const SurfaceReport& surface);

/// Maps of the light, one pixel a cell: light.exr with the channels height_m, alpha, V, E_0 ...
/// E_K and E(rho) of each albedo (core/total_name.h), all of them the mean of the cell's two
/// facets, so that they stand at the same place. See docs/light.md.
void WriteLightMaps(const std::filesystem::path& folder, const Surface& surface,
                    const SurfaceLight& light, const std::vector<std::vector<float>>& bounces);

/// "Stone wall 7" as part of a file name: "stone_wall_7"; short enough for a file system.
std::string FileNamePart(const std::string& name);

}  // namespace plumb
