#include "jobs/screen_space/score_columns.h"

namespace plumb {
namespace {

using doc::Better;

struct Field {
    doc::Column column;
    doc::Cell (*cell)(const ScoreAgainst&);
};

const std::vector<Field>& Fields() {
    static const std::vector<Field> fields{
        {{.key = "pixels", .title = "Pixels"},
         [](auto& s) -> doc::Cell { return s.error.pixels; }},
        {{.key = "bias",
          .title = "Bias",
          .better = Better::kNearZero,
          .meaning = "Mean of A - V"},
         [](auto& s) -> doc::Cell { return s.error.bias; }},
        {{.key = "mae", .title = "MAE", .better = Better::kLess, .meaning = "Mean of |A - V|"},
         [](auto& s) -> doc::Cell { return s.error.mae; }},
        {{.key = "mae_noise_bias",
          .title = "MAE from noise",
          .meaning = "Noise in the reference raised the MAE by this at most"},
         [](auto& s) -> doc::Cell { return s.error.mae_noise_bias; }},
        {{.key = "mse",
          .title = "MSE",
          .better = Better::kLess,
          .meaning = "Corrected for noise in the reference",
          .interval = true},
         [](auto& s) -> doc::Cell { return s.error.mse; }},
        {RmseColumn(), [](auto& s) -> doc::Cell { return s.error.rmse; }},
        {{.key = "psnr_db",
          .title = "PSNR",
          .unit = "dB",
          .digits = 4,
          .better = Better::kMore,
          .meaning = "10 log10(1 / MSE)",
          .interval = true},
         [](auto& s) -> doc::Cell { return s.error.psnr_db; }},
        {{.key = "psnr_paper_db",
          .title = "PSNR, as papers print it",
          .unit = "dB",
          .digits = 4,
          .better = Better::kMore,
          .meaning = "10 log10(255^2 / MSE): 48.13 dB more",
          .interval = true},
         [](auto& s) -> doc::Cell { return s.error.psnr_paper_db; }},
        {{.key = "max", .title = "Greatest error", .meaning = "Its noise included"},
         [](auto& s) -> doc::Cell { return s.error.max; }},
        {{.key = "max_at_least",
          .title = "Greatest, at least",
          .meaning = "Some pixel is off by this at least"},
         [](auto& s) -> doc::Cell { return s.error.max_at_least; }},
        {{.key = "ssim",
          .title = "SSIM",
          .better = Better::kMore,
          .meaning = "[Wang04]",
          .interval = true},
         [](auto& s) -> doc::Cell { return s.ssim; }},
        {RmseColumn("recalibrated_rmse", "Recalibrated RMSE"),
         [](auto& s) -> doc::Cell { return s.recalibrated_rmse; }}};
    return fields;
}

}  // namespace

void AddScoreColumns(doc::Table& table, const std::set<std::string>& shown,
                     const std::string& prefix, const std::string& of) {
    for (const Field& field : Fields()) {
        doc::Column column = field.column;
        column.detail = !shown.contains(column.key);
        column.key = prefix + column.key;
        column.title = of + column.title;
        table.columns.push_back(std::move(column));
    }
}

void AddScore(const ScoreAgainst& score, std::vector<doc::Cell>& row) {
    for (const Field& field : Fields()) row.push_back(field.cell(score));
}

doc::Column RmseColumn(std::string key, std::string title) {
    return {.key = std::move(key),
            .title = std::move(title),
            .better = Better::kLess,
            .meaning = "Root of the mean square error, corrected for noise in the reference",
            .interval = true};
}

}  // namespace plumb
