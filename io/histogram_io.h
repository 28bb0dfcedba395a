// Bounce histograms as files: JSON whole and lossless, CSV for spreadsheets and plots.
//
// JSON     every field of core/bounce_histogram.h under its own name; reading what was written
//          gives the same bits.
// CSV      one row per bin:
//              bin,low,high,count,alpha,V,E0,E0_var,E0_p05,E0_p50,E0_p95,E1,...
//          then the totals, named after their albedo: E_rho0p5,E_rho0p5_var,...
//
// Beware   A histogram without a facet has nothing to say: writing or reading one is an Error.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/bounce_histogram.h"
#include "io/csv.h"

namespace plumb {

nlohmann::ordered_json ToJson(const BounceHistogram& histogram);

/// `name` is what errors call the text. Throws Error naming field, value and rule: bins must
/// ascend without overlap, each with the same number of bounces and one total per albedo.
BounceHistogram HistogramFromJson(const nlohmann::ordered_json& json, const std::string& name);

NumberTable ToTable(const BounceHistogram& histogram);

void WriteHistogramJson(const std::filesystem::path& path, const BounceHistogram& histogram);
void WriteHistogramCsv(const std::filesystem::path& path, const BounceHistogram& histogram);
BounceHistogram ReadHistogramJson(const std::filesystem::path& path);

}  // namespace plumb
