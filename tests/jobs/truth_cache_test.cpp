// What a truth's key is of: every field that decides the counts, and no other.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "io/content_hash.h"
#include "jobs/truth/sources_hash.h"
#include "jobs/truth/truth_state.h"
#include "tests/jobs/made_scenes.h"

namespace plumb {
namespace {

struct Keyed {
    LoadedScene loaded{FloorAndWall(16, 12), {}, "digest"};
    Camera camera = FloorAndWall(16, 12).cameras.front();
    TruthJob job;
    std::string version = "1", sources = "hash";

    Keyed() {
        job.reach_m = 1;
        job.bounces = 2;
    }
    std::string Key() const { return KeyOfTruth(loaded, camera, job, version, sources); }
};

TEST(TruthKey, ChangesWithEveryFieldThatDecides) {
    const std::map<std::string, std::function<void(Keyed&)>> changes{
        {"version", [](Keyed& k) { k.version = "2"; }},
        {"sources", [](Keyed& k) { k.sources = "other"; }},
        {"scene", [](Keyed& k) { k.loaded.digest = "other"; }},
        {"seed", [](Keyed& k) { k.job.seed = 2; }},
        {"alpha", [](Keyed& k) { k.job.alpha = false; }},
        {"irradiance", [](Keyed& k) { k.job.irradiance = true; }},
        {"beauty", [](Keyed& k) { k.job.beauty = true; }},
        {"bounces", [](Keyed& k) { k.job.bounces = 3; }},
        {"no bounces", [](Keyed& k) { k.job.bounces = 0; }},
        {"no bounces, no V",
         [](Keyed& k) {
             k.job.bounces = 0;
             k.job.V = false;
         }},
        {"reach", [](Keyed& k) { k.job.reach_m = 1.0000001; }},
        {"no reach", [](Keyed& k) { k.job.reach_m = 0; }},
        {"falloff", [](Keyed& k) { k.job.falloff = Falloff::kLinear; }},
        {"other falloff", [](Keyed& k) { k.job.falloff = Falloff::kSao; }},
        {"field of view", [](Keyed& k) { k.camera.fov_rad += 1e-9; }},
        {"width", [](Keyed& k) { k.camera.width_px = 17; }},
        {"height", [](Keyed& k) { k.camera.height_px = 13; }},
        {"position x", [](Keyed& k) { k.camera.position_m.x() += 1e-9; }},
        {"position y", [](Keyed& k) { k.camera.position_m.y() += 1e-9; }},
        {"position z", [](Keyed& k) { k.camera.position_m.z() += 1e-9; }},
        {"target x", [](Keyed& k) { k.camera.target_m.x() += 1e-9; }},
        {"target y", [](Keyed& k) { k.camera.target_m.y() += 1e-9; }},
        {"target z", [](Keyed& k) { k.camera.target_m.z() += 1e-9; }},
        {"up x", [](Keyed& k) { k.camera.up.x() += 1e-9; }},
        {"up y", [](Keyed& k) { k.camera.up.y() += 1e-9; }},
        {"up z", [](Keyed& k) { k.camera.up.z() += 1e-9; }},
    };
    std::set<std::string> keys{Keyed().Key()};
    for (const auto& [name, change] : changes) {
        Keyed changed;
        change(changed);
        EXPECT_TRUE(keys.insert(changed.Key()).second) << name << " is not in the key";
    }
}

// The sources are those that were compiled unless a test says otherwise.
TEST(TruthKey, IsOfTheSourcesOfThisProgram) {
    const Keyed k;
    EXPECT_EQ(KeyOfTruth(k.loaded, k.camera, k.job, "1"),
              KeyOfTruth(k.loaded, k.camera, k.job, "1", TruthSourcesHash()));
}

TEST(TruthKey, StaysWithEveryFieldThatDoesNot) {
    const std::map<std::string, std::function<void(Keyed&)>> changes{
        {"most samples", [](Keyed& k) { k.job.max_spp = 4096; }},
        {"target error", [](Keyed& k) { k.job.target_error = 0.1; }},
        {"seconds", [](Keyed& k) { k.job.max_seconds = 3; }},
        {"resume", [](Keyed& k) { k.job.resume = true; }},
        {"cache folder", [](Keyed& k) { k.job.cache = "elsewhere"; }},
        {"albedos", [](Keyed& k) { k.job.albedos = {0.5}; }},
        {"V beside bounces", [](Keyed& k) { k.job.V = false; }},
        {"names", [](Keyed& k) { k.loaded.scene.name = k.camera.name = "other"; }},
        {"notes", [](Keyed& k) { k.loaded.notes = {"note"}; }},
        {"the camera's own size in the job",
         [](Keyed& k) { k.job.width_px = k.camera.width_px; }},
    };
    for (const auto& [name, change] : changes) {
        Keyed changed;
        change(changed);
        EXPECT_EQ(changed.Key(), Keyed().Key()) << name;
    }
    Keyed no_reach, other_falloff;
    no_reach.job.reach_m = other_falloff.job.reach_m = 0;
    other_falloff.job.falloff = Falloff::kSao;
    EXPECT_EQ(no_reach.Key(), other_falloff.Key()) << "a falloff without a reach";
}

// A scene with one of everything.
Scene Rich() {
    Scene scene = FloorAndWall(16, 12);
    scene.materials.push_back({.name = "cloth", .albedo = {0.5f, 0.5f, 0.5f}, .texture = 0});
    Texture texture{.name = "weave", .albedo = Image<Rgb>(2, 1), .opacity = Image<float>(2, 1)};
    scene.textures.push_back(texture);
    scene.mesh.normals.assign(scene.mesh.vertices_m.size(), Vec3f(0, 0, 1));
    scene.mesh.uvs.assign(scene.mesh.vertices_m.size(), Vec2f(0, 0));
    scene.light.environment.radiance = Image<Rgb>(4, 2);
    scene.light.directional.push_back({});
    scene.light.points.push_back({});
    return scene;
}

TEST(SceneDigest, IsOfAllThatLightDependsOnAndOfNothingElse) {
    const std::map<std::string, std::function<void(Scene&)>> changes{
        {"vertex", [](Scene& s) { s.mesh.vertices_m[0].x() += 0.5f; }},
        {"face", [](Scene& s) { std::swap(s.mesh.quads[0], s.mesh.quads[1]); }},
        {"material of a face", [](Scene& s) { s.material_of_face[1] = 1; }},
        {"normal", [](Scene& s) { s.mesh.normals[0].x() = 1; }},
        {"uv", [](Scene& s) { s.mesh.uvs[0].x() = 1; }},
        {"albedo", [](Scene& s) { s.materials[0].albedo[2] = 0.25f; }},
        {"texture of a material", [](Scene& s) { s.materials[0].texture = 0; }},
        {"alpha test", [](Scene& s) { s.materials[1].alpha_tested = true; }},
        {"texture's albedo", [](Scene& s) { s.textures[0].albedo(1, 0)[1] = 0.5f; }},
        {"texture's opacity", [](Scene& s) { s.textures[0].opacity(1, 0) = 0.5f; }},
        {"texture's shape",
         [](Scene& s) {
             s.textures[0].albedo = Image<Rgb>(1, 2);
             s.textures[0].opacity = Image<float>(1, 2);
         }},
        {"sky", [](Scene& s) { s.light.sky[0] = 2; }},
        {"environment", [](Scene& s) { s.light.environment.radiance(0, 0)[0] = 2; }},
        {"environment's shape",
         [](Scene& s) { s.light.environment.radiance = Image<Rgb>(2, 4); }},
        {"environment's turn", [](Scene& s) { s.light.environment.turn_rad = 1; }},
        {"towards", [](Scene& s) { s.light.directional[0].towards.y() = 1; }},
        {"irradiance", [](Scene& s) { s.light.directional[0].irradiance[1] = 2; }},
        {"position of a lamp", [](Scene& s) { s.light.points[0].position_m.z() = 2; }},
        {"intensity", [](Scene& s) { s.light.points[0].intensity[2] = 2; }},
        {"one lamp more", [](Scene& s) { s.light.points.push_back({}); }},
        {"one light more", [](Scene& s) { s.light.directional.push_back({}); }},
    };
    std::set<std::string> digests{DigestOf(Rich())};
    for (const auto& [name, change] : changes) {
        Scene scene = Rich();
        change(scene);
        EXPECT_TRUE(digests.insert(DigestOf(scene)).second) << name << " is not in the digest";
    }
    Scene same = Rich();
    same.name = same.materials[0].name = same.textures[0].name = "other";
    same.cameras.clear();
    EXPECT_EQ(DigestOf(same), DigestOf(Rich()));
}

// Expected: from the sources as they lie there, hashed here anew. Fails if a file of core/, rays/,
// truth/ or jobs/truth/ is not in the hash, or was changed after it was made.
TEST(TruthSourcesHash, IsOfTheSourcesThatCompute) {
    const std::filesystem::path root = PLUMB_SOURCE_DIR;
    std::vector<std::string> files;
    for (const char* folder : {"core", "rays", "rays/embree", "truth", "jobs/truth"}) {
        for (const auto& entry : std::filesystem::directory_iterator(root / folder)) {
            const std::string ending = entry.path().extension().string();
            if (ending != ".h" && ending != ".cpp") continue;
            files.push_back(std::string(folder) + "/" + entry.path().filename().string());
        }
    }
    std::ranges::sort(files);
    std::string text;
    for (const std::string& file : files)
        text += file + " " + Sha256HexOfFile(root / file) + "\n";
    EXPECT_EQ(TruthSourcesHash(), Sha256Hex(text));
}

}  // namespace
}  // namespace plumb
