// plumb simulate from heights to files: every figure in them against one worked out here from the
// light of the single facets.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/total_name.h"
#include "heightfield/facet.h"
#include "io/csv.h"
#include "io/histogram_io.h"
#include "io/image_io.h"
#include "jobs/light/simulate.h"
#include "jobs/write_document.h"
#include "reports/text.h"
#include "tests/reports/page_reader.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr int kBins = 12, kBounces = 3;

SimulateSettings Brief() {
    SimulateSettings settings;
    settings.slices.slices = 8;
    settings.bounces = kBounces;
    settings.bins = kBins;
    settings.albedos = {0.25, 0.5, 0.9};
    return settings;
}

std::string Slurp(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Position share (n - 1) among the sorted, between neighbours in proportion.
double PercentileByHand(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    const double position = share * double(values.size() - 1);
    const auto i = std::size_t(position);
    if (i + 1 == values.size()) return values.back();
    return values[i] + (position - double(i)) * (values[i + 1] - values[i]);
}

double Mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double x : values) sum += x;
    return sum / double(values.size());
}

/// The job run once, and the same light facet by facet.
class SimulateEndToEnd : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        // Of this process alone: CTest runs each test as one, side by side.
        folder = new fs::path(fs::path(testing::TempDir()) /
                              ("plumb_simulate_end_to_end_" + std::to_string(::getpid())));
        surface = new Surface(LoadSurface("make:cobbles:24"));
        SimulateJob job;
        job.settings = Brief();
        job.albedo = {0.9, 0.5, 0};
        job.sweep_amplitude = true;
        double now_s = 100;
        result = new SimulateReport(Simulate(*surface, job,
                                             {.version = "1.2.3",
                                              .command = "plumb simulate made",
                                              .clock = [&now_s] { return now_s += 0.25; },
                                              .folder = *folder}));
        bounces = new std::vector<std::vector<double>>;
        light = new SurfaceLight(
            SimulateSurface("cobbles", surface->field, Brief(), SilentMonitor(), nullptr, {},
                            {.bounce = [](int, std::span<const double> E_k) {
                                bounces->emplace_back(E_k.begin(), E_k.end());
                            }}));
        WriteDocument(*folder, DocumentOf(*result));
        html = new std::string(Slurp(*folder / "report.html"));
        json = new Json(Json::parse(Slurp(*folder / "report.json")));
    }
    static void TearDownTestSuite() {
        fs::remove_all(*folder);
        delete folder;
        delete surface;
        delete result;
        delete bounces;
        delete light;
        delete html;
        delete json;
    }

    /// E_0 ... E_K, then the totals.
    static std::vector<std::vector<double>> Quantities() {
        std::vector<std::vector<double>> all = *bounces;
        for (const auto& total : light->total) all.emplace_back(total.begin(), total.end());
        return all;
    }

    static std::vector<std::string> QuantityNames() {
        std::vector<std::string> names;
        for (int k = 0; k <= kBounces; ++k) names.push_back("E" + std::to_string(k));
        for (const double rho : light->albedos) names.push_back(TotalName(Albedo(rho)));
        return names;
    }

    inline static fs::path* folder;
    inline static Surface* surface;
    inline static SimulateReport* result;
    inline static std::vector<std::vector<double>>* bounces;
    inline static SurfaceLight* light;
    inline static std::string* html;
    inline static Json* json;
};

