// The parts of a scene report's page, one function a section.
#pragma once

#include <string>

#include "reports/page.h"
#include "reports/scene_report.h"
#include "reports/text.h"

namespace plumb::page {

inline Cell Text(const std::string& text) {
    return {Html(text), "", ""};
}

inline Cell Number(double value, int significant = 3) {
    return {Digits(value, significant), "", ""};
}

/// The median in milliseconds, from the least to the greatest of the rounds.
inline Cell Ms(const Measured& time) {
    return {Digits(time.value * 1e3) + " <span class=\"spread\">(" +
                Digits(time.interval.low * 1e3) + "–" + Digits(time.interval.high * 1e3) +
                ")</span>",
            "", ""};
}

/// A value with its 95 % interval.
inline Cell Interval95(const Measured& figure, int significant = 3, double scale = 1) {
    const std::string all = WithInterval(figure, significant, scale);
    const auto open = all.find(" (");
    if (open == std::string::npos) return {all, "", ""};
    return {all.substr(0, open) + " <span class=\"spread\">" + all.substr(open + 1) + "</span>",
            "", ""};
}

inline Cell WithErrorOf(const Measured& figure, double scale = 1) {
    return {WithError(figure.value * scale, figure.standard_error * scale), "", ""};
}

std::string BudgetHtml(const SceneReport& r);
std::string SweepHtml(const SceneReport& r, PlotSheet& sheet);
std::string TimesHtml(const SceneReport& r, PlotSheet& sheet);
std::string FlickerHtml(const SceneReport& r);

}  // namespace plumb::page
