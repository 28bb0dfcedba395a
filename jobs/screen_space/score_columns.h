// What a report says of a score, as columns of a table.
#pragma once

#include <set>
#include <string>

#include "jobs/screen_space/score_technique.h"
#include "reports/columns.h"

namespace plumb {

/// Adds the columns pixels, bias, mae, mae_noise_bias, mse, rmse, psnr_db, psnr_paper_db, max,
/// max_at_least, ssim, recalibrated_rmse, their keys behind `prefix`, their titles behind `of`.
/// People see those of `shown`; the others are details.
void AddScoreColumns(doc::Table& table, const std::set<std::string>& shown,
                     const std::string& prefix = {}, const std::string& of = {});

/// Adds the cells, in the same order.
void AddScore(const ScoreAgainst& score, std::vector<doc::Cell>& row);

/// A column of RMSE, as everywhere; the same with another key and title.
doc::Column RmseColumn(std::string key = "rmse", std::string title = "RMSE");

}  // namespace plumb
