// The truth of a view as a job: what stops it, what it keeps, what it says of bad input.
#include "jobs/truth/truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "core/error.h"
#include "core/parallel.h"
#include "tests/io/temp_folder.h"

namespace plumb {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

// Asks to stop after so many questions whether to.
class StopAfter : public Monitor {
  public:
    explicit StopAfter(int questions) : left_(questions) {}
    void Progress(std::string_view, double) override {}
    bool Cancelled() const override { return left_-- <= 0; }

  private:
    mutable std::atomic<int> left_;
};

class Truths : public TempFolder {
  protected:
    static TruthJob Small(int spp = 256) {
        TruthJob job;
        job.width_px = 24;
        job.height_px = 20;
        job.max_spp = spp;
        return job;
    }

    TruthResult Measure(const std::string& out, const TruthJob& job,
                        const std::string& scene = "cornell_box",
                        Monitor& monitor = SilentMonitor()) const {
        return MeasureTruth(
            LoadScene(scene), job,
            {.version = "test", .command = "command", .monitor = monitor, .folder = Path(out)});
    }

    void ExpectSameFiles(const std::string& a, const std::string& b) const {
        for (const char* name :
             {"/truth.exr", "/truth.html", "/truth.json", "/truth.csv", "/truth.png"}) {
            EXPECT_FALSE(Get(a + name).empty()) << name;
            EXPECT_EQ(Get(a + name), Get(b + name)) << name;
        }
    }

