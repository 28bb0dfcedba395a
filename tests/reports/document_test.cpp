// Documents: their values, and that all renderers show the same ones.
#include "reports/document.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "reports/render.h"
#include "reports/sentence.h"
#include "tests/reports/json_schema.h"

namespace plumb::doc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Measured Of(double value, double standard_error) {
    return {.value = value,
            .standard_error = standard_error,
            .interval = {value - 2 * standard_error, value + 2 * standard_error}};
}

Document Made() {
    Table table{.key = "scores",
                .title = "Scores",
                .caption = "Lower is *better*.",
                .columns = {{.key = "name", .title = "Name", .role = Role::kName},
                            {.key = "pixels", .title = "Pixels"},
                            {.key = "rmse",
                             .title = "RMSE",
                             .better = Better::kLess,
                             .meaning = "root of the mean of <squares>"},
                            {.key = "bias", .title = "Bias", .digits = 2},
                            {.key = "time_ms",
                             .title = "Time",
                             .unit = "ms",
                             .role = Role::kTime,
                             .better = Better::kLess}}};
    table.Add({"a<b> \"q\", c", 12345, Of(0.12345678, 0.0023), -1.0 / 3, 4.0625});
    table.Add({"=SUM(1)", 7, Measured{.value = 2.5, .interval = {1, 16}}, kNan, kInfinity});
    table.Add({"none", std::monostate{}, kNan, 1e-9, Measured{}});
    Section section{.id = "one", .title = "One & only"};
    section.sentences = {"Use `a < b` of E_{k}."};
    section.facts = {
        {{.key = "spp", .title = "Samples"}, 64},
        {{.key = "run_s", .title = "Run", .unit = "s", .role = Role::kTime}, 1.25}};
    section.tables = {table};
    Plot plot{.id = "p",
              .title = "P",
              .caption = "Seconds _{low}",
              .x = {"x [m]", {}, {}},
              .y = {"y", {}, {}},
              .views = {}};
    PlotView view;
    view.series = {{.label = "s",
                    .color = "#000000",
                    .x = std::vector<double>{1, 2},
                    .y = std::vector<double>{0.1234567890123, kNan},
                    .minus = {},
                    .high = {}}};
    plot.views = {view};
    section.plots = {{.plots = {plot}, .of_times = true}};
    section.pictures = {{"data:image/png;base64,AAAA", "a \"picture\"", "It."}};
    section.sections = {{.id = "within", .title = "Within", .folded = true}};
    return {.kind = "made",
            .title = "T",
            .subtitle = "S",
            .provenance = {.version = "1.2.3",
                           .command = "plumb made <x>",
                           .seed = 9,
                           .inputs = {{"in.png", std::string(64, 'a')}}},
            .sections = {section}};
}

TEST(Document, JsonIsByItsPublishedSchema) {
    const nlohmann::json schema = PublishedSchema("document-1.json");
    const nlohmann::json json = nlohmann::json::parse(ToJsonText(Made()));
    EXPECT_THAT(SchemaErrors(schema, json), IsEmpty());
    EXPECT_THAT(SchemaErrors(schema, nlohmann::json::parse(ToJsonText(WithoutTimes(Made())))),
                IsEmpty());
}