// Expected: count, means, variance and percentiles of the facets whose alpha (or V) falls into a
// bin, sorted and summed here. Tolerance: sums of some hundred numbers in another order.
TEST_F(SimulateEndToEnd, HistogramsAreThoseOfTheFacets) {
    for (const bool over_alpha : {true, false}) {
        const std::vector<double>& abscissa = over_alpha ? light->alpha : light->V;
        const NumberTable table =
            ReadCsv(*folder / (over_alpha ? "histogram_alpha.csv" : "histogram_v.csv"));
        ASSERT_EQ(int(table.rows.size()), kBins);
        int filled = 0;
        for (int b = 0; b < kBins; ++b) {
            std::vector<std::size_t> members;
            for (std::size_t i = 0; i < abscissa.size(); ++i) {
                if (std::min(int(abscissa[i] * kBins), kBins - 1) == b) members.push_back(i);
            }
            const auto cell = [&](const std::string& name) {
                return NumbersIn(table, name)[std::size_t(b)];
            };
            const auto of_members = [&](const std::vector<double>& all) {
                std::vector<double> some;
                for (const std::size_t i : members) some.push_back(all[i]);
                return some;
            };
            EXPECT_EQ(cell("bin"), b);
            EXPECT_NEAR(cell("low"), b / double(kBins), 1e-15);
            EXPECT_NEAR(cell("high"), (b + 1) / double(kBins), 1e-15);
            ASSERT_EQ(cell("count"), double(members.size()));
            if (members.empty()) continue;
            ++filled;
            EXPECT_NEAR(cell("alpha"), Mean(of_members(light->alpha)), 1e-13);
            EXPECT_NEAR(cell("V"), Mean(of_members(light->V)), 1e-13);
            for (std::size_t q = 0; q < QuantityNames().size(); ++q) {
                const std::string name = QuantityNames()[q];
                const std::vector<double> E = of_members(Quantities()[q]);
                const double mean = Mean(E);
                double squares = 0;
                for (const double e : E) squares += (e - mean) * (e - mean);
                EXPECT_NEAR(cell(name), mean, 1e-13) << name;
                const double n = double(E.size());
                EXPECT_NEAR(cell(name + "_var"), n > 1 ? squares / (n - 1) : 0, 1e-13) << name;
                EXPECT_NEAR(cell(name + "_p05"), PercentileByHand(E, 0.05), 1e-13) << name;
                EXPECT_NEAR(cell(name + "_p50"), PercentileByHand(E, 0.50), 1e-13) << name;
                EXPECT_NEAR(cell(name + "_p95"), PercentileByHand(E, 0.95), 1e-13) << name;
            }
        }
        EXPECT_GE(filled, kBins / 2);
    }
}

// Expected: plain means over facets. Page, terminal and JSON say the same.
TEST_F(SimulateEndToEnd, FiguresAreThoseOfTheFacets) {
    const auto figure = [](const std::string& key) { return FactIn(*json, key); };
    const auto n = light->V.size();
    double slope = 0, aperture = 0, waits = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec3 normal = FacetOf(surface->field, std::int64_t(i)).normal;
        slope += std::atan2(std::hypot(normal.x(), normal.y()), normal.z());
        aperture += light->V[i] / normal.z();
        double arrived = 0;
        for (const auto& E_k : *bounces) arrived += E_k[i];
        waits = std::max(waits, 1 - arrived);
    }
    const std::vector<std::pair<const char*, double>> expected{
        {"mean_uniform_visibility", Mean(light->alpha)},
        {"mean_cosine_visibility", Mean(light->V)},
        {"mean_first_bounce", Mean((*bounces)[1])},
        {"mean_slope_deg", slope / double(n) * 180 / 3.14159265358979323846},
        {"light_under_way", waits}};
    EXPECT_EQ(figure("facets"), n);
    for (const auto& [name, value] : expected)
        EXPECT_NEAR(figure(name).get<double>(), value, 1e-12 * (1 + value)) << name;
    EXPECT_NEAR(figure("aperture")["value"].get<double>(), aperture / double(n), 1e-12);
    EXPECT_LT(figure("max_furnace_error").get<double>(), 1e-6);

    const std::string terminal = ToTerminal(DocumentOf(*result));
    const auto said = [&](const std::string& title, double value, int digits) {
        const std::string text = Digits(value, digits);
        const std::size_t tile = html->find(">" + title + "</span>");
        ASSERT_NE(tile, std::string::npos) << title;
        EXPECT_EQ(html->substr(html->rfind("<b>", tile) + 3, text.size()), text) << title;
        const std::size_t at = terminal.find("  " + title + " ");
        ASSERT_NE(at, std::string::npos) << title;
        const std::string line = terminal.substr(at, terminal.find('\n', at) - at);
        EXPECT_NE(line.find(" " + text), std::string::npos) << line;
    };
    said("Mean α", expected[0].second, 5);
    said("Mean V", expected[1].second, 5);
    said("Mean E₁", expected[2].second, 5);
    said("Mean slope", expected[3].second, 3);
}

