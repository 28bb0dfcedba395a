// What the depth buffer keeps, as the study tells it, against plain loops over the same pictures.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "scenes/simple.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/normal_precision.h"
#include "tests/jobs/read_results.h"

namespace plumb {
namespace {

// Expected: each row from a picture drawn here as its names say. z where both show the same triangle
// and a normal is judged; of the normals' errors the root mean square, the greatest, and the one below
// which 99 % and 99.9 % lie, between the two next to it in order.
TEST(DepthStudy, HasTheErrorsOfThePicturesThatItNames) {
    const Scene scene = BoxOnPlane();
    ZPrecisionSettings settings{
        .curves = {.distances = 2, .poses = 1, .points = 1}, .width_px = 160, .height_px = 90};
    const ResultTable drawn = DrawnTable(scene, settings);
    ASSERT_EQ(drawn.rows.size(), 16u);
    Camera camera = scene.cameras.front();
    camera.width_px = 160;
    camera.height_px = 90;
    RasterOptions options;
    options.range.near_m = settings.near_m;
    const GBuffer exact = DrawGBuffer(scene, camera, options);
    options.z = ZSource::kStored;
    const std::pair<const char*, DepthFormat> formats[] = {
        {"D16", DepthFormat::kD16},
        {"D24", DepthFormat::kD24},
        {"D32F", DepthFormat::kD32F},
        {"D32F reversed", DepthFormat::kD32FReversed}};
    bool unjudged = false, apart = false;
    for (std::size_t row = 0; row < drawn.rows.size(); ++row) {
        EXPECT_EQ(TextAt(drawn, row, "camera"), camera.name);
        options.vertices = TextAt(drawn, row, "vertices") == "double" ? VertexPath::kDouble
                                                                      : VertexPath::kFloat;
        for (const auto& [name, format] : formats) {
            if (TextAt(drawn, row, "format") == name) options.depth = format;
        }
        options.range.far_m = TextAt(drawn, row, "far") == "infinite"
                                  ? std::numeric_limits<double>::infinity()
                                  : settings.far_m;
        const GBuffer g = DrawGBuffer(scene, camera, options);
        const Image<float> angle_rad = NormalErrorRad(g);
        double z_squares = 0, z_worst = 0, z_count = 0, pixels = 0;
        std::vector<double> degrees;
        for (std::size_t p = 0; p < g.z_m.Pixels().size(); ++p) {
            const bool judged = !std::isnan(angle_rad.Pixels()[p]);
            if (judged) degrees.push_back(angle_rad.Pixels()[p] * 180 / std::acos(-1.0));
            if (g.triangle.Pixels()[p] == GBuffer::kSky ||
                g.triangle.Pixels()[p] != exact.triangle.Pixels()[p]) {
                continue;
            }
            ++pixels;
            unjudged = unjudged || !judged;
            if (!judged) continue;
            const double off = 1e3 * (double(g.z_m.Pixels()[p]) - exact.z_m.Pixels()[p]);
            z_squares += off * off;
            z_worst = std::max(z_worst, std::abs(off));
            ++z_count;
        }
        std::ranges::sort(degrees);
        double squares = 0, within = 0;
        for (const double deg : degrees) {
            squares += deg * deg;
            within += deg <= 0.2;
        }
        const auto n = double(degrees.size());
        const auto below = [&](double share) {
            const double at = share * (n - 1);
            const auto k = std::size_t(at);
            const double next = degrees[std::min(k + 1, degrees.size() - 1)];
            return degrees[k] + (at - double(k)) * (next - degrees[k]);
        };
        const auto expect = [&](const char* key, double expected) {
            EXPECT_NEAR(NumberAt(drawn, row, key), expected, 1e-9 + 1e-6 * std::abs(expected))
                << key << " " << TextAt(drawn, row, "format");
        };
        expect("z_rms_mm", std::sqrt(z_squares / z_count));
        expect("z_worst_mm", z_worst);
        expect("normal_rms_deg", std::sqrt(squares / n));
        expect("normal_99_deg", below(0.99));
        expect("normal_999_deg", below(0.999));
        expect("normal_worst_deg", degrees.back());
        expect("within_paper_share", within / n);
        expect("pixels", pixels);
        expect("judged", n);
        apart = apart || below(0.999) > 1.01 * below(0.99);
    }
    EXPECT_TRUE(unjudged);
    EXPECT_TRUE(apart);
}

// Expected: each way by itself, at each distance, in the row of its names.
TEST(DepthStudy, HasTheErrorsOfTheWaysThatItNames) {
    ZPrecisionSettings settings{
        .curves = {.distances = 3, .poses = 2, .points = 4}, .width_px = 16, .height_px = 9};
    const ResultTable errors = ZErrorTable(BoxOnPlane(), settings);
    ASSERT_EQ(errors.rows.size(), 112u * 3);
    std::size_t row = 0;
    for (const ZPipeline& way : AllZPipelines()) {
        for (const ZError& error : MeasureZError(way, settings.curves)) {
            EXPECT_EQ(TextAt(errors, row, "host"),
                      way.host == HostPrecision::kDouble ? "double" : "float");
            EXPECT_EQ(TextAt(errors, row, "product"),
                      way.concatenated ? "one" : "step by step");
            EXPECT_EQ(TextAt(errors, row, "order"),
                      way.order == ProductOrder::kRows ? "rows" : "columns");
            EXPECT_EQ(TextAt(errors, row, "clip"),
                      way.clip == ClipRange::kMinusOneToOne ? "GL" : "D3D");
            EXPECT_EQ(TextAt(errors, row, "format"), NameOf(way.format));
            EXPECT_EQ(TextAt(errors, row, "far"), way.far_is_infinite ? "infinite" : "finite");
            EXPECT_DOUBLE_EQ(NumberAt(errors, row, "distance_m"), error.t_m);
            EXPECT_DOUBLE_EQ(NumberAt(errors, row, "rms_mm"), 1e3 * error.rms_m);
            EXPECT_DOUBLE_EQ(NumberAt(errors, row, "worst_mm"), 1e3 * error.worst_m);
            EXPECT_DOUBLE_EQ(NumberAt(errors, row, "mean_mm"), 1e3 * error.mean_m);
            ++row;
        }
    }
}

}  // namespace
}  // namespace plumb
