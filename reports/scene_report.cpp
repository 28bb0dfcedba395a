#include "reports/scene_report.h"

#include <cmath>

#include "core/error.h"
#include "reports/text.h"

namespace plumb {

const ScoreAgainst& Against(const std::vector<ScoreAgainst>& scores, const std::string& truth,
                            const std::string& region) {
    for (const ScoreAgainst& score : scores) {
        if (score.truth == truth && score.region == region) return score;
    }
    throw Error("no score against \"" + truth + "\", region \"" + region + "\"");
}

const ScoreAgainst& TechniqueScore::Against(const std::string& truth,
                                            const std::string& region) const {
    return plumb::Against(scores, truth, region);
}

namespace {

std::string Line(const std::vector<std::string>& fields) {
    std::string line;
    for (const std::string& field : fields) {
        if (!line.empty()) line += ',';
        line += field;
    }
    return line + '\n';
}

void AddLines(const TechniqueScore& t, const std::string& view,
              const std::vector<ScoreAgainst>& scores, std::string& csv) {
    for (const ScoreAgainst& s : scores) {
        const ErrorScore& e = s.error;
        std::vector<std::string> fields{Csv(t.name),
                                        std::to_string(t.samples),
                                        Exact(t.seconds.value),
                                        Exact(t.seconds.interval.low),
                                        Exact(t.seconds.interval.high),
                                        Csv(view),
                                        Csv(s.truth),
                                        Csv(s.region),
                                        std::to_string(e.pixels)};
        for (const Measured* f : {&e.bias, &e.mae, &e.rmse, &e.psnr_db, &e.psnr_paper_db,
                                  &s.ssim, &s.recalibrated_rmse}) {
            fields.push_back(Exact(f->value));
            fields.push_back(Exact(f->interval.low));
            fields.push_back(Exact(f->interval.high));
        }
        csv += Line(fields);
    }
}

}  // namespace

std::string ScoresCsv(const SceneReport& r) {
    std::string csv =
        "technique,samples,seconds,seconds_least,seconds_greatest,view,truth,region,pixels";
    for (const char* figure :
         {"bias", "mae", "rmse", "psnr_db", "psnr_paper_db", "ssim", "recalibrated_rmse"}) {
        csv += std::string(",") + figure + "," + figure + "_low," + figure + "_high";
    }
    csv += "\n";
    for (const TechniqueScore& t : r.techniques) {
        AddLines(t, kAllViews, t.scores, csv);
        for (const ViewScores& view : t.views) AddLines(t, view.camera, view.scores, csv);
    }
    return csv;
}

std::string SweepCsv(const SceneReport& r) {
    std::string csv =
        "technique,setting,seconds,seconds_least,seconds_greatest,rmse,rmse_low,rmse_high,"
        "recalibrated_rmse,recalibrated_rmse_low,recalibrated_rmse_high,pareto\n";
    for (const SweepPoint& p : r.sweep) {
        std::vector<std::string> fields{Csv(p.technique), Csv(p.setting),
                                        Exact(p.seconds.value), Exact(p.seconds.interval.low),
                                        Exact(p.seconds.interval.high)};
        for (const Measured* f : {&p.rmse, &p.recalibrated_rmse}) {
            fields.push_back(Exact(f->value));
            fields.push_back(Exact(f->interval.low));
            fields.push_back(Exact(f->interval.high));
        }
        fields.push_back(p.on_front ? "yes" : "no");
        csv += Line(fields);
    }
    return csv;
}

std::string WithInterval(const Measured& figure, int significant, double scale) {
    const std::string value = Digits(scale * figure.value, significant);
    if (!std::isfinite(figure.interval.low) || !std::isfinite(figure.interval.high)) {
        return value;
    }
    return value + " (" + Digits(scale * figure.interval.low, significant) + " to " +
           Digits(scale * figure.interval.high, significant) + ")";
}

std::string WithTies(const Closest& closest) {
    if (closest.ties.empty()) return closest.name;
    return closest.name + " (not told apart from it: " + Listed(closest.ties) + ")";
}

std::string ViewsText(const SceneReport& r) {
    std::vector<std::string> names;
    for (const SceneView& view : r.views) names.push_back(view.camera);
    return (r.views.size() == 1 ? "camera " : "cameras ") + Listed(names);
}

void WriteTable(std::ostream& out, const SceneReport& r) {
    const SceneView& first = r.views.front();
    out << r.scene << ", " << ViewsText(r) << ", " << first.width_px << " x " << first.height_px
        << ", radius " << Digits(r.radius_m) << " m; truth of " << first.truth.spp
        << " rays a pixel\n\n";
    out << Left("technique", 20) << Right("lookups", 8) << Right("ms", 9) << Right("bias", 18)
        << Right("RMSE (95 %)", 26) << Right("PSNR", 8) << Right("SSIM", 8)
        << Right("recal.", 9) << "\n";
    for (const TechniqueScore& t : r.techniques) {
        const ScoreAgainst& s = t.Against("V within r");
        out << Left(t.name, 20) << Right(std::to_string(t.samples), 8)
            << Right(Digits(t.seconds.value * 1e3), 9)
            << Right(WithError(s.error.bias.value, s.error.bias.standard_error), 18)
            << Right(WithInterval(s.error.rmse), 26)
            << Right(Digits(s.error.psnr_db.value, 4), 8) << Right(Digits(s.ssim.value), 8)
            << Right(Digits(s.recalibrated_rmse.value), 9) << "\n";
    }
    out << "\nagainst V within r, intervals "
        << (r.views.size() > 1 ? "between views" : "over tiles of the one view")
        << "; recal.: RMSE after the best monotone change of contrast\n"
        << "closest: " << WithTies(r.closest) << "\n"
        << "closest in shape: " << WithTies(r.closest_recalibrated) << "\n";
    if (!r.cheapest.name.empty()) {
        out << "cheapest within " << Digits(100 * r.cheapest_within, 2)
            << " % of the least error: " << WithTies(r.cheapest) << "\n";
    }
}

}  // namespace plumb