// Expected: the plots draw the columns of the CSV, rounded to six digits; the share of a bin is
// its count over all.
TEST_F(SimulateEndToEnd, PlotsShowTheHistograms) {
    const Json data = PlotDataOf(*html);
    for (const bool over_alpha : {true, false}) {
        const NumberTable table =
            ReadCsv(*folder / (over_alpha ? "histogram_alpha.csv" : "histogram_v.csv"));
        const Json keys{{"over", over_alpha ? "α" : "V"}};
        const std::vector<double> count = NumbersIn(table, "count");
        const auto filled = [&](const std::string& name) {
            std::vector<double> values;
            const std::vector<double> all = NumbersIn(table, name);
            for (std::size_t b = 0; b < all.size(); ++b)
                if (count[b] > 0) values.push_back(all[b]);
            return values;
        };
        int compared = 0;
        const auto same = [&](const std::vector<double>& drawn,
                              const std::vector<double>& expected, const std::string& what) {
            ASSERT_EQ(drawn.size(), expected.size()) << what;
            for (std::size_t i = 0; i < drawn.size(); ++i)
                EXPECT_NEAR(drawn[i], expected[i], 1e-5 * std::abs(expected[i]) + 1e-12)
                    << what;
            ++compared;
        };
        std::vector<double> shares;
        const double facets = double(light->V.size());
        for (const double n : filled("count")) shares.push_back(100 * n / facets);
        same(SeriesOf(data, "population", keys, "", "y"), shares, "population");
        const std::string x = over_alpha ? "alpha" : "V";
        for (const auto& [plot, name] :
             {std::pair{"visibility", "E0"}, std::pair{"first-bounce", "E1"}}) {
            const std::string E = name;
            same(SeriesOf(data, plot, keys, "mean", "x"), filled(x), plot);
            same(SeriesOf(data, plot, keys, "mean", "y"), filled(E), plot);
            same(SeriesOf(data, plot, keys, "median", "y"), filled(E + "_p50"), plot);
            same(SeriesOf(data, plot, keys, "5 to 95 % of facets", "y"), filled(E + "_p05"),
                 plot);
            same(SeriesOf(data, plot, keys, "5 to 95 % of facets", "high"), filled(E + "_p95"),
                 plot);
        }
        for (int k = 1; k <= kBounces; ++k)
            same(SeriesOf(data, "bounces", keys, "bounce " + std::to_string(k), "y"),
                 filled("E" + std::to_string(k)), "bounces");
        for (const double rho : light->albedos)
            same(SeriesOf(data, "totals", keys, "ρ = " + Exact(rho), "y"),
                 filled(TotalName(Albedo(rho))), "totals");
        EXPECT_EQ(compared, 1 + 2 * 5 + kBounces + 3);
        // The JSON of the page has them with all digits.
        const Json histogram = TableIn(*json, over_alpha ? "over_alpha" : "over_v")["values"];
        const auto numbers = [](const Json& list) { return list.get<std::vector<double>>(); };
        EXPECT_EQ(numbers(histogram["count"]), filled("count"));
        EXPECT_EQ(numbers(histogram["alpha"]), filled("alpha"));
        EXPECT_EQ(numbers(histogram["v"]), filled("V"));
        EXPECT_EQ(numbers(histogram["low"]), filled("low"));
        for (std::size_t q = 0; q < QuantityNames().size(); ++q) {
            const std::string name = QuantityNames()[q];
            const std::string key = "e" + name.substr(1);
            EXPECT_EQ(numbers(histogram[key]), filled(name));
            for (const char* ending : {"_var", "_p05", "_p50", "_p95"})
                EXPECT_EQ(numbers(histogram[key + ending]), filled(name + ending));
        }
        // And the histogram's own JSON.
        const BounceHistogram whole = ReadHistogramJson(
            *folder / (over_alpha ? "histogram_alpha.json" : "histogram_v.json"));
        EXPECT_EQ(whole.binned_by == BinnedBy::kUniformVisibility, over_alpha);
        EXPECT_EQ(whole.bins.back().total[2].p95, NumbersIn(table, "E_rho0p9_p95").back());
    }
}

