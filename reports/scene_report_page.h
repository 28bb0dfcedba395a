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

inline Cell Ms(double seconds) {
    return Number(seconds * 1e3);
}

inline Cell WithErrorOf(const Figure& figure, double scale = 1) {
    return {WithError(figure.value * scale, figure.standard_error * scale), "", ""};
}

std::string BudgetHtml(const SceneReport& r);
std::string SweepHtml(const SceneReport& r, PlotSheet& sheet);
std::string TimesHtml(const SceneReport& r, PlotSheet& sheet);
std::string FlickerHtml(const SceneReport& r);

}  // namespace plumb::page
