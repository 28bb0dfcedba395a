#include "jobs/truth/truth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/total_name.h"
#include "io/data_uri.h"
#include "io/image_io.h"
#include "jobs/truth/truth_cache.h"
#include "jobs/truth/truth_passes.h"
#include "jobs/truth/truth_pictures.h"
#include "jobs/truth/truth_state.h"
#include "jobs/write_document.h"
#include "rays/embree/embree_caster.h"

namespace plumb {
namespace {

void AddQuantities(const TruthCounts& counts, const TruthJob& job, TruthPictures& pictures) {
    if (counts.walks || counts.V) {
        pictures.Add("V", 1, [&](std::int64_t i) { return TruthPasses::V(counts, i); });
    }
    if (counts.alpha) {
        pictures.Add("alpha", 1, [&](std::int64_t i) { return counts.alpha->Of(i); });
    }
    if (counts.near) {
        pictures.Add("V_near", 1, [&](std::int64_t i) { return counts.near->Of(i); });
    }
    if (counts.walks) {
        for (int k = 1; k <= job.bounces; ++k) {
            pictures.Add("E_" + std::to_string(k), 0,
                         [&](std::int64_t i) { return counts.walks->Bounce(i, k); });
        }
        pictures.Add("under_way", 0, [&](std::int64_t i) { return counts.walks->UnderWay(i); });
        for (const double rho : job.albedos) {
            pictures.Add(TotalName(Albedo(rho)), 1,
                         [&](std::int64_t i) { return counts.walks->Total(i, Albedo(rho)); });
        }
    }
    if (counts.irradiance) pictures.AddColour("irradiance", counts.irradiance->sums);
    if (counts.beauty) pictures.AddColourOfPixels("beauty", *counts.beauty);
}

// Warnings that a run still makes sense with.
std::vector<std::string> Warnings(const RayCaster& caster, const Scene& scene,
                                  const Camera& camera, const PixelGeometry& pixels) {
    std::vector<std::string> notes;
    if (const std::int64_t n = caster.Counts().zero_area; n > 0) {
        notes.push_back(std::to_string(n) + " triangles without area were kept out");
    }
    if (pixels.receivers.empty()) notes.push_back("no pixel shows a surface");
    constexpr double kMost = 0.5;
    if (ShareOfBacksAround(caster, scene.mesh, camera.position_m) > kMost) {
        notes.push_back(
            "around the camera most directions show the backs of faces: it may stand inside a "
            "body");
    }
    return notes;
}

const Image<float>* ChannelNamed(const std::vector<NamedChannel>& channels,
                                 const std::string& name) {
    for (const NamedChannel& channel : channels) {
        if (channel.name == name) return &channel.pixels;
    }
    return nullptr;
}

// The colour `name` as a picture, if it was measured.
std::optional<Image<Rgb>> ColourNamed(const std::vector<NamedChannel>& channels,
                                      const std::string& name) {
    const Image<float>* red = ChannelNamed(channels, name + ".R");
    if (red == nullptr) return {};
    Image<Rgb> image(red->Width(), red->Height());
    for (std::size_t c = 0; c < 3; ++c) {
        const Image<float>& of = *ChannelNamed(channels, name + "." + "RGB"[c]);
        for (std::size_t p = 0; p < image.Pixels().size(); ++p) {
            image.Pixels()[p][c] = of.Pixels()[p];
        }
    }
    return image;
}

void Write(TruthResult& result, const std::filesystem::path& folder, const LoadedScene& loaded,
           const TruthJob& job) {
    const TruthReport& report = result.report;
    WriteExr(folder / "truth.exr", result.channels,
             {{"plumb:version", report.tool_version},
              {"plumb:command", report.command},
              {"plumb:scene", loaded.scene.name},
              {"plumb:scene_sha256", loaded.digest},
              {"plumb:camera", report.camera},
              {"plumb:seed", std::to_string(job.seed)},
              {"plumb:spp", std::to_string(report.spp)},
              {"plumb:stopped_by", report.stopped_by}});
    result.document = DocumentOf(report);
    const auto show = [&](const char* name, const auto* picture, const char* what) {
        if (!picture) return;
        WritePreview(folder / name, *picture);
        result.document.sections[0].pictures.push_back(
            {PngDataUri(folder / name), what, std::string(what) + "."});
    };
    show("truth.png", ChannelNamed(result.channels, "V"), "V, black 0 to white 1");
    for (const char* name : {"irradiance", "beauty"}) {
        const std::optional<Image<Rgb>> colour = ColourNamed(result.channels, name);
        show((std::string("truth_") + name + ".png").c_str(), colour ? &*colour : nullptr,
             name);
    }
    result.page = WriteDocument(folder, result.document, "truth");
}

}  // namespace

void Validate(const TruthJob& job) {
    if (!job.V && !job.alpha && job.bounces == 0 && job.reach_m == 0 && !job.irradiance &&
        !job.beauty) {
        throw Error("nothing to measure, must ask for a quantity");
    }
    if (job.bounces < 0 || job.bounces > 100) {
        throw Error(MustBe("bounces", job.bounces, "in [0, 100]"));
    }
    for (const double rho : job.albedos) {
        if (!(rho >= 0 && rho <= 1)) throw Error(MustBe("albedo", rho, "in [0, 1]"));
        if (std::ranges::count(job.albedos, rho) > 1) {
            throw Error(MustBe("albedo", rho, "given once"));
        }
    }
    if (!job.albedos.empty() && job.bounces == 0) {
        throw Error("albedo without bounces, must have bounces >= 1");
    }
    if (!(job.reach_m >= 0 && std::isfinite(job.reach_m))) {
        throw Error(MustBe("reach_m", job.reach_m, "finite and >= 0"));
    }
    if (job.max_spp < kTruthNets * kFirstPassPoints ||
        !std::has_single_bit(std::uint32_t(job.max_spp))) {
        throw Error(MustBe("spp", job.max_spp, "a power of two >= 64"));
    }
    if (!(job.target_error >= 0 && std::isfinite(job.target_error))) {
        throw Error(MustBe("target_error", job.target_error, "finite and >= 0"));
    }
    if (!(job.max_seconds > 0)) {
        throw Error(MustBe("max_seconds", job.max_seconds, "> 0"));
    }
}

TruthResult MeasureTruth(const LoadedScene& loaded, const TruthJob& job,
                         const RunContext& run) {
    const double start_s = run.clock();
    Validate(job);
    const Scene& scene = loaded.scene;
    Camera camera = CameraNamed(scene, job.camera);
    if (job.width_px != 0) camera.width_px = job.width_px;
    if (job.height_px != 0) camera.height_px = job.height_px;
    Validate(camera, scene.name + ": camera " + camera.name);

    const EmbreeCaster caster(scene);
    const PixelGeometry pixels = LookThrough(caster, scene, camera);
    TruthResult result;
    TruthReport& report = result.report;
    report = {.tool_version = run.version,
              .command = run.command,
              .scene = scene.name,
              .scene_sha256 = loaded.digest,
              .camera = camera.name,
              .width_px = camera.width_px,
              .height_px = camera.height_px,
              .seed = job.seed,
              .nets = kTruthNets,
              .spp = 0,
              .stopped_by = {},
              .quantities = {},
              .pixels_seen = std::int64_t(pixels.receivers.size()),
              .seen_from_behind = pixels.seen_from_behind,
              .zero_area_triangles = caster.Counts().zero_area,
              .lost_walks = 0,
              .notes = loaded.notes};
    for (std::string& note : Warnings(caster, scene, camera, pixels)) {
        report.notes.push_back(std::move(note));
    }

    const TruthPasses passes(caster, scene, camera, pixels, job, run.monitor);
    TruthCache cache(job.cache.empty() ? run.folder / "cache" : job.cache,
                     KeyOfTruth(loaded, camera, job, run.version),
                     {.receivers = report.pixels_seen,
                      .pixels = std::int64_t(camera.width_px) * camera.height_px},
                     job);
    TruthCounts counts = cache.Load().value_or(TruthCounts{});
    if (!cache.Note().empty()) report.notes.push_back(cache.Note());
    while ((report.stopped_by = StopRule(counts, job)).empty()) {
        if (counts.points > 0 && run.clock() - start_s >= job.max_seconds) {
            report.stopped_by = "time";
            break;
        }
        try {
            passes.Next(counts);
        } catch (const Interrupted&) {
            if (counts.points == 0) throw;
            result.interrupted = true;
            report.stopped_by = "interruption";
            break;
        }
        cache.Store(counts);
    }

    TruthPictures pictures(pixels);
    AddQuantities(counts, job, pictures);
    result.lost = LostIn(counts);
    if (counts.irradiance && counts.irradiance->cut > 0) {
        report.notes.push_back(std::to_string(counts.irradiance->cut) +
                               " walks were cut off: irradiance is too low");
    }
    report.quantities = pictures.quantities;
    report.spp = counts.points * kTruthNets;
    report.lost_walks = result.lost.All();
    pictures.AddGeometry();
    result.channels = std::move(pictures.channels);
    Write(result, run.folder, loaded, job);
    result.seconds = run.clock() - start_s;
    return result;
}

}  // namespace plumb
