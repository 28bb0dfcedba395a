// plumb fit from maps to tables, studies on: every kind of figure against one worked out here from
// the light of the single facets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "jobs/light/amplitude_study.h"
#include "jobs/light/convergence_study.h"
#include "jobs/light/fit_constants.h"
#include "reports/render.h"
#include "reports/text.h"
#include "tests/jobs/stepping_clock.h"
#include "tests/reports/page_reader.h"

namespace plumb {
namespace {

constexpr int kBins = 40;

FitSettings Brief() {
    FitSettings settings;
    settings.simulate.slices.slices = 8;
    settings.simulate.bounces = 2;
    settings.simulate.bins = kBins;
    settings.starts = 2;
    settings.bootstrap_replicates = kFewestReplicates;
    settings.study_convergence = false;  // Below, with its own clock.
    return settings;
}

const char* const kMaps[] = {"make:bricks:24", "make:cobbles:24", "make:terrain:24",
                             "make:stone_wall:24"};

std::vector<Surface> Surfaces(std::size_t count) {
    std::vector<Surface> surfaces;
    for (std::size_t m = 0; m < count; ++m) surfaces.push_back(LoadSurface(kMaps[m]));
    return surfaces;
}

using ByHand = double (*)(double alpha, double V, double rho);

double PlainAlpha(double alpha, double, double) {
    return alpha;
}
double PlainV(double, double V, double) {
    return V;
}
double Cavity(double, double V, double rho) {
    return V / (1 - rho * (1 - V));
}
// [Jimenez16], the multi-bounce approximation.
double Cubic(double, double V, double rho) {
    const double a = 2.0404 * rho - 0.3324, b = -4.7951 * rho + 0.6417,
                 c = 2.7552 * rho + 0.6903;
    return std::max(V, ((V * a + b) * V + c) * V);
}
// [Mayaux18 eq. 12] under the guard of a port: alpha <= 0.999, both denominators >= 1e-5.
double Published(double alpha, double, double rho) {
    const double x = std::min(alpha, 0.999);
    const double F0 = x * (1 + std::pow(1 - x, 0.75) / 2);
    const double F1 = 27.576937094210385 * x * std::pow(1 - x, 1.5) *
                      std::exp(-3.3364392003423804 * std::pow(x, 0.25));
    const double tau = 1 - F1 / std::max(1 - F0, 1e-5);
    return F0 + rho * F1 / std::max(1 - rho * tau, 1e-5);
}

/// Mean over facets and albedos of (f at the bin's means - mean E of the bin)^2, bins cut by
/// `abscissa`: what a score of bin means is.
double RmsOfBins(ByHand f, const SurfaceLight& light, const std::vector<double>& abscissa) {
    struct Bin {
        double n = 0, alpha = 0, V = 0;
        std::vector<double> E;
    };
    std::map<int, Bin> bins;
    for (std::size_t i = 0; i < light.V.size(); ++i) {
        Bin& bin = bins[std::min(int(abscissa[i] * kBins), kBins - 1)];
        bin.E.resize(light.albedos.size());
        bin.n += 1;
        bin.alpha += light.alpha[i];
        bin.V += light.V[i];
        for (std::size_t r = 0; r < bin.E.size(); ++r) bin.E[r] += double(light.total[r][i]);
    }
    double sum = 0;
    for (const auto& [index, bin] : bins) {
        for (std::size_t r = 0; r < bin.E.size(); ++r) {
            const double d =
                f(bin.alpha / bin.n, bin.V / bin.n, light.albedos[r]) - bin.E[r] / bin.n;
            sum += bin.n * d * d;
        }
    }
    return std::sqrt(sum / double(light.V.size() * light.albedos.size()));
}

double RmsOfFacets(ByHand f, const SurfaceLight& light) {
    double sum = 0;
    for (std::size_t i = 0; i < light.V.size(); ++i) {
        for (std::size_t r = 0; r < light.albedos.size(); ++r) {
            const double d =
                f(light.alpha[i], light.V[i], light.albedos[r]) - double(light.total[r][i]);
            sum += d * d;
        }
    }
    return std::sqrt(sum / double(light.V.size() * light.albedos.size()));
}

class FitEndToEnd : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        surfaces = new std::vector<Surface>(Surfaces(4));
        report = new FitReport(
            FitConstants(*surfaces, Brief(), {.version = "1.2.3", .command = "plumb fit made"})
                .report);
        lights = new std::vector<SurfaceLight>;
        for (const Surface& surface : *surfaces)
            lights->push_back(
                SimulateSurface(surface.source.name, surface.field, Brief().simulate));
    }
    static void TearDownTestSuite() {
        delete surfaces;
        delete report;
        delete lights;
    }
    static const FormulaRecord& Named(const FitReport& of, const std::string& name) {
        return *std::find_if(of.formulas.begin(), of.formulas.end(),
                             [&](const FormulaRecord& record) { return record.name == name; });
    }

