#include "reports/waterfall.h"

#include <algorithm>
#include <cmath>

#include "reports/plot.h"
#include "reports/text.h"

namespace plumb {
namespace {

constexpr int kRow = 26, kLabel = 110, kBars = 560, kValue = 80;

std::string Tag(const std::string& name, const std::string& attributes,
                const std::string& inner = "") {
    return "<" + name + " " + attributes +
           (inner.empty() ? "/>" : ">" + inner + "</" + name + ">");
}

std::string At(const char* attribute, double value) {
    return std::string(attribute) + "=\"" + Digits(value, 5) + "\" ";
}

}  // namespace

std::string WaterfallSvg(const std::vector<WaterfallStep>& steps, const std::string& value_name,
                         const std::string& tick_name) {
    double most = 0;
    for (const WaterfallStep& step : steps) most = std::max({most, step.value, step.marked});
    if (!(most > 0)) return {};
    const auto x = [&](double value) { return kLabel + kBars * value / most; };
    std::string svg;
    double last = 0;
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const WaterfallStep& step = steps[k];
        const double y = double(kRow) * double(k);
        const double from = std::min(last, step.value), to = std::max(last, step.value);
        svg += Tag("text", At("x", kLabel - 8) + At("y", y + 17) + "text-anchor=\"end\"",
                   Html(step.name));
        svg += Tag("rect", At("x", x(from)) + At("y", y + 5) +
                               At("width", std::max(1.0, x(to) - x(from))) + At("height", 16) +
                               "fill=\"" + (step.value >= last ? kPublishedColor : kOursColor) +
                               "\"");
        if (std::isfinite(step.marked)) {
            svg += Tag("rect", At("x", x(step.marked) - 1) + At("y", y + 2) + At("width", 2) +
                                   At("height", 22) + "fill=\"" + kDataColor + "\"");
        }
        svg += Tag("text", At("x", x(std::max(to, step.marked)) + 6) + At("y", y + 17),
                   Digits(step.value));
        last = step.value;
    }
    const int width = kLabel + kBars + kValue;
    const int height = kRow * int(steps.size());
    return "<figure class=\"waterfall\"><svg viewBox=\"0 0 " + std::to_string(width) + " " +
           std::to_string(height) +
           "\" font-size=\"13\" role=\"img\" aria-label=\"error after each step\">" + svg +
           "</svg><figcaption>" + Html(value_name) +
           " after each step: orange where a step adds to it, blue where it takes away; the "
           "tick "
           "is the " +
           Html(tick_name) + ".</figcaption></figure>\n";
}

}  // namespace plumb
