#include "io/histogram_io.h"

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "io/json_file.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

Spread MakeSpread(double x) {
    return {.mean = x, .variance = x / 7, .p05 = x / 3, .p50 = x * 1.1, .p95 = x * 1.7};
}

/// Two bounces, two albedos, three bins of which the middle one is empty; numbers with all
/// digits in use.
BounceHistogram Made() {
    BounceHistogram histogram{.surface = "Bricks, \"old\"",
                              .binned_by = BinnedBy::kCosineVisibility,
                              .albedos = {0.5, 1. / 3},
                              .bins = {}};
    for (int b = 0; b < 3; ++b) {
        const double x = b == 1 ? 0 : (b + 1) / 7.;
        histogram.bins.push_back(
            {.low = b / 3.,
             .high = (b + 1) / 3.,
             .count = b == 1 ? 0 : 123456789012345 + b,
             .alpha = x,
             .V = x / 2,
             .bounce = {MakeSpread(x), MakeSpread(x / 5), MakeSpread(x / 9)},
             .total = {MakeSpread(2 * x), MakeSpread(3 * x)}});
    }
    return histogram;
}

void ExpectSame(const Spread& a, const Spread& b) {
    EXPECT_EQ(a.mean, b.mean);
    EXPECT_EQ(a.variance, b.variance);
    EXPECT_EQ(a.p05, b.p05);
    EXPECT_EQ(a.p50, b.p50);
    EXPECT_EQ(a.p95, b.p95);
}

void ExpectSame(const std::vector<Spread>& a, const std::vector<Spread>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) ExpectSame(a[k], b[k]);
}

using HistogramIo = TempFolder;

TEST_F(HistogramIo, JsonReadsBackTheSameBits) {
    const BounceHistogram original = Made();
    WriteHistogramJson(Path("a.json"), original);
    const BounceHistogram read = ReadHistogramJson(Path("a.json"));
    EXPECT_EQ(read.surface, original.surface);
    EXPECT_EQ(read.binned_by, original.binned_by);
    EXPECT_EQ(read.albedos, original.albedos);
    ASSERT_EQ(read.bins.size(), original.bins.size());
    for (std::size_t b = 0; b < read.bins.size(); ++b) {
        EXPECT_EQ(read.bins[b].low, original.bins[b].low);
        EXPECT_EQ(read.bins[b].high, original.bins[b].high);
        EXPECT_EQ(read.bins[b].count, original.bins[b].count);
        EXPECT_EQ(read.bins[b].alpha, original.bins[b].alpha);
        EXPECT_EQ(read.bins[b].V, original.bins[b].V);
        ExpectSame(read.bins[b].bounce, original.bins[b].bounce);
        ExpectSame(read.bins[b].total, original.bins[b].total);
    }
    BounceHistogram other = original;
    other.binned_by = BinnedBy::kUniformVisibility;
    WriteHistogramJson(Path("b.json"), other);
    EXPECT_EQ(ReadHistogramJson(Path("b.json")).binned_by, BinnedBy::kUniformVisibility);
}