    inline static std::vector<Surface>* surfaces;
    inline static FitReport* report;
    inline static std::vector<SurfaceLight>* lights;
};

// Expected: the five formulas as their papers print them, on bins cut here. Tolerance: sums in
// another order.
TEST_F(FitEndToEnd, ScoresOfFormulasInPrint) {
    int shown = 0;
    struct Known {
        const char* name;
        ByHand f;
        bool over_V;
    };
    for (const Known& known :
         {Known{"plain alpha", PlainAlpha, false}, Known{"plain V", PlainV, true},
          Known{"cavity", Cavity, true}, Known{"GTAO cubic", Cubic, true},
          Known{"Mayaux18, guard 1e-5", Published, false}}) {
        const FormulaRecord& record = Named(*report, known.name);
        double squares = 0, facet_squares = 0;
        for (std::size_t m = 0; m < 4; ++m) {
            const SurfaceLight& light = (*lights)[m];
            const double rms = RmsOfBins(known.f, light, known.over_V ? light.V : light.alpha);
            EXPECT_NEAR(record.in_sample.maps[m].rms, rms, 1e-9) << known.name << m;
            EXPECT_NEAR(record.facet_rms[m], RmsOfFacets(known.f, light), 1e-9) << known.name;
            squares += rms * rms;
            facet_squares += record.facet_rms[m] * record.facet_rms[m];
        }
        EXPECT_NEAR(record.in_sample.pooled.rms, std::sqrt(squares / 4), 1e-9) << known.name;
        EXPECT_FALSE(record.fitted);
        // The table of the page: formula, reads, constants, RMS, held out, a facet ...
        const Rows rows = TableOf(ToHtml(DocumentOf(*report)),
                                  {"Formula", "", "Reads", "Constants fitted", "RMS ↓"});
        for (const auto& row : rows) {
            if (row[0] != known.name) continue;
            EXPECT_EQ(row[2], known.over_V ? "V" : "α");
            EXPECT_EQ(row[4], Digits(std::sqrt(squares / 4)));
            EXPECT_EQ(row[5], row[4]);
            EXPECT_EQ(row[6], Digits(std::sqrt(facet_squares / 4)));
            ++shown;
        }
    }
    EXPECT_EQ(shown, 5);
}

// Expected: of V, the scatter of the facets of a bin about its mean, bins of two facets or more;
// no function of V can do better on them.
TEST_F(FitEndToEnd, FloorsAreTheScatterWithinBins) {
    for (std::size_t m = 0; m < 4; ++m) {
        const SurfaceLight& light = (*lights)[m];
        for (const bool of_V : {true, false}) {
            const std::vector<double>& abscissa = of_V ? light.V : light.alpha;
            std::vector<std::vector<std::size_t>> bins(kBins);
            for (std::size_t i = 0; i < abscissa.size(); ++i)
                bins[std::size_t(std::min(int(abscissa[i] * kBins), kBins - 1))].push_back(i);
            double all = 0;
            for (std::size_t r = 0; r < light.albedos.size(); ++r) {
                double sum = 0, n = 0;
                for (const auto& bin : bins) {
                    if (bin.size() < 2) continue;
                    double mean = 0, squares = 0;
                    for (const std::size_t i : bin) mean += double(light.total[r][i]);
                    mean /= double(bin.size());
                    for (const std::size_t i : bin)
                        squares += std::pow(double(light.total[r][i]) - mean, 2);
                    n += double(bin.size());
                    sum += double(bin.size()) * squares / double(bin.size() - 1);
                }
                all += sum / n;
            }
            EXPECT_NEAR(of_V ? report->floors[m].of_V : report->floors[m].of_alpha,
                        std::sqrt(all / double(light.albedos.size())), 1e-9);
        }
        EXPECT_LT(report->floors[m].of_both, report->floors[m].of_V);
    }
}

