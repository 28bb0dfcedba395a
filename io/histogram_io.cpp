#include "io/histogram_io.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/total_name.h"
#include "io/json_file.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

const std::string kUniform = "uniform_visibility", kCosine = "cosine_visibility";

void RefuseEmpty(const BounceHistogram& histogram, const std::string& name) {
    const bool empty = std::all_of(histogram.bins.begin(), histogram.bins.end(),
                                   [](const BounceBin& bin) { return bin.count == 0; });
    if (empty) throw Error(name + ": is a histogram without a facet, must have at least one");
}

/// "histogram of brick_wall": what errors call one that is in no file yet.
std::string NameOf(const BounceHistogram& histogram) {
    return "histogram of " + histogram.surface;
}

Json ToJson(const std::vector<Spread>& spreads) {
    Json list = Json::array();
    for (const Spread& s : spreads) {
        list.push_back({{"mean", s.mean},
                        {"variance", s.variance},
                        {"p05", s.p05},
                        {"p50", s.p50},
                        {"p95", s.p95}});
    }
    return list;
}

std::string At(const std::string& list, std::size_t index) {
    return list + "[" + std::to_string(index) + "]";
}

std::vector<Spread> SpreadsFromJson(const Json& list, const std::string& file,
                                    const std::string& at) {
    std::vector<Spread> spreads;
    for (std::size_t k = 0; k < list.size(); ++k) {
        JsonFields fields(list[k], file, At(at, k));
        spreads.push_back({.mean = fields.NeedNumber("mean", kFinite),
                           .variance = fields.NeedNumber("variance", kNotNegative),
                           .p05 = fields.NeedNumber("p05", kFinite),
                           .p50 = fields.NeedNumber("p50", kFinite),
                           .p95 = fields.NeedNumber("p95", kFinite)});
        fields.Finish();
    }
    return spreads;
}

BounceBin BinFromJson(const Json& json, const std::string& file, const std::string& at) {
    JsonFields fields(json, file, at);
    BounceBin bin{.low = fields.NeedNumber("low", kFinite),
                  .high = fields.NeedNumber("high", kFinite),
                  .count = fields.NeedCount("count"),
                  .alpha = fields.NeedNumber("alpha", kFinite),
                  .V = fields.NeedNumber("V", kFinite),
                  .bounce = SpreadsFromJson(fields.NeedList("bounce"), file, at + ".bounce"),
                  .total = SpreadsFromJson(fields.NeedList("total"), file, at + ".total")};
    fields.Finish();
    if (!(bin.low < bin.high)) throw Error(MustBe(fields.NameOf("high"), bin.high, "> low"));
    return bin;
}

void CheckBins(const BounceHistogram& histogram, const std::string& file) {
    const auto check_size = [&](std::size_t b, const char* what, std::size_t size,
                                std::size_t rule) {
        if (size == rule) return;
        throw Error(MustBe(file + ": " + At("bins", b) + "." + what + ": length", double(size),
                           std::to_string(rule)));
    };
    for (std::size_t b = 0; b < histogram.bins.size(); ++b) {
        const BounceBin& bin = histogram.bins[b];
        check_size(b, "bounce", bin.bounce.size(), histogram.bins.front().bounce.size());
        check_size(b, "total", bin.total.size(), histogram.albedos.size());
        if (b > 0 && bin.low < histogram.bins[b - 1].high) {
            throw Error(MustBe(file + ": " + At("bins", b) + ".low", bin.low,
                               ">= the high of the bin before it"));
        }
    }
    if (histogram.Bounces() < 0) throw Error(file + ": bins[0].bounce has no E0");
}

void AppendNames(std::vector<std::string>& names, const std::string& name) {
    for (const char* suffix : {"", "_var", "_p05", "_p50", "_p95"}) {
        names.push_back(name + suffix);
    }
}

void AppendNumbers(std::vector<double>& row, const Spread& s) {
    row.insert(row.end(), {s.mean, s.variance, s.p05, s.p50, s.p95});
}

}  // namespace

Json ToJson(const BounceHistogram& histogram) {
    RefuseEmpty(histogram, NameOf(histogram));
    const bool uniform = histogram.binned_by == BinnedBy::kUniformVisibility;
    Json bins = Json::array();
    for (const BounceBin& bin : histogram.bins) {
        bins.push_back({{"low", bin.low},
                        {"high", bin.high},
                        {"count", bin.count},
                        {"alpha", bin.alpha},
                        {"V", bin.V},
                        {"bounce", ToJson(bin.bounce)},
                        {"total", ToJson(bin.total)}});
    }
    return {{"surface", histogram.surface},
            {"binned_by", uniform ? kUniform : kCosine},
            {"albedos", histogram.albedos},
            {"bins", bins}};
}

BounceHistogram HistogramFromJson(const Json& json, const std::string& name) {
    JsonFields fields(json, name);
    BounceHistogram histogram{
        .surface = fields.NeedText("surface"),
        .binned_by = fields.NeedOneOf("binned_by", {kUniform, kCosine}) == kUniform
                         ? BinnedBy::kUniformVisibility
                         : BinnedBy::kCosineVisibility,
        .albedos = fields.NeedNumbers("albedos", kShare),
        .bins = {}};
    const Json& bins = fields.NeedList("bins");
    for (std::size_t b = 0; b < bins.size(); ++b) {
        histogram.bins.push_back(BinFromJson(bins[b], name, At("bins", b)));
    }
    fields.Finish();
    RefuseEmpty(histogram, name);
    CheckBins(histogram, name);
    return histogram;
}

NumberTable ToTable(const BounceHistogram& histogram) {
    RefuseEmpty(histogram, NameOf(histogram));
    NumberTable table{.names = {"bin", "low", "high", "count", "alpha", "V"}, .rows = {}};
    for (int k = 0; k <= histogram.Bounces(); ++k) {
        AppendNames(table.names, std::string("E").append(std::to_string(k)));
    }
    for (double rho : histogram.albedos) AppendNames(table.names, TotalName(Albedo(rho)));
    for (std::size_t b = 0; b < histogram.bins.size(); ++b) {
        const BounceBin& bin = histogram.bins[b];
        std::vector<double>& row = table.rows.emplace_back();
        row = {double(b), bin.low, bin.high, double(bin.count), bin.alpha, bin.V};
        for (const Spread& spread : bin.bounce) AppendNumbers(row, spread);
        for (const Spread& spread : bin.total) AppendNumbers(row, spread);
    }
    return table;
}

void WriteHistogramJson(const std::filesystem::path& path, const BounceHistogram& histogram) {
    WriteJsonFile(path, ToJson(histogram));
}

void WriteHistogramCsv(const std::filesystem::path& path, const BounceHistogram& histogram) {
    const char* axis = histogram.binned_by == BinnedBy::kUniformVisibility ? "alpha" : "V";
    WriteCsv(path, ToTable(histogram),
             {"Light on " + histogram.surface + ", facets binned by " + axis +
                  "; unit white sky, every E divided by that of open ground.",
              "E<k>: light after k bounces at albedo 1; E_rho<r>: all bounces at albedo r (p "
              "for the "
              "point); _var "
              "variance of a facet, _p05 _p50 _p95 percentiles."});
}

BounceHistogram ReadHistogramJson(const std::filesystem::path& path) {
    return HistogramFromJson(ReadJsonFile(path), path.string());
}

}  // namespace plumb
