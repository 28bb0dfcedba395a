// Documents as pages.
#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/page.h"
#include "reports/render.h"
#include "reports/sentence.h"
#include "reports/text.h"
#include "reports/waterfall.h"

namespace plumb::doc {
namespace {

const char* Arrow(Better better) {
    return better == Better::kLess ? " ↓" : better == Better::kMore ? " ↑" : "";
}

/// The text of a cell, an interval in small letters.
std::string CellHtml(const Column& column, const Cell& cell) {
    const std::string text = CellText(column, cell);
    const std::size_t open = text.find(" (");
    if (!std::holds_alternative<Measured>(cell) || open == std::string::npos) return Html(text);
    return Html(text.substr(0, open)) + " <span class=\"spread\">" +
           Html(text.substr(open + 1)) + "</span>";
}

std::string FactsHtml(const std::vector<Fact>& facts) {
    if (facts.empty()) return {};
    std::string html = "<div class=\"tiles\">\n";
    for (const Fact& fact : facts) {
        const std::string unit = fact.what.unit.empty() ? "" : " " + Html(fact.what.unit);
        html += "<div class=\"tile\"><b>" + CellHtml(fact.what, fact.value) + unit +
                "</b><span title=\"" + Html(fact.what.meaning) + "\">" + Html(fact.what.title) +
                "</span></div>\n";
    }
    return html + "</div>\n";
}

/// How far each row falls behind the best of its column, 0 to 1: by the logarithm where less is
/// better, so that a factor is a factor. NaN where there is nothing to judge.
std::vector<double> Behind(const Table& table, std::size_t c) {
    const Better better = table.judged ? table.columns[c].better : Better::kNeither;
    std::vector<double> behind;
    double best = std::numeric_limits<double>::infinity(), worst = -best;
    for (const auto& row : table.rows) {
        const double x = better == Better::kNeither ? NAN : NumberOf(row[c]);
        behind.push_back(better == Better::kMore ? -x : std::log(std::abs(x)));
        if (std::isnan(x)) continue;
        best = std::min(best, behind.back());
        if (std::isfinite(behind.back())) worst = std::max(worst, behind.back());
    }
    for (double& b : behind) {
        if (std::isnan(b)) continue;
        b = b == best ? 0 : std::isfinite(best) ? (b - best) / (worst - best) : 1;
    }
    return behind;
}

std::string StepsHtml(const Table& table) {
    if (table.steps.empty()) return {};
    std::vector<WaterfallStep> steps;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        steps.push_back({CellText(table.columns[0], table.rows[r][0]),
                         NumberOf(table.At(r, table.steps)),
                         NumberOf(table.At(r, table.ticks))});
    }
    const auto title = [&](const std::string& key) {
        return std::ranges::find(table.columns, key, &Column::key)->title;
    };
    return WaterfallSvg(steps, title(table.steps), title(table.ticks));
}

std::string TableHtml(const Table& table) {
    std::string html;
    if (!table.title.empty()) html += "<h3>" + Html(table.title) + "</h3>\n";
    html += StepsHtml(table);
    html += "<div class=\"table\"><table id=\"" + Html(table.key) + "\">\n<thead><tr>";
    const auto is_text = [&](std::size_t c) {
        return table.columns[c].role == Role::kName ||
               (!table.rows.empty() &&
                std::holds_alternative<std::string>(table.rows.front()[c]));
    };
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
        const Column& column = table.columns[c];
        html += std::string("<th scope=\"col\"") + (is_text(c) ? " class=\"text\"" : "");
        if (!column.meaning.empty()) html += " title=\"" + Html(column.meaning) + "\"";
        html += ">" + Html(column.title) +
                (column.unit.empty() ? "" : " [" + Html(column.unit) + "]") +
                Arrow(column.better) + "</th>";
    }
    html += "</tr></thead>\n<tbody>\n";
    std::vector<std::vector<double>> behind;
    for (std::size_t c = 0; c < table.columns.size(); ++c) behind.push_back(Behind(table, c));
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const auto& row = table.rows[r];
        html += "<tr>";
        for (std::size_t c = 0; c < row.size(); ++c) {
            const double b = behind[c][r];
            const std::string text = CellText(table.columns[c], row[c]);
            constexpr int kNotBroken = 48;
            html += is_text(c) && Characters(text) > kNotBroken ? "<td class=\"text wrap\""
                    : is_text(c)                                ? "<td class=\"text\""
                    : b == 0                                    ? "<td class=\"best\""
                                                                : "<td";
            if (!std::isnan(b)) html += " style=\"background:" + HeatColor(b) + "\"";
            const std::string exact = Exact(NumberOf(row[c]));
            if (!exact.empty()) html += " data-value=\"" + exact + "\"";
            html += ">" + CellHtml(table.columns[c], row[c]) + "</td>";
        }
        html += "</tr>\n";
    }
    html += "</tbody></table></div>\n";
    if (!table.caption.empty()) {
        html += "<p class=\"note\">" + SentenceHtml(table.caption) + "</p>\n";
    }
    return html;
}

