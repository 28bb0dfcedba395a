// The score tables of a fit report: formulas x criteria, then formulas x maps.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "reports/fit_report_page.h"
#include "reports/fit_report_parts.h"
#include "reports/page.h"
#include "reports/text.h"

namespace plumb::page {
namespace {

/// Errors of [least, most] to [0, 1] by their logarithm: a factor is a factor.
class Heat {
  public:
    void Take(double error) {
        if (!(error > 0) || !std::isfinite(error)) return;
        least_ = std::min(least_, error);
        most_ = std::max(most_, error);
    }

    std::string operator()(double error) const {
        if (!std::isfinite(error) || !(most_ > least_)) return {};
        return HeatColor(error > 0 ? std::log(error / least_) / std::log(most_ / least_) : 0);
    }

  private:
    double least_ = std::numeric_limits<double>::infinity(), most_ = 0;
};

std::string NameCss(const FitReport& report, const std::string& name) {
    return name == report.recommended ? "ours" : name == report.published ? "published" : "";
}

Cell ErrorCell(double error, const Heat& heat, double best) {
    return {Digits(error), error == best ? "best" : "", heat(error)};
}

double Least(const std::vector<double>& errors) {
    double least = std::numeric_limits<double>::infinity();
    for (const double error : errors)
        if (std::isfinite(error)) least = std::min(least, error);
    return least;
}

/// The score on maps not fitted to. A formula that was not fitted has never seen any; of a
/// fitted one without held-out scores it is not known.
Score HeldOut(const FormulaRecord& record) {
    if (record.held_out) return record.held_out->pooled;
    if (!record.fitted) return record.in_sample.pooled;
    return {.rms = SurfaceFigures::kUnknown, .max_abs = SurfaceFigures::kUnknown};
}

std::string Summary(const FitReport& report) {
    Heat heat;
    std::vector<double> rms, held_out, facet;
    for (const FormulaRecord& record : report.formulas) {
        rms.push_back(record.in_sample.pooled.rms);
        held_out.push_back(HeldOut(record).rms);
        facet.push_back(parts::PooledFacetRms(record));
        heat.Take(rms.back());
        heat.Take(held_out.back());
        heat.Take(facet.back());
    }
    std::vector<std::vector<Cell>> rows;
    for (std::size_t i = 0; i < report.formulas.size(); ++i) {
        const FormulaRecord& record = report.formulas[i];
        const Score& score = record.in_sample.pooled;
        const std::string inputs = parts::Inputs(record.formula.model, ", ");
        const std::string reads = inputs == "alpha" ? "α" : inputs == "V" ? "V" : "α, V";
        rows.push_back(
            {{Html(record.name), NameCss(report, record.name), ""},
             {reads, "", ""},
             {record.fitted ? std::to_string(record.formula.values.size()) : "–", "faint", ""},
             ErrorCell(rms[i], heat, Least(rms)),
             ErrorCell(held_out[i], heat, Least(held_out)),
             ErrorCell(facet[i], heat, Least(facet)),
             {Digits(score.max_abs), "", ""},
             {Digits(HeldOut(record).max_abs), "", ""},
             {Count(score.poles), score.poles ? "best" : "faint", ""},
             {Count(score.out_of_range), score.out_of_range ? "best" : "faint", ""}});
    }
    return Table({{"formula"},
                  {"reads", true},
                  {"constants fitted"},
                  {"RMS [–]"},
                  {"RMS held out [–]"},
                  {"RMS a facet [–]"},
                  {"worst bin [–]"},
                  {"worst bin held out [–]"},
                  {"samples not finite"},
                  {"samples outside [0, 1]"}},
                 rows);
}

using PerMap = std::function<double(const FormulaRecord&, std::size_t map)>;

std::string ByMap(const FitReport& report, const PerMap& error,
                  const std::vector<std::vector<Cell>>& footer) {
    Heat heat;
    std::vector<double> best(report.maps.size(), std::numeric_limits<double>::infinity());
    for (const FormulaRecord& record : report.formulas)
        for (std::size_t m = 0; m < report.maps.size(); ++m) {
            const double e = error(record, m);
            heat.Take(e);
            if (std::isfinite(e)) best[m] = std::min(best[m], e);
        }
    std::vector<Head> head{{"formula"}};
    for (const SurfaceReport& map : report.maps) head.push_back({map.name});
    std::vector<std::vector<Cell>> rows;
    for (const FormulaRecord& record : report.formulas) {
        std::vector<Cell> row{{Html(record.name), NameCss(report, record.name), ""}};
        for (std::size_t m = 0; m < report.maps.size(); ++m)
            row.push_back(ErrorCell(error(record, m), heat, best[m]));
        rows.push_back(std::move(row));
    }
    rows.insert(rows.end(), footer.begin(), footer.end());
    return Table(head, rows);
}

std::vector<std::vector<Cell>> FloorRows(const FitReport& report) {
    std::vector<std::vector<Cell>> rows;
    if (report.floors.empty()) return rows;
    const auto add = [&](const char* name, double Floors::*floor) {
        std::vector<Cell> row{{name, "faint", ""}};
        for (const Floors& floors : report.floors)
            row.push_back({Digits(floors.*floor), "faint", ""});
        rows.push_back(std::move(row));
    };
    add("floor of any function of α", &Floors::of_alpha);
    add("floor of any function of V", &Floors::of_V);
    add("floor of any function of both", &Floors::of_both);
    return rows;
}

struct Tab {
    std::string title, html;
};

std::string Tabs(const std::vector<Tab>& tabs) {
    std::string html = "<div class=\"tabs\">\n";
    for (std::size_t i = 0; i < tabs.size(); ++i) {
        const std::string id = "scores-" + std::to_string(i);
        html += "<input type=\"radio\" name=\"scores\" id=\"" + id + "\"" +
                (i == 0 ? " checked" : "") + "><label for=\"" + id + "\">" + tabs[i].title +
                "</label>\n";
    }
    for (const Tab& tab : tabs)
        html += "<div class=\"tab\"><h4>" + tab.title + "</h4>\n" + tab.html + "</div>\n";
    return html + "</div>\n";
}

}  // namespace

std::string Scores(const FitReport& report) {
    std::string html =
        "<p>Root mean square and worst error of E(ρ) over bins and albedos, every map the same "
        "say. <b>Held out</b>: each map is scored by constants fitted to the other maps only; "
        "a "
        "formula with no fitted constant has never seen any, and its figure is the same. <b>A "
        "facet</b>: the error of "
        "single facets, with the scatter that no bin mean shows. Darker is worse; the best of "
        "a "
        "column is bold. Blue: recommended. Orange: as in print.</p>\n";
    html += Summary(report);
    std::vector<Tab> tabs{
        {"RMS on each map", ByMap(report,
                                  [](const FormulaRecord& record, std::size_t m) {
                                      return record.in_sample.maps[m].rms;
                                  },
                                  {})}};
    const auto any = [&](auto has) {
        return std::any_of(report.formulas.begin(), report.formulas.end(), has);
    };
    if (any([](const FormulaRecord& record) { return record.held_out.has_value(); }))
        tabs.push_back({"RMS on each map, held out",
                        ByMap(report,
                              [](const FormulaRecord& record, std::size_t m) {
                                  return record.held_out ? record.held_out->maps[m].rms
                                         : record.fitted ? SurfaceFigures::kUnknown
                                                         : record.in_sample.maps[m].rms;
                              },
                              {})});
    tabs.push_back(
        {"Worst bin on each map", ByMap(report,
                                        [](const FormulaRecord& record, std::size_t m) {
                                            return record.in_sample.maps[m].max_abs;
                                        },
                                        {})});
    if (any([](const FormulaRecord& record) { return !record.facet_rms.empty(); }))
        tabs.push_back({"RMS a facet, and its floors",
                        ByMap(
                            report,
                            [](const FormulaRecord& record, std::size_t m) {
                                return record.facet_rms.empty() ? SurfaceFigures::kUnknown
                                                                : record.facet_rms[m];
                            },
                            FloorRows(report))});
    return html + "<h3>Map by map</h3>\n" + Tabs(tabs);
}

}  // namespace plumb::page
