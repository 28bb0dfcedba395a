#include "reports/page.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "reports/embedded.h"
#include "reports/text.h"

namespace plumb {

Page::Page(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void Page::AddSection(std::string id, std::string title, std::string html) {
    sections_.push_back({std::move(id), std::move(title), std::move(html)});
}

std::string Page::Text() const {
    std::string contents, body;
    for (const Section& section : sections_) {
        contents += "<a href=\"#" + section.id + "\">" + Html(section.title) + "</a>\n";
        body += "<section id=\"" + section.id + "\">\n<h2>" + Html(section.title) + "</h2>\n" +
                section.html + "</section>\n";
    }
    std::string page =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    // A name that slipped through unescaped could still load nothing and send nothing.
    page +=
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src "
        "data:; style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n";
    page += "<title>" + Html(title_) + "</title>\n<style>\n";
    page += PageCss();
    page += "</style>\n</head>\n<body>\n<header>\n<h1>" + Html(title_) +
            "</h1>\n<p class=\"subtitle\">" + Html(subtitle_) + "</p>\n<nav>\n" + contents +
            "</nav>\n</header>\n<main>\n";
    page +=
        "<noscript><p class=\"note\">The plots need JavaScript; tables and figures do "
        "not.</p></noscript>\n";
    page += body + "</main>\n<script type=\"application/json\" id=\"plumb-data\">" +
            ScriptJson(plots_.ToJson()) + "</script>\n<script>\n";
    page += ChartJs();
    page += "\n</script>\n<script>\n";
    page += PageJs();
    page += "</script>\n</body>\n</html>\n";
    return page;
}

std::string ScriptJson(const nlohmann::ordered_json& json) {
    std::string safe;
    // In JSON a "<" can only stand within a string, where its escape means the same.
    for (const char c :
         json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace))
        safe += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return safe;
}

std::string Picture(std::string_view data_uri, std::string_view alternative,
                    const std::string& field) {
    constexpr std::string_view kPrefix = "data:image/png;base64,";
    constexpr std::string_view kBase64 =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/=";
    if (!data_uri.starts_with(kPrefix) ||
        data_uri.substr(kPrefix.size()).find_first_not_of(kBase64) != std::string_view::npos)
        throw Error(field + " = " + std::string(data_uri.substr(0, 40)) + ", must be a " +
                    std::string(kPrefix) + " URI");
    return "<img src=\"" + std::string(data_uri) + "\" alt=\"" + Html(alternative) + "\">";
}

std::string Table(const std::vector<Head>& head, const std::vector<std::vector<Cell>>& rows) {
    const auto is_text = [&](std::size_t c) { return c == 0 || head[c].is_text; };
    std::string html = "<div class=\"table\"><table>\n<thead><tr>";
    for (std::size_t c = 0; c < head.size(); ++c)
        html += std::string("<th") + (is_text(c) ? " class=\"text\">" : ">") +
                Html(head[c].name) + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const std::vector<Cell>& row : rows) {
        html += "<tr>";
        assert(row.size() == head.size());
        for (std::size_t c = 0; c < row.size(); ++c) {
            std::string css = is_text(c) ? "text" : "";
            if (!row[c].css.empty()) css += (css.empty() ? "" : " ") + row[c].css;
            html += "<td";
            if (!css.empty()) html += " class=\"" + css + "\"";
            if (!row[c].background.empty())
                html += " style=\"background:" + row[c].background + "\"";
            html += ">" + row[c].html + "</td>";
        }
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

std::string HeatColor(double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    const auto mix = [t](int from, int to) {
        return unsigned(std::lround(from + t * (to - from))) & 255u;
    };
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", mix(255, 240), mix(255, 160),
                  mix(255, 60));
    return text;
}

}  // namespace plumb
