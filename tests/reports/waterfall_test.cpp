// A drawing of steps: what its bars say.
#include "reports/waterfall.h"

#include <gtest/gtest.h>

#include "reports/plot.h"

namespace plumb {
namespace {

// By hand: the greatest is 0.4, over 560 px from x = 110. The first bar from 0 to 0.2 is 280 px wide;
// the second to 0.4 the same from 390; the third falls to 0.1: from 250, 420 wide, in the other colour.
TEST(Waterfall, BarsRunFromTheLastValueToTheNext) {
    const std::string svg = WaterfallSvg(
        {{"one", 0.2, 0.1}, {"two", 0.4, 0.2}, {"three", 0.1, 0.05}}, "Error", "other <error>");
    const auto has = [&](const std::string& text) {
        EXPECT_NE(svg.find(text), std::string::npos) << text << "\n" << svg;
    };
    has("x=\"110.00\" y=\"5.0000\" width=\"280.00\"");
    has("x=\"390.00\" y=\"31.000\" width=\"280.00\"");
    has("x=\"250.00\" y=\"57.000\" width=\"420.00\"");
    has(std::string("fill=\"") + kOursColor + "\"");
    has("x=\"249.00\"");  // The first tick, 0.1.
    has("Error after each step: ");
    has("the tick is the other &lt;error&gt;.");
}

}  // namespace
}  // namespace plumb