    static const Image<float>& Channel(const TruthResult& result, const std::string& name) {
        for (const NamedChannel& channel : result.channels) {
            if (channel.name == name) return channel.pixels;
        }
        throw Error("no channel " + name);
    }
};

TEST_F(Truths, SameBytesOnOneAndTwoThreads) {
    TruthJob job = Small();
    job.bounces = 3;
    job.albedos = {0.5};
    job.reach_m = 0.4;
    job.irradiance = job.beauty = true;
    SetThreadCount(1);
    Measure("one", job);
    SetThreadCount(2);
    Measure("two", job);
    SetThreadCount(0);
    ExpectSameFiles("one", "two");
}

// Law: points double, so whoever goes on from a state makes the passes that were left.
TEST_F(Truths, GoesOnToTheSameBytes) {
    TruthJob job = Small(64);
    job.irradiance = job.beauty = true;
    job.bounces = 3;
    job.albedos = {0.5};
    job.reach_m = 0.4;
    job.falloff = Falloff::kLinear;
    job.cache = Path("cache");
    Measure("part", job);
    job.max_spp = 512;
    job.resume = true;
    const TruthResult resumed = Measure("resumed", job);
    EXPECT_EQ(resumed.report.stopped_by, "samples");
    EXPECT_EQ(resumed.report.spp, 512);
    job.resume = job.use_cache = false;
    Measure("whole", job);
    ExpectSameFiles("resumed", "whole");
    EXPECT_FALSE(std::filesystem::exists(Path("whole") / "cache"));
    EXPECT_NE(Get("part/truth.exr"), Get("whole/truth.exr"));
}

TEST_F(Truths, AreTakenFromTheCache) {
    TruthJob job = Small();
    job.cache = Path("cache");
    Measure("first", job);
    // Nothing is left to measure: nobody asks whether to stop.
    StopAfter at_once(0);
    const TruthResult again = Measure("again", job, "cornell_box", at_once);
    EXPECT_FALSE(again.interrupted);
    ExpectSameFiles("first", "again");
    // Another seed, camera, quantity or scene is another truth.
    for (int k = 0; k < 4; ++k) {
        TruthJob other = job;
        if (k == 0) other.seed = 2;
        if (k == 1) other.width_px = 25;
        if (k == 2) other.alpha = false;
        StopAfter stop(0);
        EXPECT_THROW(Measure("other", other, k == 3 ? "wedge" : "cornell_box", stop),
                     Interrupted)
            << k;
    }
}

// Who wants less than was kept gets no more: the same bytes as without a cache.
TEST_F(Truths, MoreThanIsAskedForIsNotUsed) {
    TruthJob job = Small(512);
    job.cache = Path("cache");
    Measure("much", job);
    TruthJob less = job;
    less.max_spp = 128;
    const TruthResult little = Measure("little", less);
    EXPECT_EQ(little.report.spp, 128);
    TruthJob sloppy = job;
    sloppy.target_error = 0.5;
    EXPECT_EQ(Measure("sloppy", sloppy).report.spp, 64);
    less.use_cache = false;
    Measure("afresh", less);
    ExpectSameFiles("little", "afresh");
    // And what was kept is still there.
    StopAfter at_once(0);
    EXPECT_EQ(Measure("again", job, "cornell_box", at_once).report.spp, 512);
    less.use_cache = less.resume = true;
    EXPECT_THAT(MessageOf<Error>([&] { Measure("resumed", less); }),
                HasSubstr("more samples than are asked for"));
}

TEST_F(Truths, ADamagedStateIsNoticed) {
    TruthJob job = Small();
    Measure("out", job);
    std::filesystem::path state;
    for (const auto& entry : std::filesystem::directory_iterator(Path("out") / "cache")) {
        state = entry.path();
    }
    ASSERT_EQ(state.extension(), ".state");
    const std::string name = "out/cache/" + state.filename().string();
    const std::string whole = Get(name);
    const std::string before = Get("out/truth.exr");
    for (const std::size_t at : {std::size_t{70}, whole.size() / 2, whole.size() - 1}) {
        std::string damaged = whole;
        damaged[at] = char(damaged[at] ^ 1);
        Put(name, damaged);
        job.resume = true;
        EXPECT_THAT(MessageOf<Error>([&] { Measure("out", job); }), HasSubstr("is damaged"));
        job.resume = false;
        const TruthResult afresh = Measure("out", job);
        EXPECT_THAT(afresh.report.notes, Contains(HasSubstr("damaged and was not used")));
        EXPECT_EQ(Get("out/truth.exr"), before);
    }
    Put(name, whole.substr(0, whole.size() / 3));
    EXPECT_THAT(Measure("out", job).report.notes, Contains(HasSubstr("damaged")));
    Put(name, "");
    EXPECT_THAT(Measure("out", job).report.notes, Contains(HasSubstr("damaged")));
}

TEST_F(Truths, AnInterruptionWritesWhatThereIs) {
    TruthJob job = Small(4096);
    StopAfter soon(200);
    const TruthResult part = Measure("part", job, "cornell_box", soon);
    EXPECT_TRUE(part.interrupted);
    EXPECT_EQ(part.report.stopped_by, "interruption");
    EXPECT_GE(part.report.spp, 64);
    EXPECT_LT(part.report.spp, 4096);
    // As a run that asked for so many: numbers and errors, if not the reason.
    TruthJob same = Small(int(part.report.spp));
    same.use_cache = false;
    const TruthResult whole = Measure("whole", same);
    EXPECT_EQ(Channel(part, "V"), Channel(whole, "V"));
    EXPECT_EQ(Channel(part, "V.error"), Channel(whole, "V.error"));
    StopAfter at_once(0);
    job.seed = 7;
    EXPECT_THROW(Measure("nothing", job, "cornell_box", at_once), Interrupted);
    EXPECT_FALSE(std::filesystem::exists(Path("nothing")));
}

TEST_F(Truths, StopAtWhatWasAskedFor) {
    TruthJob job = Small(4096);
    job.target_error = 0.02;
    const TruthResult by_error = Measure("error", job);
    EXPECT_EQ(by_error.report.stopped_by, "target error");
    EXPECT_LE(by_error.report.quantities.at(0).rms_error, 0.02);
    job = Small(4096);
    job.max_seconds = 2.5;
    job.use_cache = false;
    double now = 0;
    const TruthResult by_time = MeasureTruth(
        LoadScene("cornell_box"), job,
        {.version = "test",
         .command = "command",
         .clock = [&] { return now++; },  // A second a question: start, pass 1, pass 2.
         .folder = Path("time")});
    EXPECT_EQ(by_time.report.stopped_by, "time");
    EXPECT_EQ(by_time.report.spp, 256);
    // Without V the error is that of beauty.
    job = Small(4096);
    job.V = job.alpha = false;
    job.beauty = true;
    job.target_error = 1e-3;
    const TruthResult beauty = Measure("beauty", job);
    EXPECT_EQ(beauty.report.stopped_by, "target error");
    for (const TruthQuantity& q : beauty.report.quantities) EXPECT_LE(q.rms_error, 1e-3);
}

TEST_F(Truths, NameWhatIsWrong) {
    const auto complaint = [&](auto change) {
        TruthJob job = Small();
        change(job);
        return MessageOf<Error>([&] { Measure("out", job); });
    };
    EXPECT_EQ(complaint([](TruthJob& j) { j.max_spp = 100; }),
              "spp = 100, must be a power of two >= 64");
    EXPECT_EQ(complaint([](TruthJob& j) { j.target_error = -1; }),
              "target_error = -1, must be finite and >= 0");
    EXPECT_EQ(complaint([](TruthJob& j) { j.max_seconds = 0; }),
              "max_seconds = 0, must be > 0");
    EXPECT_THAT(complaint([](TruthJob& j) { j.V = j.alpha = false; }),
                HasSubstr("nothing to measure"));
    EXPECT_THAT(complaint([](TruthJob& j) { j.albedos = {0.5}; }), HasSubstr("bounces"));
    EXPECT_EQ(complaint([](TruthJob& j) {
                  j.bounces = 1;
                  j.albedos = {0.5, 0.25, 0.5};
              }),
              "albedo = 0.5, must be given once");
    EXPECT_THAT(complaint([](TruthJob& j) { j.camera = "gone"; }),
                HasSubstr("camera \"gone\", must be one of"));
    EXPECT_THAT(complaint([](TruthJob& j) { j.width_px = -1; }),
                HasSubstr("width_px = -1, must be in [1, 65536]"));
    EXPECT_THAT(complaint([](TruthJob& j) { j.width_px = j.height_px = 100000; }),
                HasSubstr("must be in [1, 65536]"));
    EXPECT_THAT(complaint([](TruthJob& j) { j.width_px = j.height_px = 60000; }),
                HasSubstr("must be at most 2^28"));
    EXPECT_THAT(complaint([](TruthJob& j) { j.resume = true; }), HasSubstr("is missing"));
    EXPECT_FALSE(std::filesystem::exists(Path("out")));
}

// Law: readers of EXR split a channel's name at its dots into layers, so a name has a dot only
// before a part (.error, .x, .R), and no bracket.
TEST_F(Truths, ChannelsHaveDotsOnlyBeforeParts) {
    TruthJob job = Small(64);
    job.bounces = 2;
    job.albedos = {0.5, 0.125};
    job.reach_m = 1;
    job.irradiance = job.beauty = true;
    std::set<std::string> layers;
    for (const NamedChannel& channel : Measure("out", job).channels) {
        std::istringstream parts(channel.name);
        std::string layer;
        std::getline(parts, layer, '.');
        layers.insert(layer);
        EXPECT_EQ(layer.find_first_of("()[] "), std::string::npos) << channel.name;
        for (std::string part; std::getline(parts, part, '.');) {
            EXPECT_THAT((std::vector<std::string>{"error", "low", "high", "R", "G", "B", "x",
                                                  "y", "z"}),
                        Contains(part))
                << channel.name;
        }
    }
    EXPECT_EQ(layers, (std::set<std::string>{"V", "alpha", "V_near", "E_1", "E_2", "under_way",
                                             "E_rho0p5", "E_rho0p125", "irradiance", "beauty",
                                             "depth_m", "normal", "position_m", "albedo",
                                             "triangle_bits"}));
}

// Where the sky is seen: what docs/scenes.md says, no error, and nothing to doubt.
TEST_F(Truths, SkyHasItsOwnValues) {
    TruthJob job = Small(64);
    job.bounces = 1;
    job.albedos = {0.5};
    job.reach_m = 0.5;
    job.irradiance = true;
    const TruthResult result = Measure("out", job, "ball_over_plane");
    const std::map<std::string, float> sky{{"V", 1},         {"alpha", 1},     {"V_near", 1},
                                           {"E_1", 0},       {"under_way", 0}, {"E_rho0p5", 1},
                                           {"irradiance", 0}};
    int seen = 0;
    for (std::size_t p = 0; p < 24 * 20; ++p) {
        if (std::isfinite(Channel(result, "depth_m").Pixels()[p])) continue;
        ++seen;
        for (const auto& [name, value] : sky) {
            const std::string part = name == "irradiance" ? ".G" : "";
            EXPECT_EQ(Channel(result, name + part).Pixels()[p], value) << name;
            EXPECT_EQ(Channel(result, name + ".error" + part).Pixels()[p], 0) << name;
            EXPECT_EQ(Channel(result, name + ".low" + part).Pixels()[p], value) << name;
            EXPECT_EQ(Channel(result, name + ".high" + part).Pixels()[p], value) << name;
        }
    }
    EXPECT_GT(seen, 10);
    EXPECT_EQ(result.report.pixels_seen, 24 * 20 - seen);
    EXPECT_EQ(result.report.spp, 64);
}

// A cube seen from its middle, and from outside; a triangle without area beside it.
TEST_F(Truths, WarnOfACameraInsideABodyAndOfZeroAreas) {
    Put("cube.obj",
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
        "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 1 2 2\n");
    Put("scene.json", R"({"meshes": [{"file": "cube.obj", "up": "z"}], "cameras": [
        {"name": "inside", "position_m": [0.5, 0.4, 0.6], "target_m": [1, 1, 1], "fov_deg": 60},
        {"name": "outside", "position_m": [4, 5, 3], "target_m": [0, 0, 0], "fov_deg": 60}]})");
    TruthJob job = Small(64);
    const std::string scene = Path("scene.json").string();
    const TruthResult inside = Measure("inside", job, scene);
    EXPECT_THAT(inside.report.notes, Contains(HasSubstr("it may stand inside a body")));
    EXPECT_EQ(inside.report.seen_from_behind, inside.report.pixels_seen);
    job.camera = "outside";
    const TruthResult outside = Measure("outside", job, scene);
    EXPECT_THAT(outside.report.notes, Not(Contains(HasSubstr("inside a body"))));
    EXPECT_EQ(outside.report.seen_from_behind, 0);
}

