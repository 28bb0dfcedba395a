#include "jobs/score/score_sections.h"

#include <cmath>

#include "core/names.h"
#include "reports/render.h"

namespace plumb {
namespace {

using doc::Better;
using doc::Cell;
using doc::Role;

const doc::Column kCandidate{.key = "candidate", .title = "Candidate", .role = Role::kName};

std::string Number(double value, int digits = 3) {
    return doc::CellText({.key = "n", .title = "", .digits = digits}, value);
}

std::string NamesOf(const std::vector<CandidateScore>& scores,
                    const std::vector<std::size_t>& places) {
    std::vector<std::string> names;
    for (const std::size_t k : places) names.push_back(scores[k].name);
    return Joined(names);
}

/// A number that was not taken is a dash.
Cell OrNothing(const Measured& figure) {
    return std::isnan(figure.value) ? Cell{} : Cell{figure};
}

doc::Table ErrorTable(const std::vector<CandidateScore>& scores, const Compared& compared) {
    doc::Table table{
        .key = "errors",
        .title = "Errors",
        .caption =
            "After ± one standard error, from the scatter of the picture's tiles; JSON and CSV "
            "hold the 95 % intervals.",
        .columns = {kCandidate,
                    {.key = "bias",
                     .title = "Bias",
                     .better = Better::kNearZero,
                     .meaning = "mean c - t"},
                    {.key = "mae",
                     .title = "MAE",
                     .better = Better::kLess,
                     .meaning = "mean |c - t|, the reference's noise included"},
                    {.key = "mse",
                     .title = "MSE",
                     .better = Better::kLess,
                     .meaning = "mean (c - t)^2, corrected for noise in the reference"},
                    {.key = "max",
                     .title = "Max",
                     .better = Better::kLess,
                     .meaning = "greatest |c - t|"},
                    {.key = "max_at_least",
                     .title = "at least",
                     .meaning = "some pixel is off by this, with 95 % confidence"},
                    {.key = "max_column", .title = "at x"},
                    {.key = "max_row", .title = "y"}}};
    for (const CandidateScore& s : scores) {
        table.Add({s.name, s.errors.bias, s.errors.mae, s.errors.mse, s.errors.max,
                   s.errors.max_at_least, std::int64_t(compared.x + s.errors.max_column),
                   std::int64_t(compared.y + s.errors.max_row)});
    }
    return table;
}

doc::Table QuantileTable(const std::vector<CandidateScore>& scores) {
    doc::Table table{.key = "quantiles",
                     .title = "How many pixels are how wrong",
                     .caption = "The share of all |c - t| that a column names is no greater.",
                     .columns = {kCandidate,
                                 {.key = "p50", .title = "50 %", .better = Better::kLess},
                                 {.key = "p90", .title = "90 %", .better = Better::kLess},
                                 {.key = "p99", .title = "99 %", .better = Better::kLess},
                                 {.key = "p999", .title = "99.9 %", .better = Better::kLess}}};
    for (const CandidateScore& s : scores) {
        table.Add({s.name, s.quantiles[0], s.quantiles[1], s.quantiles[2], s.quantiles[3]});
    }
    return table;
}

doc::Table RelativeTable(const std::vector<CandidateScore>& scores) {
    doc::Table table{.key = "relative",
                     .title = "Relative errors",
                     .caption =
                         "Means of the formula; d = c - t, and d^2 is corrected for noise in "
                         "the reference.",
                     .columns = {kCandidate,
                                 {.key = "figure", .title = "Figure", .role = Role::kName},
                                 {.key = "value", .title = "Value", .better = Better::kLess},
                                 {.key = "formula", .title = "Formula"},
                                 {.key = "users", .title = "Whose"}}};
    for (const CandidateScore& s : scores) {
        for (std::size_t k = 0; k < RelativeForms().size(); ++k) {
            const RelativeForm& form = RelativeForms()[k];
            table.Add({s.name, form.key, s.relative[k], form.formula, form.users});
        }
    }
    return table;
}

doc::Table WorstTable(const std::vector<CandidateScore>& scores, const Compared& compared) {
    doc::Table table{
        .key = "worst_tile",
        .title = "The worst tile of " + std::to_string(kWorstTile_px) + " x " +
                 std::to_string(kWorstTile_px) + " pixels",
        .caption =
            "*At least*: some tile is so wrong with 95 % confidence, the noise of the "
            "reference and the number of tiles allowed for.",
        .columns = {kCandidate,
                    {.key = "rmse", .title = "RMSE", .better = Better::kLess},
                    {.key = "rmse_at_least", .title = "at least", .better = Better::kLess},
                    {.key = "column_px", .title = "x", .unit = "px"},
                    {.key = "row_px", .title = "y", .unit = "px"},
                    {.key = "tiles", .title = "of tiles"}}};
    const auto root = [](double mse) { return std::sqrt(std::max(0.0, mse)); };
    for (const CandidateScore& s : scores) {
        table.Add({s.name, root(s.worst.mse), root(s.worst.mse_at_least),
                   std::int64_t(compared.x + s.worst.column_px),
                   std::int64_t(compared.y + s.worst.row_px), std::int64_t(s.worst.tiles)});
    }
    return table;
}

doc::Table FlipTable(const std::vector<CandidateScore>& scores) {
    doc::Table table{
        .key = "flip",
        .title = "FLIP",
        .caption = "Weighted quantiles count a pixel as often as it is wrong.",
        .columns = {kCandidate,
                    {.key = "mean", .title = "Mean", .better = Better::kLess},
                    {.key = "weighted_25", .title = "weighted 25 %", .better = Better::kLess},
                    {.key = "weighted_50", .title = "50 %", .better = Better::kLess},
                    {.key = "weighted_75", .title = "75 %", .better = Better::kLess},
                    {.key = "max", .title = "Max", .better = Better::kLess}}};
    for (const CandidateScore& s : scores) {
        if (s.flip_quantiles.empty()) continue;
        table.Add({s.name, s.flip, s.flip_quantiles[0], s.flip_quantiles[1],
                   s.flip_quantiles[2], s.flip_quantiles[3]});
    }
    return table;
}

}  // namespace

doc::Section VerdictSection(const std::vector<CandidateScore>& scores, const Ranking& ranking) {
    doc::Section section{.id = "verdict", .title = "Scores"};
    const std::size_t best = ranking.order.front();
    if (scores.size() > 1) {
        const std::vector<std::size_t> ties = ranking.TiesOf(best);
        section.sentences.push_back(
            "Closest by its squared error: *" + doc::Verbatim(scores[best].name) + "*, RMSE " +
            Number(scores[best].errors.rmse.value) +
            (ties.empty() ? ", of which the paired test is sure."
                          : "; it ties with " + doc::Verbatim(NamesOf(scores, ties)) +
                                " by the paired test."));
    }
    doc::Table table{
        .key = "scores",
        .columns = {{.key = "rank",
                     .title = "Rank",
                     .meaning = "1 + the number of those that surely beat it"},
                    kCandidate,
                    {.key = "rmse", .title = "RMSE", .better = Better::kLess},
                    {.key = "psnr", .title = "PSNR", .unit = "dB", .better = Better::kMore},
                    {.key = "ssim", .title = "SSIM", .better = Better::kMore},
                    {.key = "flip", .title = "FLIP", .better = Better::kLess},
                    {.key = "ties_with", .title = "Ties with"}},
        .judged = scores.size() > 1};
    for (const std::size_t k : ranking.order) {
        const CandidateScore& s = scores[k];
        const std::string ties = NamesOf(scores, ranking.TiesOf(k));
        table.Add({std::int64_t(ranking.rank[k]), s.name, s.errors.rmse, s.psnr_db,
                   OrNothing(s.ssim), OrNothing(s.flip), ties.empty() ? Cell{} : Cell{ties}});
    }
    section.tables.push_back(std::move(table));
    return section;
}

doc::Section FiguresSection(const std::vector<CandidateScore>& scores,
                            const Compared& compared) {
    doc::Section section{.id = "figures", .title = "Every figure"};
    section.tables = {ErrorTable(scores, compared), QuantileTable(scores),
                      RelativeTable(scores), WorstTable(scores, compared)};
    doc::Table flip = FlipTable(scores);
    if (!flip.rows.empty()) section.tables.push_back(std::move(flip));
    return section;
}

doc::Section PairsSection(const std::vector<CandidateScore>& scores, const Ranking& ranking) {
    doc::Section section{.id = "pairs", .title = "Pair by pair"};
    if (ranking.pairs.empty()) return section;
    doc::Table table{
        .key = "pairs",
        .caption =
            "MSE of the first less that of the second, on the same pixels; the level of the "
            "intervals is shared among all pairs. An interval that holds 0 is a tie.",
        .columns = {{.key = "first", .title = "First", .role = Role::kName},
                    {.key = "second", .title = "Second", .role = Role::kName},
                    {.key = "difference", .title = "Difference of the MSE"},
                    {.key = "verdict", .title = "Verdict"}}};
    for (const RankedPair& pair : ranking.pairs) {
        table.Add({scores[pair.first].name, scores[pair.second].name, pair.difference,
                   std::string(pair.tie ? "tie" : "first is closer")});
    }
    section.tables.push_back(std::move(table));
    return section;
}

doc::Section MethodSection(const std::vector<CandidateScore>& scores, const Compared& compared,
                           bool hdr_flip, const FigureOptions& options) {
    doc::Section section{.id = "method", .title = "What was compared", .listed = true};
    std::vector<std::string>& say = section.sentences;
    say.push_back(compared.encoding);
    say.push_back("Channels: " + doc::Verbatim(Joined(compared.channel_names)) + ".");
    section.facts.push_back(
        {{.key = "pixels", .title = "Pixels that count"}, compared.counted});
    if (compared.skipped > 0) {
        say.push_back(
            std::to_string(compared.skipped) +
            " pixels are left out, as `--bad-pixels skip` says: they are not finite.");
    }
    say.push_back("Peak of PSNR: " + Number(options.peak, 6) + ".");
    if (!compared.in_unit)
        say.push_back("No SSIM: it is defined for data in [0, 1], and some lie outside.");
    if (!compared.standard_error.empty()) {
        say.push_back(
            "The reference brings its standard errors. Their squares are taken off MSE, "
            "RMSE, PSNR, SSIM and relative errors of squares; bias needs no correction; "
            "MAE, quantiles, the maximum and FLIP contain the noise.");
        section.facts.push_back(
            {{.key = "reference_rms_error", .title = "RMS standard error of the reference"},
             std::sqrt(scores[0].errors.truth_variance)});
    }
    for (const ComparedPicture& picture : compared.candidates) {
        if (picture.negative > 0)
            say.push_back(doc::Verbatim(picture.name) + ": " +
                          std::to_string(picture.negative) +
                          " numbers are negative; FLIP takes them as 0.");
    }
    if (options.flip == FlipMode::kNone) return section;
    say.push_back("FLIP at " + Number(options.pixels_per_degree, 4) + " pixels a degree, " +
                  (hdr_flip ? "of high dynamic range." : "of values clamped to [0, 1]."));
    if (!hdr_flip) return section;
    if (!scores[0].exposures) {
        say.push_back("No FLIP: the reference is black, and no exposure shows it.");
        return section;
    }
    const ToneExposures& e = *scores[0].exposures;
    say.push_back("Exposures: " + std::to_string(e.count) + " from " +
                  Number(e.start_stops, 4) + " to " + Number(e.stop_stops, 4) +
                  " stops, with the curve " + ToneCurveNames()[std::size_t(options.curve)] +
                  ".");
    if (e.median_of_positive)
        say.push_back(
            "The reference's median luminance is 0: the median of its positive ones is "
            "taken.");
    return section;
}

}  // namespace plumb
