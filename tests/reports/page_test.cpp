#include "reports/page.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.h"

namespace plumb {
namespace {

TEST(ScriptJson, CannotCloseItsScript) {
    const nlohmann::ordered_json json{{"name", "</script><!-- x"}, {"y", 1}};
    const std::string text = ScriptJson(json);
    EXPECT_EQ(text.find('<'), std::string::npos);
    EXPECT_EQ(nlohmann::ordered_json::parse(text), json);
}

TEST(ScriptJson, BearsNamesThatAreNotUtf8) {
    EXPECT_NO_THROW(ScriptJson({{"name", "caf\xe9"}}));
}

TEST(Picture, IsADataUriOrAnError) {
    EXPECT_EQ(Picture("data:image/png;base64,AAAA", "a \"b\"", "f"),
              "<img src=\"data:image/png;base64,AAAA\" alt=\"a &quot;b&quot;\">");
    EXPECT_THROW(Picture("http://example.org/x.png", "", "f"), Error);
    EXPECT_THROW(Picture("data:image/png;base64,AA\" onload=\"x", "", "f"), Error);
    EXPECT_THROW(Picture("data:image/svg+xml;base64,AAAA", "", "f"), Error);
}

TEST(Page, HoldsItsSectionsAndLoadsNothing) {
    Page page("T <i>", "S & s");
    page.AddSection("one", "First <one>", "<p>text</p>");
    const std::string html = page.Text();
    EXPECT_NE(html.find("<title>T &lt;i&gt;</title>"), std::string::npos);
    EXPECT_NE(html.find("S &amp; s"), std::string::npos);
    EXPECT_NE(html.find("<a href=\"#one\">First &lt;one&gt;</a>"), std::string::npos);
    EXPECT_NE(html.find("<section id=\"one\">"), std::string::npos);
    for (const char* loads : {"src=\"http", "href=\"http", "@import", "url(", "<link"})
        EXPECT_EQ(html.find(loads), std::string::npos) << loads;
}

TEST(Table, SetsTextToTheLeftAndEscapesItsHead) {
    const std::string html =
        Table({{"<name>"}, {"file", true}, {"size [m]"}},
              {{{"a", "", ""}, {"b", "wrap", ""}, {"1", "best", "#ffffff"}}});
    EXPECT_NE(html.find("<th class=\"text\">&lt;name&gt;</th><th class=\"text\">file</th>"
                        "<th>size [m]</th>"),
              std::string::npos);
    EXPECT_NE(html.find("<td class=\"text\">a</td><td class=\"text wrap\">b</td>"
                        "<td class=\"best\" style=\"background:#ffffff\">1</td>"),
              std::string::npos);
}

TEST(HeatColor, RunsFromPaperToAmber) {
    EXPECT_EQ(HeatColor(0), "#ffffff");
    EXPECT_EQ(HeatColor(1), "#f0a03c");
    EXPECT_EQ(HeatColor(7), HeatColor(1));
}

}  // namespace
}  // namespace plumb