// Law: a wrapped field of tiles has the light of its height field; here only that it is there,
// where it is and of its albedo. A map of 4 x 4 texels 1 m wide has 4 x 4 cells a tile.
TEST_F(Truths, ScenesMayBeHeightMaps) {
    Put("scene.json", R"({"heights": [{"file": "make:bricks:16", "albedo": [0.1, 0.2, 0.3],
                                       "tiles": 2}],
        "cameras": [{"position_m": [0.5, 0.2, 2], "target_m": [0.5, 0.5, 0], "fov_deg": 40}]})");
    const LoadedScene loaded = LoadScene(Path("scene.json").string());
    EXPECT_EQ(loaded.scene.mesh.quads.size(), 25u * 16 * 16);
    const TruthResult result = Measure("out", Small(64), Path("scene.json").string());
    EXPECT_EQ(result.report.pixels_seen, 24 * 20);
    EXPECT_EQ(Channel(result, "albedo.B")(12, 10), 0.3f);
    EXPECT_EQ(result.report.seen_from_behind, 0);
    Put("bad.json", R"({"heights": [{"file": "gone.png"}], "cameras": []})");
    EXPECT_THAT(MessageOf<Error>([&] { LoadScene(Path("bad.json").string()); }),
                HasSubstr("gone.png"));
    Put("huge.json", R"({"heights": [{"file": "make:bricks:1024", "tiles": 16}]})");
    EXPECT_THAT(MessageOf<Error>([&] { LoadScene(Path("huge.json").string()); }),
                HasSubstr("must be at most 2^28"));
}