TEST_F(HistogramIo, CsvHasARowPerBin) {
    WriteHistogramCsv(Path("a.csv"), Made());
    const NumberTable table = ReadCsv(Path("a.csv"));
    const std::vector<std::string> names{"bin",
                                         "low",
                                         "high",
                                         "count",
                                         "alpha",
                                         "V",
                                         "E0",
                                         "E0_var",
                                         "E0_p05",
                                         "E0_p50",
                                         "E0_p95",
                                         "E1",
                                         "E1_var",
                                         "E1_p05",
                                         "E1_p50",
                                         "E1_p95",
                                         "E2",
                                         "E2_var",
                                         "E2_p05",
                                         "E2_p50",
                                         "E2_p95",
                                         "E_rho0p5",
                                         "E_rho0p5_var",
                                         "E_rho0p5_p05",
                                         "E_rho0p5_p50",
                                         "E_rho0p5_p95",
                                         "E_rho0p3333333333333333",
                                         "E_rho0p3333333333333333_var",
                                         "E_rho0p3333333333333333_p05",
                                         "E_rho0p3333333333333333_p50",
                                         "E_rho0p3333333333333333_p95"};
    EXPECT_EQ(table.names, names);
    const BounceBin last = Made().bins[2];
    EXPECT_EQ(NumbersIn(table, "bin"), (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(NumbersIn(table, "count")[2], double(last.count));
    EXPECT_EQ(NumbersIn(table, "V")[2], last.V);
    EXPECT_EQ(NumbersIn(table, "E1")[2], last.bounce[1].mean);
    EXPECT_EQ(NumbersIn(table, "E1_p05")[2], last.bounce[1].p05);
    EXPECT_EQ(NumbersIn(table, "E1_p50")[2], last.bounce[1].p50);
    EXPECT_EQ(NumbersIn(table, "E1_p95")[2], last.bounce[1].p95);
    EXPECT_EQ(NumbersIn(table, "E_rho0p5_var")[2], last.total[0].variance);
    EXPECT_EQ(Get("a.csv").substr(0, 44), "# Light on Bricks, \"old\", facets binned by V");
}

TEST_F(HistogramIo, AHistogramWithoutAFacetIsAnError) {
    BounceHistogram empty = Made();
    for (BounceBin& bin : empty.bins) bin.count = 0;
    const std::string rule = " is a histogram without a facet, must have at least one";
    EXPECT_EQ(MessageOf<Error>([&] { WriteHistogramJson(Path("a.json"), empty); }),
              "histogram of Bricks, \"old\":" + rule);
    EXPECT_THROW(WriteHistogramCsv(Path("a.csv"), empty), Error);
    empty.bins.clear();
    EXPECT_THROW(ToJson(empty), Error);
    EXPECT_EQ(FileCount(), 0);
    EXPECT_EQ(MessageOf<Error>([&] {
                  HistogramFromJson(ParseJson(R"({"surface": "x", "albedos": [], "bins": [],
                      "binned_by": "uniform_visibility"})",
                                              ""),
                                    "a.json");
              }),
              "a.json:" + rule);
}

/// What is wrong with Made() after a change of its JSON.
template <class Change>
std::string MessageAfter(const Change& change) {
    nlohmann::ordered_json json = ToJson(Made());
    change(json);
    return MessageOf<Error>([&] { HistogramFromJson(json, "a.json"); });
}

TEST_F(HistogramIo, NamesFileFieldValueAndRule) {
    using Json = nlohmann::ordered_json;
    EXPECT_EQ(MessageAfter([](Json& json) { json["binned_by"] = "ao"; }),
              "a.json: binned_by = \"ao\", must be one of uniform_visibility, "
              "cosine_visibility");
    EXPECT_EQ(MessageAfter([](Json& json) { json["albedos"][1] = 1.5; }),
              "a.json: albedos[1] = 1.5, must be in [0, 1]");
    EXPECT_EQ(MessageAfter([](Json& json) { json["bins"][2].erase("V"); }),
              "a.json: bins[2].V is missing");
    EXPECT_EQ(MessageAfter([](Json& json) { json["bins"][0]["count"] = -3; }),
              "a.json: bins[0].count = -3, must be >= 0");
    EXPECT_EQ(MessageAfter([](Json& json) { json["bins"][0]["bounce"][1]["p05"] = nullptr; }),
              "a.json: bins[0].bounce[1].p05 = null, must be a number, finite");
    EXPECT_EQ(MessageAfter([](Json& json) { json["bins"][1]["low"] = 0.2; }),
              "a.json: bins[1].low = 0.2, must be >= the high of the bin before it");
    EXPECT_EQ(MessageAfter([](Json& json) { json["bins"][1]["high"] = 0.1; }),
              "a.json: bins[1].high = 0.1, must be > low");
    EXPECT_EQ(MessageAfter([](Json& json) { json["bins"][2]["bounce"].erase(0); }),
              "a.json: bins[2].bounce: length = 2, must be 3");
    EXPECT_EQ(MessageAfter([](Json& json) { json["bins"][2]["total"].erase(0); }),
              "a.json: bins[2].total: length = 1, must be 2");
    EXPECT_EQ(MessageAfter([](Json& json) { json["spacing"] = 1; }),
              "a.json: spacing = 1: unknown field, must be one of surface, binned_by, "
              "albedos, bins");
}

}  // namespace
}  // namespace plumb
