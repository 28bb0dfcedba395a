// Scenes in other places and other units: light does not know of either.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/error.h"
#include "jobs/screen_space/technique.h"
#include "jobs/truth/truth.h"
#include "rays/embree/embree_caster.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::Contains;
using testing::HasSubstr;

class FarScenes : public TempFolder {
  protected:
    // A box of 2 m without a lid, moved and scaled, and a camera that looks into it.
    LoadedScene Box(const Vec3& at, double scale) const {
        std::ostringstream obj, json;
        obj.precision(17);
        json.precision(17);
        const auto point = [&](double x, double y, double z) {
            return Vec3(at + scale * Vec3(x, y, z));
        };
        for (const double z : {0.0, 2.0}) {
            for (const auto& [x, y] :
                 {std::pair{0.0, 0.0}, {2.0, 0.0}, {2.0, 2.0}, {0.0, 2.0}}) {
                const Vec3 p = point(x, y, z);
                obj << "v " << p.x() << " " << p.y() << " " << p.z() << "\n";
            }
        }
        obj << "f 1 2 3 4\nf 2 1 5 6\nf 3 2 6 7\nf 4 3 7 8\nf 1 4 8 5\n";
        Put("box.obj", obj.str());
        const auto list = [](const Vec3& p) {
            std::ostringstream text;
            text.precision(17);
            text << "[" << p.x() << ", " << p.y() << ", " << p.z() << "]";
            return text.str();
        };
        json << R"({"meshes": [{"file": "box.obj", "up": "z"}], "cameras": [{"position_m": )"
             << list(point(1, 0.75, 3.5)) << R"(, "target_m": )" << list(point(1, 1, 0))
             << R"(, "fov_deg": 30}]})";
        return LoadScene(Put("scene.json", json.str()).string());
    }

    TruthResult Measure(const LoadedScene& loaded) const {
        TruthJob job;
        job.width_px = 32;
        job.height_px = 24;
        job.max_spp = 512;
        job.alpha = job.use_cache = false;
        return MeasureTruth(loaded, job,
                            {.version = "test", .command = "command", .folder = Path("out")});
    }
};

// Law: V does not change if all is moved or scaled. The nets are the same ones, so what is left is the
// rounding of where rays start; tolerance: 4 standard errors of the mean of 768 pixels' V, as if
// the two were independent.
TEST_F(FarScenes, HaveTheSameV) {
    const TruthResult here = Measure(Box({0, 0, 0}, 1));
    const TruthQuantity& V = here.report.quantities.at(0);
    ASSERT_EQ(V.name, "V");
    ASSERT_EQ(here.report.pixels_seen, 32 * 24);
    const double tolerance = 4 * std::sqrt(2 / (32.0 * 24)) * V.rms_error;
    ASSERT_LT(tolerance, 2e-3);
    for (const double offset : {1e3, 1e4, 1e5, 1e6, 1e7}) {
        const TruthResult there = Measure(Box({offset, -offset / 2, offset / 4}, 1));
        EXPECT_NEAR(there.report.quantities.at(0).mean, V.mean, tolerance) << offset;
        EXPECT_EQ(there.report.pixels_seen, 32 * 24) << offset;
        EXPECT_THAT(there.report.notes, Contains(HasSubstr("kept relative to"))) << offset;
    }
    const TruthResult utm = Measure(Box({500000, 5400000, 100}, 1));
    EXPECT_NEAR(utm.report.quantities.at(0).mean, V.mean, tolerance);
    for (const double scale : {1e-3, 1e3}) {
        const TruthResult scaled = Measure(Box({0, 0, 0}, scale));
        EXPECT_NEAR(scaled.report.quantities.at(0).mean, V.mean, tolerance) << scale;
        EXPECT_EQ(scaled.report.pixels_seen, 32 * 24) << scale;
    }
}