// Expected: held out of two maps, a map is scored by the constants that the other one alone gives;
// a run on that one alone has them. Tolerance: both fits end within the solver's tolerance.
TEST_F(FitEndToEnd, HeldOutScoresAreOfConstantsThatNeverSawTheMap) {
    FitSettings settings = Brief();
    settings.study_amplitude = false;
    const std::vector<Surface> pair{(*surfaces)[0], (*surfaces)[2]};
    const FitReport both = FitConstants(pair, settings, {}).report;
    int compared = 0;
    double apart = 0;
    for (const std::size_t alone : {0u, 1u}) {
        const FitReport one =
            FitConstants(std::span(pair).subspan(alone, 1), settings, {}).report;
        for (const char* name : {"escape of V, refitted", "bent escape of V, refitted"}) {
            const FormulaRecord& learnt = Named(one, name);
            const std::size_t other = 1 - alone;
            const Score expected = ScoreOf(learnt.formula, (*lights)[2 * other].over_V);
            EXPECT_NEAR(Named(both, name).held_out->maps[other].rms, expected.rms, 2e-5)
                << name;
            apart = std::max(
                apart, std::abs(expected.rms - Named(both, name).in_sample.maps[other].rms));
            ++compared;
        }
    }
    EXPECT_EQ(compared, 4);
    EXPECT_GT(apart, 1e-4);  // Or constants that saw the map would pass too.
}

// Expected: least squares is a minimum: any step of a constant raises the error that was
// minimized, worked out here on bins of V, all maps the same say.
TEST_F(FitEndToEnd, TheRefittedConstantsAreTheMinimum) {
    for (const char* name : {"escape of V, refitted", "GTAO cubic, refitted"}) {
        const FormulaRecord& record = Named(*report, name);
        const auto error = [&](const std::vector<double>& p) {
            double sum = 0;
            for (const SurfaceLight& light : *lights) {
                Formula formula = record.formula;
                formula.values = p;
                const double rms = ScoreOf(formula, light.over_V).rms;
                sum += rms * rms;
            }
            return sum;
        };
        const double least = error(record.formula.values);
        for (std::size_t j = 0; j < record.formula.values.size(); ++j) {
            for (const double step : {-1e-3, 1e-3}) {
                std::vector<double> p = record.formula.values;
                p[j] += step;
                EXPECT_GT(error(p), least) << name << j;
            }
        }
        EXPECT_NEAR(std::sqrt(least / 4), record.in_sample.pooled.rms, 1e-9);
    }
    // Fitted to these maps, the cubic has less error there than as published.
    EXPECT_LT(Named(*report, "GTAO cubic, refitted").in_sample.pooled.rms,
              Named(*report, "GTAO cubic").in_sample.pooled.rms);
}

// Expected: the study of one map stretches the first; its scores are those of the formulas in the
// score table, at each amplitude, of which the published one is worked out here.
TEST_F(FitEndToEnd, TheAmplitudesAreScoredByTheFormulasOfTheTable) {
    ASSERT_TRUE(report->amplitudes);
    EXPECT_EQ(report->amplitudes->map, "bricks");
    ASSERT_EQ(report->amplitudes->points.size(), 13u);
    const HeightField first = MiddleOf(surfaces->front().field, 64);
    for (const std::size_t k : {3u, 6u, 10u}) {
        const AmplitudePoint& point = report->amplitudes->points[k];
        const SurfaceLight here =
            SimulateSurface("", WithAmplitude(first, point.amplitude_m), Brief().simulate);
        EXPECT_NEAR(point.published_rms, RmsOfBins(Published, here, here.alpha), 1e-9);
        EXPECT_NEAR(point.recommended_rms,
                    ScoreOf(Named(*report, report->recommended).formula, here.over_both).rms,
                    1e-9);
        EXPECT_NE(point.recommended_rms, point.published_rms);
    }
    const Rows rows = TableOf(ToHtml(DocumentOf(*report)), {"Amplitude, of width"});
    ASSERT_EQ(rows.size(), 14u);
    EXPECT_EQ(rows[0][5], "RMS recommended ↓");
    for (std::size_t k = 0; k < 13; ++k) {
        EXPECT_EQ(rows[k + 1][5], Digits(report->amplitudes->points[k].recommended_rms));
        EXPECT_EQ(rows[k + 1][6], Digits(report->amplitudes->points[k].published_rms));
    }
}

TEST_F(FitEndToEnd, TheFormIsChosenOnTheFirstAndTheThirdMap) {
    ASSERT_TRUE(report->choice);
    EXPECT_EQ(report->choice->choosing, (std::vector<std::string>{"bricks", "terrain"}));
    EXPECT_EQ(report->choice->reporting, (std::vector<std::string>{"cobbles", "stone_wall"}));
    const auto rms = [&](std::size_t m) {
        return RmsOfBins(Cavity, (*lights)[m], (*lights)[m].V);
    };
    const FormScore& cavity = report->choice->forms.front();
    EXPECT_EQ(cavity.form, "cavity");
    EXPECT_NEAR(cavity.choosing_rms, std::sqrt((std::pow(rms(0), 2) + std::pow(rms(2), 2)) / 2),
                1e-9);
    EXPECT_NEAR(cavity.reporting_rms,
                std::sqrt((std::pow(rms(1), 2) + std::pow(rms(3), 2)) / 2), 1e-9);
}

