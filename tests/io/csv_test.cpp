#include "io/csv.h"

#include <limits>

#include "core/error.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

// The shape of curves that others have measured: comments, names, plain numbers.
constexpr const char* kCurves =
    "# Irradiance curves measured elsewhere: albedo 1, open ground = pi.\n"
    "# bin k holds alpha in [k/100, (k+1)/100)\n"
    "bin,E0,E1\n"
    "0,0.04218207,0.246685\n"
    "1,0.08699108,9.155345e-05\n";

TEST(ParseCsv, ReadsNamesAndRows) {
    const NumberTable table = ParseCsv(kCurves, "curves.csv");
    EXPECT_EQ(table.names, (std::vector<std::string>{"bin", "E0", "E1"}));
    EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{0, 0.04218207, 0.246685},
                                                            {1, 0.08699108, 9.155345e-05}}));
    EXPECT_EQ(NumbersIn(table, "E1"), (std::vector<double>{0.246685, 9.155345e-05}));
}

TEST(ParseCsv, ReadsOverWhatSpreadsheetsAdd) {
    const NumberTable table =
        ParseCsv("\xef\xbb\xbf\"a\", b \r\n\r\n 1 ,\t+2.5\r\n# end\r\n-3,4e2", "a.csv");
    EXPECT_EQ(table.names, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(table.rows, (std::vector<std::vector<double>>{{1, 2.5}, {-3, 400}}));
}

TEST(ParseCsv, NamesFileLineAndColumnOfWhatIsWrong) {
    const auto message = [](const char* text) {
        return MessageOf<Error>([&] { ParseCsv(text, "curves.csv"); });
    };
    EXPECT_EQ(message("# c\nbin,E0\n0,1\n1,abc\n"),
              "curves.csv:4: E0 = abc, must be a finite number");
    EXPECT_EQ(message("bin,E0\n0,\n"), "curves.csv:2: E0 = , must be a finite number");
    EXPECT_EQ(message("bin,E0\n0,nan\n"), "curves.csv:2: E0 = nan, must be a finite number");
    EXPECT_EQ(message("bin,E0\n0,1e999\n"),
              "curves.csv:2: E0 = 1e999, must be a finite number");
    EXPECT_EQ(message("bin,E0\n0,1.5x\n"), "curves.csv:2: E0 = 1.5x, must be a finite number");
    EXPECT_EQ(message("bin,E0\n0,1,2\n"),
              "curves.csv:2: has 3 cells, must be 2 as in the header");
    EXPECT_EQ(message("bin,E0\n0\n"), "curves.csv:2: has 1 cells, must be 2 as in the header");
    EXPECT_EQ(message("bin,bin\n0,1\n"),
              "curves.csv:1: column 2 = bin, must be a name of its own");
    EXPECT_EQ(message("bin,\n0,1\n"), "curves.csv:1: column 2 has no name");
    EXPECT_EQ(message("# only\n"), "curves.csv: has no header line of column names");
    EXPECT_EQ(message(""), "curves.csv: has no header line of column names");
    EXPECT_EQ(message("bin,E0\n"), "curves.csv: has a header but no row of numbers");
}

TEST(Column, NamesTheColumnsThatExist) {
    EXPECT_EQ(MessageOf<Error>([] { NumbersIn(ParseCsv("a,b\n1,2\n", ""), "c"); }),
              "column c is missing, there are a, b");
}

TEST(ToCsv, WritesTheFewestDigitsThatReadBack) {
    EXPECT_EQ(ToCsv({.names = {"x", "y"}, .rows = {{0.1, -2}, {1. / 3, 1e-300}}}, {"why"}),
              "# why\nx,y\n0.1,-2\n0.3333333333333333,1e-300\n");
}

using CsvFile = TempFolder;

TEST_F(CsvFile, ReadsBackTheSameBits) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    const NumberTable table{.names = {"a", "b"}, .rows = {{tiny, 2. / 3}, {-0.0, 1e308}}};
    WriteCsv(Path("a.csv"), table, {"comment"});
    EXPECT_EQ(ReadCsv(Path("a.csv")), table);
    EXPECT_THROW(ReadCsv(Path("none.csv")), Error);
}

}  // namespace
}  // namespace plumb
