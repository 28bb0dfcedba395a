#include "reports/embedded.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

namespace plumb {
namespace {

std::string FileText(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file.good()) << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(EmbeddedFiles, AreTheFilesByteForByte) {
    EXPECT_EQ(ChartJs(), FileText(PLUMB_CHART_JS));
    EXPECT_EQ(PageJs(), FileText(PLUMB_SOURCE_DIR "/reports/page.js"));
    EXPECT_EQ(PageCss(), FileText(PLUMB_SOURCE_DIR "/reports/page.css"));
}

// Each of them stands in a <script> or <style> as it is.
TEST(EmbeddedFiles, DoNotCloseTheElementTheyStandIn) {
    EXPECT_EQ(ChartJs().find("</script"), std::string::npos);
    EXPECT_EQ(PageJs().find("</script"), std::string::npos);
    EXPECT_EQ(PageCss().find("</style"), std::string::npos);
}

TEST(EmbeddedFiles, CarryTheLicenceOfChartJs) {
    EXPECT_NE(ChartJs().find("MIT License"), std::string::npos);
}

}  // namespace
}  // namespace plumb
