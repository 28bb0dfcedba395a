#include "jobs/truth.h"

#include <bit>
#include <cmath>
#include <optional>
#include <sstream>

#include "core/error.h"
#include "io/image_io.h"
#include "io/whole_file.h"
#include "jobs/truth_pictures.h"
#include "jobs/truth_state.h"
#include "truth/embree_caster.h"

namespace plumb {
namespace {

constexpr std::int64_t kFirstPass = 8;  // Points of each net.

// Takes the passes; stands for one run.
class Run {
  public:
    Run(const RayCaster& caster, const Mesh& mesh, const std::vector<Receiver>& receivers,
        const TruthJob& job, Monitor& monitor)
        : caster_(caster), mesh_(mesh), receivers_(receivers), job_(job), monitor_(monitor) {}

    // `points` more of each net. All of it or nothing reaches `counts`.
    void Pass(TruthCounts& counts, std::int64_t points) const {
        const NetSampling sampling{.replicates = kTruthNets,
                                   .first = counts.points,
                                   .points = points,
                                   .seed = job_.seed};
        TruthCounts pass;
        pass.points = points;
        if (job_.alpha) {
            pass.alpha = CountOpenSky(
                caster_, mesh_, receivers_,
                {.sampling = sampling, .weighting = HemisphereWeight::kUniform}, monitor_);
        }
        if (job_.bounces > 0) {
            pass.walks =
                WalkToTheSky(caster_, mesh_, receivers_,
                             {.sampling = sampling, .bounces = job_.bounces}, monitor_);
        } else {
            pass.V = CountOpenSky(caster_, mesh_, receivers_, {.sampling = sampling}, monitor_);
        }
        if (job_.reach_m > 0) {
            pass.near = MeasureNear(
                caster_, mesh_, receivers_,
                {.sampling = sampling, .reach_m = job_.reach_m, .falloff = job_.falloff},
                monitor_);
        }
        Merge(counts, std::move(pass));
    }

    Measured V(const TruthCounts& counts, std::int64_t i) const {
        return counts.walks ? counts.walks->Bounce(i, 0) : counts.V->Of(i);
    }

    double RmsErrorOfV(const TruthCounts& counts) const {
        double squares = 0;
        for (std::size_t i = 0; i < receivers_.size(); ++i) {
            const double error = V(counts, std::int64_t(i)).standard_error;
            squares += error * error / double(receivers_.size());
        }
        return std::sqrt(squares);
    }

  private:
    const RayCaster& caster_;
    const Mesh& mesh_;
    const std::vector<Receiver>& receivers_;
    const TruthJob& job_;
    Monitor& monitor_;
};

std::string BounceName(int k) {
    return "E_" + std::to_string(k);
}

}  // namespace

void Validate(const TruthJob& job) {
    if (job.bounces < 0 || job.bounces > 100) {
        throw Error(MustBe("bounces", job.bounces, "in [0, 100]"));
    }
    for (const double rho : job.albedos) {
        if (!(rho >= 0 && rho <= 1)) throw Error(MustBe("albedo", rho, "in [0, 1]"));
    }
    if (!job.albedos.empty() && job.bounces == 0) {
        throw Error("albedo without bounces, must have bounces >= 1");
    }
    if (!(job.reach_m >= 0 && std::isfinite(job.reach_m))) {
        throw Error(MustBe("reach_m", job.reach_m, "finite and >= 0"));
    }
    if (job.max_spp < kTruthNets * kFirstPass ||
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
                         const std::filesystem::path& folder, const std::string& tool_version,
                         const std::string& command, const std::function<double()>& clock,
                         Monitor& monitor) {
    const double start_s = clock();
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
    report = {.tool_version = tool_version,
              .command = command,
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
    if (report.zero_area_triangles > 0) {
        report.notes.push_back(std::to_string(report.zero_area_triangles) +
                               " triangles without area were kept out");
    }
    if (report.pixels_seen == 0) report.notes.push_back("no pixel shows a surface");

    const std::filesystem::path state_path = folder / "truth.state";
    const std::string key = KeyOfTruth(loaded, camera, job, tool_version);
    TruthCounts counts;
    if (job.resume) {
        if (!std::filesystem::exists(state_path)) {
            throw Error(state_path.string() + ": is missing, must be there to resume");
        }
        std::optional<TruthCounts> kept =
            TruthFromBytes(ReadWholeFile(state_path), key, report.pixels_seen, job);
        if (!kept) {
            throw Error(state_path.string() +
                        ": is of another scene or other settings, or damaged");
        }
        counts = std::move(*kept);
    }

    const Run run(caster, scene.mesh, pixels.receivers, job, monitor);
    const std::int64_t max_points = job.max_spp / kTruthNets;
    const auto stop_rule = [&]() -> std::string {
        if (counts.points == 0) return "";
        if (job.target_error > 0 && run.RmsErrorOfV(counts) <= job.target_error) {
            return "target error";
        }
        if (counts.points >= max_points) return "samples";
        if (clock() - start_s >= job.max_seconds) return "time";
        return "";
    };
    while ((report.stopped_by = stop_rule()).empty()) {
        // Doubles the points: 8, 8, 16, 32, ...
        const std::int64_t points = counts.points == 0 ? kFirstPass : counts.points;
        try {
            run.Pass(counts, points);
        } catch (const Interrupted&) {
            if (counts.points == 0) throw;
            result.interrupted = true;
            report.stopped_by = "interruption";
            break;
        }
        WriteWholeFile(state_path, ToBytes(counts, key));
    }

    TruthPictures pictures(pixels);
    pictures.Add("V", 1, [&](std::int64_t i) { return run.V(counts, i); });
    if (counts.alpha) {
        pictures.Add("alpha", 1, [&](std::int64_t i) { return counts.alpha->Of(i); });
        result.lost += counts.alpha->lost;
    }
    if (counts.V) result.lost += counts.V->lost;
    if (counts.near) {
        pictures.Add("V_near", 1, [&](std::int64_t i) { return counts.near->Of(i); });
    }
    if (counts.walks) {
        result.lost += counts.walks->lost;
        for (int k = 1; k <= job.bounces; ++k) {
            pictures.Add(BounceName(k), 0,
                         [&](std::int64_t i) { return counts.walks->Bounce(i, k); });
        }
        pictures.Add("under_way", 0, [&](std::int64_t i) { return counts.walks->UnderWay(i); });
        for (const double rho : job.albedos) {
            std::ostringstream name;
            name << "E(" << rho << ")";
            pictures.Add(name.str(), 1,
                         [&](std::int64_t i) { return counts.walks->Total(i, Albedo(rho)); });
        }
    }
    report.quantities = pictures.quantities;
    report.spp = counts.points * kTruthNets;
    report.lost_walks = result.lost.All();
    const Image<float> V = pictures.channels.front().pixels;
    pictures.AddGeometry();

    result.exr = folder / "truth.exr";
    result.preview = folder / "truth.png";
    result.json = folder / "truth.json";
    WriteExr(result.exr, pictures.channels,
             {{"plumb:version", tool_version},
              {"plumb:command", command},
              {"plumb:scene", loaded.scene.name},
              {"plumb:scene_sha256", loaded.digest},
              {"plumb:camera", camera.name},
              {"plumb:seed", std::to_string(job.seed)},
              {"plumb:spp", std::to_string(report.spp)},
              {"plumb:stopped_by", report.stopped_by}});
    WritePreview(result.preview, V);
    WriteWholeFile(result.json, ToJsonText(report));
    result.seconds = clock() - start_s;
    return result;
}

}  // namespace plumb