// Expected: the schema says something, so breaking each part of a document breaks its rule.
TEST(Document, SchemaRefusesWhatIsNotADocument) {
    const nlohmann::json schema = PublishedSchema("document-1.json");
    const nlohmann::json good = nlohmann::json::parse(ToJsonText(Made()));
    const auto refused = [&](const char* pointer, const nlohmann::json& value) {
        nlohmann::json bad = good;
        bad[nlohmann::json::json_pointer(pointer)] = value;
        EXPECT_THAT(SchemaErrors(schema, bad), Not(IsEmpty())) << pointer;
    };
    refused("/version", 2);
    refused("/kind", "Made by");
    refused("/more", 1);
    refused("/provenance/seed", -1);
    refused("/provenance/inputs/0/sha256", "abc");
    refused("/sections/0/tables/0/rows/0/rmse", {{"value", 1}});
    refused("/sections/0/tables/0/rows/0/rmse", {1});
    refused("/sections/0/tables/0/columns/0/role", "title");
    refused("/sections/0/facts/0/digits", 0);
    refused("/sections/0/sections/0/folded", "yes");
    refused("/sections/0/plots/0/views/0/series/0/x", {1.5, 2});
    refused("/sections/0/plots/0/views/0/series/0/y", -1);
    refused("/plotted/0", {"1"});
    refused("/sections/0/tables/0/values", {{"name", {"a"}}});
    for (const auto& [name, value] : good.items()) {
        nlohmann::json bad = good;
        bad.erase(name);
        EXPECT_THAT(SchemaErrors(schema, bad), ElementsAre(": must have \"" + name + "\""));
    }
}

// Expected, by hand.
TEST(CellText, RoundsByTheErrorElseByTheColumn) {
    const Column column{.key = "x", .title = "X"};
    EXPECT_EQ(CellText(column, std::monostate{}), "–");
    EXPECT_EQ(CellText(column, "word"), "word");
    EXPECT_EQ(CellText(column, 12345), "12,345");
    EXPECT_EQ(CellText(column, 0.123456), "0.123");
    EXPECT_EQ(CellText(column, kNan), "–");
    EXPECT_EQ(CellText(column, Of(27.5812, 0.1234)), "27.58 ± 0.12");
    EXPECT_EQ(CellText(column, Measured{.value = 4, .interval = {1, 16}}),
              "4.00 (1.00 to 16.0)");
    EXPECT_EQ(CellText(column, Measured{.value = 4}), "4.00");
    EXPECT_EQ(CellText(column, Measured{}), "–");
}

// The cells of the page's table, row by row: what stands between <td ...> and </td>.
std::vector<std::string> CellsOfPage(const std::string& html) {
    std::vector<std::string> cells;
    for (std::size_t at = html.find("<td"); at != std::string::npos;
         at = html.find("<td", at)) {
        at = html.find('>', at) + 1;
        std::string cell = html.substr(at, html.find("</td>", at) - at);
        for (const std::string tag : {"<span class=\"spread\">", "</span>"}) {
            const std::size_t begin = cell.find(tag);
            if (begin != std::string::npos) cell.erase(begin, tag.size());
        }
        cells.push_back(std::move(cell));
    }
    return cells;
}

Cell CellOf(const nlohmann::json& json) {
    if (json.is_null()) return std::monostate{};
    if (json.is_string()) return json.get<std::string>();
    if (json.is_number_integer()) return json.get<std::int64_t>();
    if (json.is_number()) return json.get<double>();
    const auto number = [&](const char* name, double otherwise) {
        return json[name].is_null() ? otherwise : json[name].get<double>();
    };
    return Measured{.value = number("value", kNan),
                    .standard_error = number("standard_error", kNan),
                    .interval = {number("low", -kInfinity), number("high", kInfinity)}};
}

// Expected: the JSON's numbers, rounded to the JSON's digits, are the page's and the terminal's.
TEST(Document, PageAndTerminalShowTheNumbersOfTheJson) {
    const Document document = Made();
    const nlohmann::json json = nlohmann::json::parse(ToJsonText(document));
    const nlohmann::json& table = json["sections"][0]["tables"][0];
    const std::vector<std::string> cells = CellsOfPage(ToHtml(document));
    const std::string terminal = ToTerminal(document);
    ASSERT_EQ(cells.size(), 15u);
    std::size_t k = 0;
    for (const nlohmann::json& row : table["rows"]) {
        for (const nlohmann::json& column : table["columns"]) {
            const Column rounded{.key = {}, .title = {}, .digits = column["digits"]};
            const std::string text =
                CellText(rounded, CellOf(row[column["key"].get<std::string>()]));
            EXPECT_THAT(terminal, HasSubstr(text));
            if (column["key"] != "name") {
                EXPECT_EQ(cells[k], text);
            }
            ++k;
        }
    }
}

