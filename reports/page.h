// The skeleton that all pages share: head, contents, sections, the data of the plots, scripts.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/plot.h"

namespace plumb {

class Page {
  public:
    Page(std::string title, std::string subtitle);

    /// `html` is trusted; escape names with Html() before they get here. `id` is the anchor.
    void AddSection(std::string id, std::string title, std::string html);

    PlotSheet& Plots() { return plots_; }

    /// The whole file.
    std::string Text() const;

  private:
    struct Section {
        std::string id, title, html;
    };
    std::string title_, subtitle_;
    std::vector<Section> sections_;
    PlotSheet plots_;
};

/// JSON as it may stand within a <script>: no "<" is left in it.
std::string ScriptJson(const nlohmann::ordered_json& json);

/// <img> of a data URI of a PNG. Throws Error, naming `field`, if it is anything else: a page
/// loads nothing from elsewhere.
std::string Picture(std::string_view data_uri, std::string_view alternative,
                    const std::string& field);

/// A cell of a table: `html` as it stands, `css` as its class, `color` as its background.
struct Cell {
    std::string html;
    std::string css;
    std::string background;
};

/// The head of a column. Columns of text are set to the left, of numbers to the right.
struct Head {
    std::string name;
    bool is_text = false;
};

/// A table with a head line, in a frame that scrolls on narrow screens. Its first column is
/// text.
std::string Table(const std::vector<Head>& head, const std::vector<std::vector<Cell>>& rows);

/// Paper white (0) to amber (1): how bad a figure is.
std::string HeatColor(double share);

}  // namespace plumb