// Law: a scaled scene is drawn the same, its depths scaled. At 1e-3 a near plane of 0.01 m would
// cut off all of it. Tolerance: the float of depths and of vertices, a few 2^-24 of the box seen from
// twice its size.
TEST_F(FarScenes, AreDrawnTheSame) {
    const LoadedScene one = Box({0, 0, 0}, 1);
    Camera camera = one.scene.cameras.at(0);
    camera.width_px = 32;
    camera.height_px = 24;
    const GBuffer g = DrawGBuffer(one.scene, camera, SuitedTo(one.scene, camera));
    for (const double scale : {1e-3, 1e3}) {
        const LoadedScene scaled = Box({0, 0, 0}, scale);
        Camera its = scaled.scene.cameras.at(0);
        its.width_px = 32;
        its.height_px = 24;
        const GBuffer h = DrawGBuffer(scaled.scene, its, SuitedTo(scaled.scene, its));
        int differ = 0;
        for (std::size_t p = 0; p < g.z_m.Pixels().size(); ++p) {
            if (g.triangle.Pixels()[p] != h.triangle.Pixels()[p]) {
                ++differ;  // On an edge.
                continue;
            }
            EXPECT_NEAR(h.z_m.Pixels()[p] / scale, g.z_m.Pixels()[p], 1e-5)
                << p << " " << scale;
        }
        EXPECT_LE(differ, 8) << scale;
        EXPECT_LE(h.range.near_m, 0.01);
        EXPECT_GT(h.range.near_m, 0);
    }
}

// Law: what techniques see does not change if all is moved. The file's vertices are doubles, of which
// 1e7 leaves 1e-9 m: below the float's rounding, so no more than single pixels, where a tap or an
// edge rounds to its neighbour, may differ. The bitmask rounds sectors up: tests/jobs/
// scaled_scenes_test.cpp.
TEST_F(FarScenes, HaveTheSamePicturesOfEveryTechnique) {
    const auto pictures = [](const LoadedScene& loaded) {
        Camera camera = loaded.scene.cameras.at(0);
        camera.width_px = 32;
        camera.height_px = 24;
        const EmbreeCaster caster(loaded.scene);
        const GBuffer g = DrawGBuffer(loaded.scene, camera, SuitedTo(loaded.scene, camera, 8));
        std::vector<Image<float>> all;
        for (const std::string& name : TechniqueNames()) {
            const Technique technique = TechniqueNamed(name, {.radius_m = 1});
            all.push_back(
                technique.run({g, loaded.scene, camera, caster}, [] { return 0.0; }).back().A);
        }
        return all;
    };
    const std::vector<Image<float>> here = pictures(Box({0, 0, 0}, 1));
    for (const double offset : {1e3, 1e4, 1e5, 1e6, 1e7}) {
        const auto there = pictures(Box({offset, -offset / 2, offset / 4}, 1));
        for (std::size_t t = 0; t < here.size(); ++t) {
            const std::string name = TechniqueNames()[t];
            const double step = name == "bitmask" ? 2.0 / 32 : 1e-3;
            int differ = 0;
            for (std::size_t p = 0; p < here[t].Pixels().size(); ++p) {
                differ += std::abs(here[t].Pixels()[p] - there[t].Pixels()[p]) > step;
            }
            EXPECT_LE(differ, int(here[t].Pixels().size()) / 50) << name << " " << offset;
        }
    }
}

// A camera or a lamp where float squares overflow is refused before anything is traced; at the
// bound all works.
TEST_F(FarScenes, RefuseWhatIsTooFar) {
    const auto with = [&](const std::string& position, const std::string& lamp) {
        Put("plate.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        return Put("far.json", R"({"meshes": [{"file": "plate.obj", "up": "z"}],
            "point_lights": [{"position_m": )" +
                                   lamp + R"(, "intensity": [1, 1, 1]}],
            "cameras": [{"position_m": )" +
                                   position + R"(, "target_m": [0, 0, 0], "fov_deg": 30}]})")
            .string();
    };
    EXPECT_THAT(MessageOf<Error>([&] { LoadScene(with("[1e20, 0, 0]", "[0, 0, 1]")); }),
                HasSubstr("cameras[0].position[0] = 1e+20, must be finite and at most 1e15"));
    EXPECT_THAT(MessageOf<Error>([&] { LoadScene(with("[1, 0, 1]", "[0, 0, 1e20]")); }),
                HasSubstr("point_lights[0].position_m[2] = 1e+20, must be finite and at most"));
    const LoadedScene far = LoadScene(with("[1e15, 0, 1e15]", "[0, 0, 1e15]"));
    TruthJob job;
    job.width_px = job.height_px = 4;
    job.max_spp = 64;
    job.irradiance = job.beauty = true;
    job.use_cache = false;
    EXPECT_NO_THROW(MeasureTruth(
        far, job, {.version = "test", .command = "command", .folder = Path("out")}));
}

}  // namespace
}  // namespace plumb