// Expected: light.exr holds the mean of a cell's two facets; the light of a colour solves
// E = V + rho F E, of which rho = 0 leaves V, and grey 0.5 and 0.9 are totals of the simulation.
TEST_F(SimulateEndToEnd, ImagesHoldTheLightOfTheFacets) {
    const auto channel = [&](const char* file, const std::string& name) {
        for (NamedChannel& one : ReadChannels(*folder / file))
            if (one.name == name) return std::move(one.pixels);
        ADD_FAILURE() << "no channel " << name;
        return Image<float>();
    };
    const auto expect = [&](const Image<float>& image, const auto& facets, double tolerance) {
        ASSERT_EQ(image.Pixels().size() * 2, facets.size());
        for (std::size_t c = 0; c < image.Pixels().size(); ++c)
            ASSERT_NEAR(image.Pixels()[c],
                        (double(facets[2 * c]) + double(facets[2 * c + 1])) / 2, tolerance);
    };
    expect(channel("light.exr", "alpha"), light->alpha, 1e-6);
    expect(channel("light.exr", "V"), light->V, 1e-6);
    for (int k = 0; k <= kBounces; ++k)
        expect(channel("light.exr", "E_" + std::to_string(k)), (*bounces)[std::size_t(k)],
               1e-6);
    for (std::size_t r = 0; r < 3; ++r)
        expect(channel("light.exr", TotalName(Albedo(light->albedos[r]))), light->total[r],
               1e-6);
    expect(channel("light_albedo.exr", "R"), light->total[2], 1e-5);
    expect(channel("light_albedo.exr", "G"), light->total[1], 1e-5);
    expect(channel("light_albedo.exr", "B"), light->V, 1e-5);
}