// What is printed of the recommended formula in the header is what the table says of it.
TEST_F(FitEndToEnd, TheShaderHeaderHasTheConstantsOfTheTable) {
    const ShaderHeader header = ShaderHeaderOf(*report);
    const FormulaRecord& ours = Named(*report, report->recommended);
    EXPECT_EQ(header.recommended.formula.values, ours.formula.values);
    EXPECT_EQ(header.recommended.rms, ours.in_sample.pooled.rms);
    EXPECT_EQ(header.recommended.held_out_rms, ours.held_out->pooled.rms);
    EXPECT_EQ(header.published_rms,
              Named(*report, "Mayaux18, guard 1e-5").in_sample.pooled.rms);
    const std::map<std::string, std::string> functions{
        {"PlumbTotalOfV", "bent escape of V, refitted"},
        {"PlumbEscapeOfV", "escape of V, refitted"},
        {"PlumbEscapeOfAlpha", "escape of alpha, clamped, refitted"},
        {"PlumbGtaoCubicRefitted", "GTAO cubic, refitted"},
        {"PlumbMayaux18Refitted", "Mayaux18, guard 1e-5, curves refitted"}};
    ASSERT_EQ(header.alternatives.size(), functions.size());
    for (const ShaderFormula& one : header.alternatives) {
        EXPECT_EQ(one.formula.name, functions.at(one.function));
        EXPECT_EQ(one.rms, Named(*report, one.formula.name).in_sample.pooled.rms);
    }
    const std::string text = WriteShaderHeader(header, ShaderLanguage::kHlsl);
    EXPECT_EQ(text.find("least error on maps that it has not seen"), std::string::npos);
}

// Expected, by hand: three counts in turns, three rounds after one that warms up: count t of round r
// takes 3 r + t + 1 seconds.
TEST(ConvergenceStudy, TakesTheMedianOfRoundsInTurns) {
    const HeightField field = LoadSurface("make:bricks:8").field;
    ConvergenceSettings settings;
    settings.slices = {4, 8};
    settings.rays = {16};
    settings.reference_slices = 16;
    settings.rounds = 3;
    const Convergence study = StudyConvergence("bricks", field, settings, SteppingClock());
    ASSERT_EQ(study.points.size(), 3u);
    for (int t = 0; t < 3; ++t) {
        const Measured& seconds = study.points[std::size_t(t)].seconds;
        EXPECT_EQ(seconds.value, 7 + t);
        EXPECT_EQ(seconds.interval.low, 4 + t);
        EXPECT_EQ(seconds.interval.high, 10 + t);
    }
    EXPECT_EQ(study.facets, field.Facets());
}

// What it must show: errors fall with the count, of rays as 1 / sqrt(n) or faster, and each error
// is that of the light against a reference of another seed, cut three times as fine, worked out here.
// Tolerance: the references' own errors, below a third of those that are judged.
TEST(ConvergenceStudy, ErrorsAreAgainstABetterReference) {
    const HeightField field = LoadSurface("make:cobbles:16").field;
    ConvergenceSettings settings;
    settings.rounds = 1;
    const Convergence study = StudyConvergence("cobbles", field, settings, [] { return 0.0; });
    ASSERT_EQ(study.points.size(), 7u);
    SimulateSettings best;
    best.slices.slices = 512;
    best.slices.seed = 77;
    best.bounces = 0;
    best.albedos = {0.5};
    SimulateSettings finer = best;
    finer.cut = {.extent_texels = 0.5, .most_pieces = 24};
    const SurfaceLight reference = SimulateSurface("", field, finer);
    const char* methods[] = {"slices", "slices", "slices", "slices", "rays", "rays", "rays"};
    const int counts[] = {4, 8, 16, 32, 16, 64, 256};
    for (std::size_t p = 0; p < 7; ++p) {
        const ConvergencePoint& point = study.points[p];
        EXPECT_EQ(point.method, methods[p]);
        EXPECT_EQ(point.per_facet, counts[p]);
        SimulateSettings here = best;
        here.method = p < 4 ? LinkMethod::kSlices : LinkMethod::kRays;
        here.slices = {};
        here.slices.slices = here.rays.rays = counts[p];
        const SurfaceLight light = SimulateSurface("", field, here);
        double V = 0, E = 0, worst = 0;
        for (std::size_t i = 0; i < light.V.size(); ++i) {
            const double d = light.V[i] - reference.V[i];
            V += d * d;
            E += std::pow(double(light.total[0][i]) - double(reference.total[0][i]), 2);
            worst = std::max(worst, std::abs(d));
        }
        const double n = double(light.V.size());
        EXPECT_NEAR(point.rms_V, std::sqrt(V / n), 0.34 * point.rms_V) << p;
        EXPECT_NEAR(point.rms_E_half, std::sqrt(E / n), 0.34 * point.rms_E_half) << p;
        EXPECT_NEAR(point.max_abs_V, worst, 0.34 * point.max_abs_V) << p;
        EXPECT_GT(point.max_abs_V, point.rms_V);
        EXPECT_NE(point.rms_V, point.rms_E_half);
    }
    for (const std::size_t p : {1u, 2u, 3u})
        EXPECT_LT(study.points[p].rms_V, 0.75 * study.points[p - 1].rms_V);
    for (const std::size_t p : {5u, 6u})  // Four times the rays: half the error, or less.
        EXPECT_LT(study.points[p].rms_V, 0.55 * study.points[p - 1].rms_V);
}

