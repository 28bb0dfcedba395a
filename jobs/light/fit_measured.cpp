#include "jobs/light/fit_measured.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "core/conventions.h"
#include "core/error.h"
#include "fit/model_fit.h"
#include "fit/models/direct_factor.h"
#include "fit/models/first_bounce.h"
#include "io/content_hash.h"
#include "io/csv.h"
#include "jobs/light/curves.h"
#include "reports/text.h"

namespace plumb {
namespace {

bool Has(const NumberTable& table, const std::string& name) {
    return std::find(table.names.begin(), table.names.end(), name) != table.names.end();
}

// The abscissae and, for each bounce, the ordinates of the rows that hold something.
struct Curves {
    std::vector<double> alpha;
    std::vector<std::vector<double>> E;  ///< Over that of open ground.
    double open_ground = 1;              ///< In the table's unit.
};

// How far a row may be out of what a sky can send: noise, and where its bin's mean is not known,
// the width of the bin, over which alpha (2 - alpha) rises by at most 2.
constexpr double kOutOfBounds = 0.1;

double OpenGround(const NumberTable& table, const MeasuredOptions& options) {
    if (options.open_ground) return *options.open_ground;
    if (!Has(table, "alpha")) return kOpenIrradiance;
    if (Has(table, "E0_var")) return 1;
    throw Error(
        "has a column alpha, but is no histogram of plumb's own (E0_var is missing): nothing "
        "says what open ground receives in its unit; --open-ground pi or --open-ground 1 must");
}

/// Throws Error if some E0 cannot be that of its alpha.
void CheckUnit(const Curves& curves, double open_ground, double slack) {
    for (std::size_t i = 0; i < curves.alpha.size(); ++i) {
        const UniformVisibility alpha(curves.alpha[i]);
        const double V = curves.E[0][i], least = LeastCosineVisibility(alpha) - slack,
                     greatest = GreatestCosineVisibility(alpha) + slack;
        if (V >= least && V <= greatest) continue;
        throw Error(MustBe("E0 over that of open ground, taken to be " + Exact(open_ground) +
                               ", at alpha = " + Exact(alpha.value),
                           V,
                           "in [alpha^2, alpha (2 - alpha)] within " + Exact(slack) +
                               "; if the unit is another, --open-ground must say so"));
    }
}

Curves CurvesOf(const NumberTable& table, const MeasuredOptions& options) {
    const bool has_alpha = Has(table, "alpha");
    const BinAbscissa abscissa = options.abscissa;
    const std::vector<double> x = NumbersIn(table, has_alpha ? "alpha" : "bin");
    const std::vector<double> count =
        Has(table, "count") ? NumbersIn(table, "count") : std::vector<double>(x.size(), 1);
    const double shift = abscissa == BinAbscissa::kLeft     ? 0
                         : abscissa == BinAbscissa::kCentre ? 0.5
                                                            : 1;
    Curves curves;
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < x.size(); ++row) {
        if (count[row] == 0) continue;
        rows.push_back(row);
        curves.alpha.push_back(has_alpha ? x[row] : (x[row] + shift) / double(x.size()));
    }
    curves.open_ground = OpenGround(table, options);
    for (int k = 0; Has(table, "E" + std::to_string(k)); ++k) {
        const std::vector<double> all = NumbersIn(table, "E" + std::to_string(k));
        curves.E.emplace_back();
        for (const std::size_t row : rows)
            curves.E.back().push_back(all[row] / curves.open_ground);
    }
    if (curves.E.size() < 2) throw Error("no columns E0 and E1: nothing to fit");
    CheckUnit(curves, curves.open_ground,
              kOutOfBounds + (has_alpha ? 0 : 2 / double(x.size())));
    return curves;
}

}  // namespace

FitReport FitMeasuredCurves(const std::filesystem::path& table, const MeasuredOptions& options,
                            const RunContext& run) {
    FitReport report;
    report.provenance.tool_version = run.version;
    report.provenance.command = run.command;
    report.provenance.weighting = "every bin the same";
    MapSource source;
    source.name = source.file = table.filename().string();
    source.sha256 = Sha256HexOfFile(table);
    report.provenance.maps.push_back(source);
    try {
        const Curves curves = CurvesOf(ReadCsv(table), options);
        report.provenance.maps[0].preparation =
            "every E divided by that of open ground, " + Exact(curves.open_ground);
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