std::string PictureHtml(const Picture& picture, const std::string& section) {
    return "<figure class=\"picture\">" +
           plumb::Picture(picture.data_uri, picture.alternative, section + ": a picture") +
           "<figcaption>" + SentenceHtml(picture.caption) + "</figcaption></figure>\n";
}

std::string SectionHtml(const Section& section, PlotSheet& sheet) {
    std::string html = section.listed ? "<ul class=\"findings\">\n" : "";
    for (const std::string& sentence : section.sentences) {
        html += IsCode(sentence) ? "<pre>" + Html(PlainText(sentence)) + "</pre>\n"
                : section.listed ? "<li>" + SentenceHtml(sentence) + "</li>\n"
                                 : "<p>" + SentenceHtml(sentence) + "</p>\n";
    }
    if (section.listed) html += "</ul>\n";
    html += FactsHtml(section.facts);
    for (const Table& table : section.tables) {
        for (const Table& shown : Shown(table)) html += TableHtml(shown);
    }
    for (const Plots& group : section.plots) {
        std::vector<Plot> plots = group.plots;
        for (Plot& plot : plots) plot.caption = SentenceHtml(plot.caption);
        html += sheet.Group(group.selectors, std::move(plots));
    }
    if (!section.pictures.empty()) html += "<div class=\"gallery\">\n";
    for (const Picture& picture : section.pictures) html += PictureHtml(picture, section.id);
    if (!section.pictures.empty()) html += "</div>\n";
    for (const Section& within : section.sections) {
        const std::string inside = SectionHtml(within, sheet), title = Html(within.title);
        html += within.folded
                    ? "<details id=\"" + Html(within.id) + "\"><summary>" + title +
                          "</summary>\n" + inside + "</details>\n"
                    : "<h3 id=\"" + Html(within.id) + "\">" + title + "</h3>\n" + inside;
    }
    return html;
}

std::string ProvenanceHtml(const Provenance& provenance) {
    std::string html = "<pre class=\"command\">" + Html(provenance.command) +
                       "</pre>\n<p>plumb " + Html(provenance.version) + ", seed " +
                       std::to_string(provenance.seed) +
                       ". The same command gives the same figures to the last digit, on any "
                       "number of threads; only times differ.</p>\n";
    for (const Input& input : provenance.inputs) {
        html += "<p>" + Html(input.name) + ": SHA-256 <code>" + Html(input.sha256) +
                "</code></p>\n";
    }
    return html;
}

}  // namespace

std::string ToHtml(const Document& document) {
    Page page(document.title, document.subtitle);
    for (const Section& section : document.sections) {
        std::string html = SectionHtml(section, page.Plots());
        if (section.folded) {
            html = "<details><summary>Show</summary>\n" + html + "</details>\n";
        }
        page.AddSection(section.id, section.title, std::move(html));
    }
    page.AddSection("provenance", "How to make this again",
                    ProvenanceHtml(document.provenance));
    return page.Text();
}

}  // namespace plumb::doc