TEST(Document, PageEscapesAllThatComesFromOutside) {
    const std::string html = ToHtml(Made());
    EXPECT_THAT(html, HasSubstr("a&lt;b&gt; &quot;q&quot;, c"));
    EXPECT_THAT(html, HasSubstr("One &amp; only"));
    EXPECT_THAT(html, HasSubstr("<code>a &lt; b</code> of E<sub>k</sub>."));
    EXPECT_THAT(html, HasSubstr("title=\"root of the mean of &lt;squares&gt;\""));
    EXPECT_THAT(html, HasSubstr("plumb made &lt;x&gt;"));
    EXPECT_THAT(html, HasSubstr("data-value=\"4.0625\""));
    EXPECT_THAT(html, HasSubstr("<div class=\"tile\"><b>1.25 s</b>"));
    EXPECT_THAT(html, HasSubstr("<details id=\"within\">"));
    EXPECT_THAT(html, Not(HasSubstr("a<b>")));
}

// Expected, by hand.
TEST(Table, AsCsvHasEveryDigitAndAnEmptyFieldForWhatIsNotFinite) {
    EXPECT_EQ(ToCsv(TableOf(Made(), "scores")),
              "name,pixels,rmse,rmse_se,rmse_low,rmse_high,bias,time_ms,time_ms_se,time_ms_low,"
              "time_ms_high\n"
              "\"a<b> \"\"q\"\", c\",12345,0.12345678,0.0023,0.11885678,0.12805678,"
              "-0.3333333333333333,4.0625,,,\n"
              "'=SUM(1),7,2.5,,1,16,,,,,\n"
              "none,,,,,,1e-09,,,,\n");
}