// Sponza's original file, where it is: 279 163 triangles in centimetres, its textures not beside
// it. Expected: what its makers say of it, and that along its middle a hall is seen, neither
// dark nor open.
TEST_F(Truths, SponzaLoadsAndRenders) {
    const std::filesystem::path packed =
        std::filesystem::path(PLUMB_SOURCE_DIR) / ".." / "shared" / "data" / "sponza.obj.xz";
    if (!std::filesystem::exists(packed)) GTEST_SKIP() << "no " << packed;
    const std::string unpack = "xz -dkc '" + packed.string() + "' > '" +
                               Path("sponza.obj").string() + "' 2> /dev/null";
    if (std::system(unpack.c_str()) != 0) GTEST_SKIP() << "xz is missing";
    std::filesystem::copy_file(packed.parent_path() / "sponza.mtl", Path("sponza.mtl"));
    const auto scene = [&](const std::string& more) {
        return Put("scene.json", R"({"meshes": [{"file": "sponza.obj", "unit_m": 0.01)" + more +
                                     R"(}], "cameras": [
            {"name": "hall", "position_m": [-10, 0, 2], "target_m": [10, 0, 3], "fov_deg": 60}]})")
            .string();
    };
    EXPECT_THAT(MessageOf<Error>([&] { LoadScene(scene("")); }), HasSubstr("textures/"));
    const std::string name = scene(R"(, "textures": false)");
    const LoadedScene loaded = LoadScene(name);
    EXPECT_EQ(loaded.scene.mesh.quads.size(), 279163u);
    EXPECT_EQ(loaded.scene.mesh.normals.size(), loaded.scene.mesh.vertices_m.size());
    Vec3f low = loaded.scene.mesh.vertices_m[0], high = low;
    for (const Vec3f& v : loaded.scene.mesh.vertices_m) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
    }
    EXPECT_NEAR((high - low).x(), 37, 3);  // About 37 m x 23 m, 15 m high.
    EXPECT_NEAR((high - low).z(), 15, 2);
    TruthJob job = Small(64);
    job.beauty = true;
    const TruthResult hall = Measure("hall", job, name);
    EXPECT_EQ(hall.report.pixels_seen, 24 * 20);
    EXPECT_GT(hall.report.quantities.at(0).mean, 0.02);
    EXPECT_LT(hall.report.quantities.at(0).mean, 0.6);
}

}  // namespace
}  // namespace plumb
