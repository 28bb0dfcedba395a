// Plots as data: what a page draws, in one table of numbers and a list of plots that point into
// it.
//
// A plot has views (map A or map B; over alpha or over V), of which the reader picks one by the
// selectors of its group; all plots of a group follow the same selectors. On a page, numbers that
// several series share stand once.
//
// Beware   Numbers are rounded to six digits: the JSON report has all of them.
#pragma once

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace plumb {

struct Axis {
    std::string label = {};  ///< With its unit.
    std::optional<double> low = {}, high = {};
    bool logarithmic = false;
};

enum class Mark { kDots, kLine, kDashed, kBand };

/// A row of numbers; copies share them.
class Column {
  public:
    Column() = default;
    Column(std::vector<double> values)
        : values_(std::make_shared<const std::vector<double>>(std::move(values))) {}

    bool Given() const { return values_ != nullptr; }
    const std::vector<double>& Values() const { return *values_; }

  private:
    std::shared_ptr<const std::vector<double>> values_;
};

struct PlotSeries {
    std::string label = {};  ///< Empty = not in the legend.
    Mark mark = Mark::kLine;
    std::string color = {};  ///< "#rrggbb"
    Column x = {}, y = {};
    Column minus = {};    ///< If given, y - minus is drawn: a residual.
    Column high = {};     ///< kBand: from y up to here.
    bool joined = false;  ///< kDots: joined by a line.
    int shape = 0;        ///< kDots: circle, triangle, square, diamond, cross, and again.
};

/// One state of the selectors: values of some of their keys, and what is drawn then.
struct PlotView {
    std::vector<std::pair<std::string, std::string>> keys = {};
    std::vector<PlotSeries> series = {};
    std::optional<Axis> x = {}, y = {};  ///< In place of the plot's.
};

struct Plot {
    std::string id;
    std::string title;
    std::string caption = {};  ///< How to read it. HTML.
    Axis x = {}, y = {};
    std::vector<PlotView> views = {};
    bool wide = false;  ///< Takes the whole width of the page.
};

struct PlotSelector {
    std::string key, label;
    std::vector<std::string> options;  ///< The first is shown first.
};

class PlotSheet {
  public:
    /// Makes a row of numbers, and gives it the next place.
    Column Add(std::span<const double> values);

    /// The HTML of a group: its selectors, and of each plot its title, place and caption.
    std::string Group(const std::vector<PlotSelector>& selectors, std::vector<Plot> plots);

    nlohmann::ordered_json ToJson() const;

  private:
    void Place(const Column& column);

    std::vector<Column> columns_;
    std::vector<std::vector<Plot>> groups_;
};

/// Colours that people with any colour vision tell apart [Okabe & Ito, Color Universal Design,
/// 2008], dark enough for white paper.
std::string CategoryColor(int i);

/// The same for many sets of dots under lines of the colours above [Tol, Colour Schemes, 2021,
/// muted].
std::string DotColor(int i);

/// An ordered scale from dark violet (0) to green-yellow (1): the viridis map, cut before it
/// gets too light for white paper.
std::string ScaleColor(double share);

inline constexpr const char* kDataColor = "#3b4048";
inline constexpr const char* kDataBandColor = "#aab2bd";
inline constexpr const char* kOursColor = "#0072b2";
inline constexpr const char* kPublishedColor = "#d55e00";
inline constexpr const char* kBoundColor = "#8a929e";

}  // namespace plumb