// Root mean square difference of E(1/2), over facets.
double RmsOfTotal(const SurfaceLight& a, const SurfaceLight& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.V.size(); ++i) {
        sum += std::pow(double(a.total[0][i]) - double(b.total[0][i]), 2);
    }
    return std::sqrt(sum / double(a.V.size()));
}

// What the cut costs belongs to the error: light is of second order in the strips of a wall
// (PiecesOfATrench.LightConvergesWithTheCut), so that strips of 1.5 texels differ from strips a third
// as high by 1 - 1/9 of their error, from strips a sixth as high by 1 - 1/36, and from strips alike by
// nothing but the slices' own scatter.
TEST(ConvergenceStudy, CountsWhatTheCutCosts) {
    const HeightField field = LoadSurface("make:bricks:32").field;
    ConvergenceSettings settings;
    settings.slices = {512};
    settings.rays = {};
    settings.reference_slices = 512;
    settings.rounds = 1;
    const Convergence study = StudyConvergence("bricks", field, settings, [] { return 0.0; });
    SimulateSettings judged;
    judged.slices.slices = 512;
    judged.bounces = 0;
    judged.albedos = {0.5};
    SimulateSettings alike = judged, finer = judged, finest = judged;
    alike.slices.seed = finer.slices.seed = finest.slices.seed = 77;
    finer.cut = {.extent_texels = 0.5, .most_pieces = 24};
    finest.cut = {.extent_texels = 0.25, .most_pieces = 48};
    const SurfaceLight light = SimulateSurface("", field, judged);
    const double of_alike = RmsOfTotal(light, SimulateSurface("", field, alike)),
                 of_finer = RmsOfTotal(light, SimulateSurface("", field, finer)),
                 of_finest = RmsOfTotal(light, SimulateSurface("", field, finest));
    EXPECT_NEAR(study.points[0].rms_E_half, of_finer, 0.1 * of_finer);
    EXPECT_NEAR(of_finer / of_finest, (1 - 1. / 9) / (1 - 1. / 36), 0.06);
    EXPECT_GT(study.points[0].rms_E_half, 5 * of_alike);
}

// The study works on a piece of a large map, and its width is that of the piece: the page says so.
TEST(AmplitudeStudy, NamesThePieceThatItWorksOn) {
    const HeightField field = LoadSurface("make:bricks:24").field;
    EXPECT_EQ(NameOfMiddle("bricks", field, 24), "bricks");
    EXPECT_EQ(NameOfMiddle("bricks", field, 16), "bricks, its middle 16 x 16 texels");
}

// 0.1 % to 1000 % of the width, three a decade: 10^(k/3).
TEST(AmplitudeStudy, SweepsFourDecades) {
    const std::vector<double> shares = SweptAmplitudes();
    ASSERT_EQ(shares.size(), 13u);
    EXPECT_NEAR(shares.front(), 0.001, 1e-15);
    EXPECT_NEAR(shares[6], 0.1, 1e-15);
    EXPECT_NEAR(shares.back(), 10, 1e-12);
    for (std::size_t k = 1; k < 13; ++k)
        EXPECT_NEAR(shares[k] / shares[k - 1], std::cbrt(10.0), 1e-12);
}

}  // namespace
}  // namespace plumb
