// The truth of triangles, in a scene whose answer is known.
#include "jobs/truth/facet_truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "core/error.h"
#include "tests/jobs/made_scenes.h"

namespace plumb {
namespace {

std::vector<std::vector<std::string>> RowsOf(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        rows.emplace_back();
        for (std::string field; std::getline(fields, field, ',');) {
            rows.back().push_back(field);
        }
    }
    return rows;
}

// A unit square under another at the height 1, both facing each other; the upper one black to no
// one: a walk that meets it goes on.
Scene TwoSquares() {
    Scene scene;
    scene.name = "two squares";
    scene.materials.push_back({});
    AddFace(scene, {Vec3f(0, 0, 0), Vec3f(1, 0, 0), Vec3f(1, 1, 0), Vec3f(0, 1, 0)});
    AddFace(scene, {Vec3f(0, 0, 1), Vec3f(0, 1, 1), Vec3f(1, 1, 1), Vec3f(1, 0, 1)});
    return scene;
}

// Expected: of opposite unit squares 1 apart F = 0.19982 (the textbook's view factor,
// 2/pi (ln(sqrt(4/3)) + 2 sqrt(2) atan(1/sqrt 2) - pi/2)), so V = 1 - F on either, the mean over both
// triangles of a square; and E_1 = F V, E_2 = F^2 V if light were even over a square: within the
// square's own unevenness, 1 %. Tolerance: 4 standard errors of the mean of the four triangles.
TEST(FacetTruth, OfOppositeSquaresIsTheirFormFactor) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "plumb_facet_truth";
    const FacetTruthResult result =
        MeasureFacetTruth({TwoSquares(), {}, ""}, {.spp = 4096, .bounces = 2}, folder);
    EXPECT_EQ(result.triangles, 4);
    EXPECT_EQ(result.lost, 0);
    const double pi = std::acos(-1.0);
    const double F = 2 / pi *
                     (std::log(std::sqrt(4.0 / 3)) +
                      2 * std::sqrt(2.0) * std::atan(std::sqrt(0.5)) - pi / 2);
    EXPECT_NEAR(F, 0.19982, 1e-5);
    EXPECT_NEAR(result.mean_V, 1 - F, 4 * result.rms_error_V / 2);
    EXPECT_LT(result.rms_error_V, 0.005);

    const auto rows = RowsOf(result.csv);
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_EQ(rows[0],
              (std::vector<std::string>{
                  "triangle",    "area_m2",   "normal_x",  "normal_y", "normal_z",  "V",
                  "V_error",     "V_low",     "V_high",    "E_1",      "E_1_error", "E_1_low",
                  "E_1_high",    "E_2",       "E_2_error", "E_2_low",  "E_2_high",  "alpha",
                  "alpha_error", "alpha_low", "alpha_high"}));
    double E_1 = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        EXPECT_EQ(std::stod(rows[i][1]), 0.5);
        EXPECT_EQ(std::stod(rows[i][4]), i <= 2 ? 1 : -1);
        E_1 += std::stod(rows[i][9]) / 4;
    }
    EXPECT_NEAR(E_1, F * (1 - F), 0.01 * F + 4 * result.rms_error_V / 2);
    std::filesystem::remove_all(folder);
}

// Expected: from the table itself, by definition: the mean of V by area (triangles of 32 and of
// 2.4 m2), and the root of the mean square of the errors; each value within its interval.
TEST(FacetTruth, SummaryIsThatOfItsTable) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / "plumb_facet_summary";
    const FacetTruthResult result =
        MeasureFacetTruth({FloorAndWall(8, 8), {}, ""}, {.spp = 256}, folder);
    const auto rows = RowsOf(result.csv);
    ASSERT_EQ(rows.size(), 5u);
    double area = 0, V = 0, squares = 0;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const double a = std::stod(rows[i][1]);
        area += a;
        V += a * std::stod(rows[i][5]);
        squares += std::pow(std::stod(rows[i][6]), 2) / 4;
        EXPECT_LE(std::stod(rows[i][7]), std::stod(rows[i][5]));
        EXPECT_GE(std::stod(rows[i][8]), std::stod(rows[i][5]));
        EXPECT_LT(std::stod(rows[i][7]), std::stod(rows[i][8]));
    }
    EXPECT_NEAR(area, 64 + 4.8, 1e-5);
    EXPECT_NEAR(result.mean_V, V / area, 1e-12);
    EXPECT_NEAR(result.rms_error_V, std::sqrt(squares), 1e-12);
    std::filesystem::remove_all(folder);
}

TEST(FacetTruth, RefusesWhatItCannotMeasure) {
    EXPECT_THROW(Validate(FacetTruthJob{.spp = 100}), Error);
    EXPECT_THROW(Validate(FacetTruthJob{.spp = 8}), Error);
    EXPECT_THROW(Validate(FacetTruthJob{.bounces = -1}), Error);
    EXPECT_THROW(Validate(FacetTruthJob{.bounces = 101}), Error);
}

}  // namespace
}  // namespace plumb