// Expected: each amplitude is the simulation of the heights stretched here, mirrored as the study
// says. What the study must show [Mayaux18, "Effect of Maximum Height over the Curves"]: a flat
// map is open, V falls with every step, and a very deep one is almost closed.
TEST_F(SimulateEndToEnd, AmplitudesAreThoseOfTheStretchedMap) {
    const Json points = TableIn(*json, "amplitudes")["rows"];
    ASSERT_EQ(points.size(), 13u);
    const HeightField& field = surface->field;
    const double width_m =
        23 * field.SpacingXM();  // Mirrored: from first to last texel centre.
    const double relief_m = field.HighestM() - field.LowestM();
    for (const std::size_t k : {0u, 6u, 12u}) {
        const double share = std::pow(10.0, (double(k) - 9) / 3);
        EXPECT_NEAR(points[k]["amplitude_of_width"].get<double>(), share, 1e-12 * share);
        EXPECT_NEAR(points[k]["amplitude_m"].get<double>(), share * width_m, 1e-12 * share);
        Image<double> heights_m(field.Width(), field.Height());
        for (int j = 0; j < field.Height(); ++j) {
            for (int i = 0; i < field.Width(); ++i)
                heights_m(i, j) = field.LowestM() + (field.At(i, j) - field.LowestM()) /
                                                        relief_m * (share * width_m);
        }
        const SurfaceLight here = SimulateSurface(
            "", HeightField(heights_m, field.SpacingXM(), field.SpacingYM(), Boundary::kMirror),
            Brief());
        const Json& figures = points[k];
        EXPECT_NEAR(figures["mean_cosine_visibility"].get<double>(), Mean(here.V), 1e-9);
        EXPECT_NEAR(figures["mean_uniform_visibility"].get<double>(), Mean(here.alpha), 1e-9);
    }
    const Rows rows = TableOf(*html, {"Amplitude, of width", "Amplitude [m]", "Mean α"});
    ASSERT_EQ(rows.size(), 14u);
    double above = 1.1;
    for (std::size_t k = 0; k < 13; ++k) {
        const Json& figures = points[k];
        const double V = figures["mean_cosine_visibility"].get<double>();
        EXPECT_LT(V, above) << k;
        above = V;
        const std::vector<std::string>& row = rows[k + 1];
        EXPECT_EQ(row[0], Digits(points[k]["amplitude_of_width"].get<double>()));
        EXPECT_EQ(row[1], Digits(points[k]["amplitude_m"].get<double>()));
        EXPECT_EQ(row[2], Digits(figures["mean_uniform_visibility"].get<double>(), 5));
        EXPECT_EQ(row[3], Digits(V, 5));
        EXPECT_EQ(row[4], Digits(figures["mean_first_bounce"].get<double>(), 5));
    }
    EXPECT_GT(points[0]["mean_cosine_visibility"], 0.999);
    EXPECT_LT(points[12]["mean_cosine_visibility"], 0.1);
    // The plot of means and that of the first bounce draw the same points.
    const Json data = PlotDataOf(*html);
    const std::vector<double> x = SeriesOf(data, "amplitude-means", {}, "mean V", "x"),
                              V = SeriesOf(data, "amplitude-means", {}, "mean V", "y"),
                              alpha = SeriesOf(data, "amplitude-means", {}, "mean α", "y"),
                              first = SeriesOf(data, "amplitude-means", {}, "mean E₁", "y");
    for (std::size_t k = 0; k < 13; ++k) {
        const Json& figures = points[k];
        EXPECT_NEAR(x[k], 100 * points[k]["amplitude_of_width"].get<double>(), 1e-5 * x[k]);
        EXPECT_NEAR(V[k], figures["mean_cosine_visibility"].get<double>(), 1e-5);
        EXPECT_NEAR(alpha[k], figures["mean_uniform_visibility"].get<double>(), 1e-5);
        EXPECT_NEAR(first[k], figures["mean_first_bounce"].get<double>(), 1e-5);
    }
    const std::vector<double> curve = SeriesOf(data, "amplitude-curves", {}, "10 %", "y");
    const Json bins = TableIn(*json, "amplitude_histograms")["values"];
    std::vector<Json> means;
    for (std::size_t b = 0; b < bins["e1"].size(); ++b)
        if (bins["amplitude_of_width"][b] == "10 %") means.push_back(bins["e1"][b]);
    ASSERT_EQ(curve.size(), means.size());
    for (std::size_t b = 0; b < curve.size(); ++b)
        EXPECT_NEAR(curve[b], means[b].get<double>(), 1e-5);
}

// The clock of this test moves on by 1/4 s at every look: a stage lies between two looks.
TEST_F(SimulateEndToEnd, StagesLieBetweenTwoLooksAtTheClock) {
    const Json stages = TableIn(*json, "stages")["rows"];
    ASSERT_EQ(stages.size(), 3u);
    for (const Json& stage : stages) EXPECT_EQ(stage["seconds"], 0.25);
    EXPECT_EQ(stages[0]["stage"], "links");
    EXPECT_EQ(stages[2]["stage"], "furnace");
    EXPECT_EQ(FactIn(*json, "per_facet"), 8);
    EXPECT_EQ(FactIn(*json, "cut_texels"), kDefaultCut.extent_texels);
    EXPECT_EQ(FactIn(*json, "most_pieces"), kDefaultCut.most_pieces);
    EXPECT_EQ(FactIn(*json, "bounces"), kBounces);
    EXPECT_EQ(FactIn(*json, "bins"), kBins);
}

}  // namespace
}  // namespace plumb
