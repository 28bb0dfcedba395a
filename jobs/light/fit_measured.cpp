#include "jobs/light/fit_measured.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/conventions.h"
#include "core/error.h"
#include "fit/direct_factor.h"
#include "fit/first_bounce.h"
#include "fit/model_fit.h"
#include "io/content_hash.h"
#include "io/csv.h"
#include "jobs/light/curves.h"

namespace plumb {
namespace {

bool Has(const NumberTable& table, const std::string& name) {
    return std::find(table.names.begin(), table.names.end(), name) != table.names.end();
}

// The abscissae and, for each bounce, the ordinates of the rows that hold something.
struct Curves {
    std::vector<double> alpha;
    std::vector<std::vector<double>> E;
};

Curves CurvesOf(const NumberTable& table, BinAbscissa abscissa) {
    const bool ours = Has(table, "alpha");
    const std::vector<double> x = Column(table, ours ? "alpha" : "bin");
    const std::vector<double> count =
        Has(table, "count") ? Column(table, "count") : std::vector<double>(x.size(), 1);
    const double shift = abscissa == BinAbscissa::kLeft     ? 0
                         : abscissa == BinAbscissa::kCentre ? 0.5
                                                            : 1;
    Curves curves;
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < x.size(); ++row) {
        if (count[row] == 0) continue;
        rows.push_back(row);
        curves.alpha.push_back(ours ? x[row] : (x[row] + shift) / double(x.size()));
    }
    const double open_ground = ours ? 1 : kOpenIrradiance;
    for (int k = 0; Has(table, "E" + std::to_string(k)); ++k) {
        const std::vector<double> all = Column(table, "E" + std::to_string(k));
        curves.E.emplace_back();
        for (const std::size_t row : rows) curves.E.back().push_back(all[row] / open_ground);
    }
    if (curves.E.size() < 2) throw Error("no columns E0 and E1: nothing to fit");
    return curves;
}

}  // namespace

FitReport FitMeasuredCurves(const std::filesystem::path& table, const MeasuredOptions& options,
                            const std::string& tool_version, const std::string& command) {
    FitReport report;
    report.provenance.tool_version = tool_version;
    report.provenance.command = command;
    report.provenance.weighting = "every bin the same";
    MapSource source;
    source.name = source.file = table.filename().string();
    source.sha256 = Sha256HexOfFile(table);
    report.provenance.maps.push_back(source);
    try {
        const Curves curves = CurvesOf(ReadCsv(table), options.abscissa);
        report.provenance.bounces = int(curves.E.size()) - 1;
        report.provenance.bins = int(curves.alpha.size());
        FitCurves(
            [&](int k) {
                return PairSamples(BinnedBy::kUniformVisibility, curves.alpha,
                                   curves.E[std::size_t(k)]);
            },
            int(curves.E.size()) - 1, {.starts = options.starts}, report);
    } catch (const Error& error) {
        const std::string text = error.what();
        throw Error(text.starts_with(table.string()) ? text : table.string() + ": " + text);
    }
    return report;
}

}  // namespace plumb