TEST(Document, AsCsvHasOneLineANumber) {
    const std::string csv = ToCsv(Made());
    EXPECT_THAT(csv, HasSubstr("\none,,run_s,s,1.25,,,\n"));
    EXPECT_THAT(csv, HasSubstr("\nscores,\"a<b> \"\"q\"\", c\",time_ms,ms,4.0625,,,\n"));
    EXPECT_THAT(csv, HasSubstr("\nscores,'=SUM(1),rmse,,2.5,,1,16\n"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 2 + 3 * 4);
}

TEST(Document, WithoutTimesHasNothingLeftThatDiffersFromRunToRun) {
    Document first = Made(), second = Made();
    Section& section = second.sections[0];
    section.facts[1].value = 77.0;
    section.tables[0].rows[0][4] = 88.0;
    section.plots[0].plots[0].title = "another";
    EXPECT_NE(ToJsonText(first), ToJsonText(second));
    first = WithoutTimes(first);
    second = WithoutTimes(second);
    EXPECT_EQ(ToJsonText(first), ToJsonText(second));
    EXPECT_EQ(ToHtml(first), ToHtml(second));
    EXPECT_EQ(ToCsv(first), ToCsv(second));
    EXPECT_EQ(ToTerminal(first), ToTerminal(second));
    EXPECT_EQ(TableOf(first, "scores").columns.size(), 4u);
    EXPECT_EQ(NumberOf(FactOf(first, "spp")), 64);
}

TEST(Document, FindsItsPartsOrSaysWhichThereAre) {
    const Document document = Made();
    EXPECT_EQ(NumberOf(TableOf(document, "scores").At(1, "rmse")), 2.5);
    EXPECT_THROW(TableOf(document, "score"), Error);
    EXPECT_THROW(TableOf(document, "scores").At(0, "x"), Error);
    EXPECT_THROW(TableOf(document, "scores").At(3, "rmse"), Error);
    Table table{.key = "t", .columns = {{.key = "a", .title = "A"}}};
    EXPECT_THROW(table.Add({1, 2}), std::logic_error);
}

/// RMSE of two formulas on two maps, of which one was not measured.
Table OnMaps() {
    Table table{
        .key = "on",
        .caption = "C.",
        .columns = {{.key = "formula", .title = "Formula", .role = Role::kName},
                    {.key = "map", .title = "Map", .role = Role::kName},
                    {.key = "rms", .title = "RMS", .unit = "m", .better = Better::kLess},
                    {.key = "db", .title = "PSNR", .better = Better::kMore},
                    {.key = "n", .title = "Samples", .detail = true},
                    {.key = "none", .title = "None"}},
        .judged = true,
        .across = "map"};
    table.Add({"f", "one", 0.5, 30.0, 9, std::monostate{}});
    table.Add({"f", "two", 0.125, 10.0, 8, std::monostate{}});
    table.Add({"g", "two", 2.0, 20.0, 8, std::monostate{}});
    table.Add({"h", "two", 0.5, kNan, 8, std::monostate{}});
    return table;
}

// Expected, by hand: a table for RMS and one for PSNR; what is for machines, or nothing, is gone.
TEST(Shown, SetsNamesSideBySide) {
    const std::vector<Table> shown = Shown(OnMaps());
    ASSERT_EQ(shown.size(), 2u);
    EXPECT_EQ(ToCsv(shown[0]), "formula,rms,rms\nf,0.5,0.125\ng,,2\nh,,0.5\n");
    EXPECT_EQ(ToCsv(shown[1]), "formula,db,db\nf,30,10\ng,,20\nh,,\n");
    EXPECT_EQ(shown[0].title, "RMS [m]");
    EXPECT_EQ(shown[0].columns[1].title, "one");
    EXPECT_EQ(shown[0].columns[2].title, "two");
    EXPECT_EQ(shown[0].caption, "");
    EXPECT_EQ(shown[1].caption, "C.");
    Table without = OnMaps();
    without.across.clear();
    ASSERT_EQ(Shown(without).size(), 1u);
    EXPECT_EQ(Shown(without)[0].columns.size(), 4u);
    without.columns[2].detail = without.columns[3].detail = true;
    EXPECT_THAT(Shown(without), IsEmpty());  // Names alone.
    without.columns[2].detail = false;
    without.data = true;
    EXPECT_THAT(Shown(without), IsEmpty());
    without = OnMaps();
    without.across = "maps";
    EXPECT_THROW(Shown(without), Error);
}

// Expected: 0.125, 0.5 and 2 lie one factor of 4 apart: best, half-way, worst; of 10, 20 and nothing
// 20 is the best. Half-way between white (255, 255, 255) and (240, 160, 60).
// By hand: an interval where a standard error is known too; without bounds the value alone.
TEST(CellText, ShowsTheIntervalIfItsColumnSays) {
    const Column error{.key = "rmse", .title = "RMSE"};
    Column interval = error;
    interval.interval = true;
    const Measured m{.value = 0.12345, .standard_error = 0.0123, .interval = {0.1, 0.2}};
    EXPECT_EQ(CellText(error, m), "0.123 ± 0.012");
    EXPECT_EQ(CellText(interval, m), "0.123 (0.100 to 0.200)");
    EXPECT_EQ(CellText(interval, Measured{.value = 0.12345, .standard_error = 0.0123}),
              "0.123");
    Document document = Made();
    Table& table = document.sections[0].tables[0];
    table.columns[2].interval = true;
    table.rows = {{"x", 1, m, 0.0, 0.0}};
    EXPECT_THAT(ToHtml(document),
                HasSubstr("0.123 <span class=\"spread\">(0.100 to 0.200)</span>"));
}

// By hand: of a table drawn as steps the bars are of one column, the ticks of another, by its rows'
// names; long texts may take several lines; a table of what was fastest is none without times.
TEST(Document, DrawsStepsWrapsTextsAndDropsTablesOfTimes) {
    Document document = Made();
    Table steps{.key = "steps",
                .columns = {{.key = "step", .title = "Step", .role = Role::kName},
                            {.key = "what", .title = "What"},
                            {.key = "error", .title = "Error"},
                            {.key = "after", .title = "Error after"}},
                .steps = "error",
                .ticks = "after"};
    steps.Add({"one", "a text that is longer than all of forty-eight letters", 0.2, 0.1});
    steps.Add({"two", "short", 0.4, 0.2});
    Table fastest = steps;
    fastest.key = "fastest";
    fastest.steps = fastest.ticks = "";
    fastest.of_times = true;
    document.sections[0].tables = {steps, fastest};
    const std::string page = ToHtml(document);
    // The greatest is 0.4, over 560 px from x = 110 on.
    EXPECT_THAT(page, HasSubstr("x=\"390.00\" y=\"31.000\" width=\"280.00\""));
    EXPECT_THAT(page, HasSubstr("x=\"249.00\""));  // The first tick, 0.1, 2 px wide.
    EXPECT_THAT(page, HasSubstr(">two</text>"));
    EXPECT_THAT(page, HasSubstr("Error after each step"));
    EXPECT_THAT(page, HasSubstr("the tick is the Error after."));
    EXPECT_THAT(page, HasSubstr("<td class=\"text wrap\">a text that is longer"));
    EXPECT_THAT(page, HasSubstr("<td class=\"text\">short"));
    EXPECT_EQ(page.find("<svg"), page.rfind("<svg"));  // Of the first table alone.
    const Document without = WithoutTimes(document);
    ASSERT_EQ(without.sections[0].tables.size(), 1u);
    EXPECT_EQ(without.sections[0].tables[0].key, "steps");
}

TEST(Shown, MarksTheBestAndShadesTheOthers) {
    const Document document{.kind = "k",
                            .title = "T",
                            .sections = {{.id = "s", .title = "S", .tables = {OnMaps()}}}};
    const std::string html = ToHtml(document);
    EXPECT_THAT(html,
                HasSubstr("class=\"best\" style=\"background:#ffffff\" data-value=\"0.125\""));
    EXPECT_THAT(html, HasSubstr("<td style=\"background:#f0a03c\" data-value=\"2\""));
    EXPECT_THAT(html, HasSubstr("<td style=\"background:#f8d09e\" data-value=\"0.5\""));
    EXPECT_THAT(html,
                HasSubstr("class=\"best\" style=\"background:#ffffff\" data-value=\"20\""));
    EXPECT_THAT(html, HasSubstr("<td style=\"background:#f0a03c\" data-value=\"10\""));
    EXPECT_THAT(html, HasSubstr("<td>–</td>"));
}

TEST(Table, OfDataIsListedColumnByColumn) {
    Document document = Made();
    document.sections[0].tables[0].data = true;
    const nlohmann::json json = nlohmann::json::parse(ToJsonText(document));
    EXPECT_THAT(SchemaErrors(PublishedSchema("document-1.json"), json), IsEmpty());
    const nlohmann::json& table = json["sections"][0]["tables"][0];
    EXPECT_FALSE(table.contains("rows"));
    EXPECT_EQ(table["values"]["pixels"].dump(), "[12345,7,null]");
    EXPECT_EQ(table["values"]["bias"][0], -1.0 / 3);
    EXPECT_TRUE(table["values"]["bias"][1].is_null());
    for (const std::string& text : {ToHtml(document), ToTerminal(document), ToCsv(document)}) {
        EXPECT_THAT(text, Not(HasSubstr("SUM(1)")));
    }
}

// A row of numbers that two series share stands in the JSON once, with all its digits.
TEST(Document, JsonHoldsWhatPlotsShareOnce) {
    Document document = Made();
    PlotView& view = document.sections[0].plots[0].plots[0].views[0];
    view.series.push_back(view.series[0]);
    view.series[1].y = std::vector<double>{3, 4};
    const nlohmann::json json = nlohmann::json::parse(ToJsonText(document));
    EXPECT_EQ(json["plotted"].dump(), "[[1.0,2.0],[0.1234567890123,null],[3.0,4.0]]");
    const nlohmann::json& series = json["sections"][0]["plots"][0]["views"][0]["series"];
    EXPECT_EQ(series[0]["x"], 0);
    EXPECT_EQ(series[1]["x"], 0);
    EXPECT_EQ(series[0]["y"], 1);
    EXPECT_EQ(series[1]["y"], 2);
}

// Expected: no line over 100 columns, every number there, the names beside each part.
TEST(Terminal, BreaksATableThatIsTooWide) {
    Table table{.key = "wide",
                .columns = {{.key = "name", .title = "Name", .role = Role::kName}}};
    std::vector<Cell> row{"a name of twenty-four ch"};
    for (int k = 0; k < 20; ++k) {
        table.columns.push_back({.key = "c", .title = "Column " + std::to_string(100 + k)});
        row.push_back(200 + k);
    }
    table.Add(row);
    const std::string text =
        ToTerminal({.kind = "k",
                    .title = "T",
                    .sections = {{.id = "s", .title = "S", .tables = {table}},
                                 {.id = "e", .title = "Empty"}}});
    std::size_t names = 0;
    for (std::size_t at = 0, end = 0; (end = text.find('\n', at)) != std::string::npos;
         at = end + 1) {
        const std::string line = text.substr(at, end - at);
        EXPECT_LE(line.size(), 100u);
        names += line.find("a name of") != std::string::npos;
    }
    // (100 - 26) / (3 + 10) = 5 columns at a time.
    EXPECT_EQ(names, 4u);
    for (int k = 0; k < 20; ++k) {
        EXPECT_THAT(text, HasSubstr("   " + std::to_string(200 + k)));
        EXPECT_THAT(text, HasSubstr("   Column " + std::to_string(100 + k)));
    }
    EXPECT_THAT(text, Not(HasSubstr("Empty")));
}

TEST(Sentence, OfCodeAloneKeepsItsLinesAndPointsAreListed) {
    const Document document{.kind = "k",
                            .title = "T",
                            .sections = {{.id = "s",
                                          .title = "S",
                                          .listed = true,
                                          .sentences = {"One *point*.", "`a < b\n  c`"}}}};
    EXPECT_THAT(ToHtml(document),
                HasSubstr("<ul class=\"findings\">\n<li>One <em>point</em>.</li>\n"
                          "<pre>a &lt; b\n  c</pre>\n</ul>"));
    EXPECT_THAT(ToTerminal(document), HasSubstr("\nS\n  - One point.\n  a < b\n  c\n"));
}

TEST(Sentence, MarksWhatItSaysAndNothingElse) {
    EXPECT_EQ(SentenceHtml("a `b<c` *d* E_{k+1}^{2}"),
              "a <code>b&lt;c</code> <em>d</em> E<sub>k+1</sub><sup>2</sup>");
    EXPECT_EQ(PlainText("a `b<c` *d* E_{k+1}^{2}"), "a b<c d E_k+1^2");
    EXPECT_EQ(SentenceHtml("2 * 3 `open a_b <i>"), "2 * 3 `open a_b &lt;i&gt;");
    const std::string name = "*x* `y` z_{1} \\ ^{2}";
    EXPECT_EQ(SentenceHtml(Verbatim(name)), name);
    EXPECT_EQ(PlainText(Verbatim(name)), name);
    EXPECT_EQ(SentenceHtml("*" + Verbatim(name) + "*"), "<em>" + name + "</em>");
    EXPECT_EQ(SentenceHtml("*a\\*"), "*a*");
}

}  // namespace
}  // namespace plumb::doc
