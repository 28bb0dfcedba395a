#include "jobs/truth.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>
#include <sstream>

#include "core/error.h"
#include "io/content_hash.h"
#include "io/image_io.h"
#include "io/whole_file.h"
#include "truth/embree_caster.h"
#include "truth/escape_walk.h"
#include "truth/open_sky.h"
#include "truth/pixels.h"

namespace plumb {
namespace {

constexpr int kNets = 8;
constexpr std::int64_t kFirstPass = 8;  // Points of each net.

// Everything counted so far. Which members are there follows from the job.
struct Counts {
    std::int64_t points = 0;  // Of each net.
    std::optional<OpenCounts> alpha, V;
    std::optional<EscapeCounts> walks;
    std::optional<NearSums> near;
};

template <class T>
void MergeInto(std::optional<T>& all, T part) {
    if (all) {
        all->Merge(part);
    } else {
        all = std::move(part);
    }
}

// The bytes of a state: the key of the job, then every count. Read back only if all fits.
class State {
  public:
    State(std::string key, std::int64_t receivers, const TruthJob& job)
        : key_(std::move(key)), receivers_(receivers), job_(job) {}

    std::string Write(const Counts& counts) const {
        std::string bytes = key_;
        Put(bytes, &counts.points, 1);
        const auto put_lost = [&](const Lost& lost) { Put(bytes, &lost, 1); };
        for (const std::optional<OpenCounts>* open : {&counts.alpha, &counts.V}) {
            if (!*open) continue;
            Put(bytes, (*open)->open.data(), (*open)->open.size());
            put_lost((*open)->lost);
        }
        if (counts.walks) {
            for (std::int64_t i = 0; i < receivers_; ++i) {
                for (int r = 0; r < kNets; ++r) {
                    const auto row = counts.walks->Row(i, r);
                    Put(bytes, row.data(), row.size());
                }
            }
            put_lost(counts.walks->lost);
        }
        if (counts.near) Put(bytes, counts.near->sum.data(), counts.near->sum.size());
        return bytes;
    }

    // Nothing if the bytes are not a whole state of this job.
    std::optional<Counts> Read(const std::string& bytes) const {
        if (!bytes.starts_with(key_)) return std::nullopt;
        std::size_t at = key_.size();
        bool fits = true;
        const auto get = [&](auto* values, std::size_t n) {
            const std::size_t size = n * sizeof *values;
            fits = fits && at + size <= bytes.size();
            if (fits) std::memcpy(static_cast<void*>(values), bytes.data() + at, size);
            at += size;
        };
        Counts counts;
        get(&counts.points, 1);
        if (!fits || counts.points < 1) return std::nullopt;
        const std::size_t cells = std::size_t(receivers_) * kNets;
        for (auto [wanted, open] :
             {std::pair{job_.alpha, &counts.alpha}, std::pair{job_.bounces == 0, &counts.V}}) {
            if (!wanted) continue;
            *open = OpenCounts{.replicates = kNets,
                               .points = counts.points,
                               .open = std::vector<std::uint32_t>(cells),
                               .lost = {}};
            get((*open)->open.data(), cells);
            get(&(*open)->lost, 1);
        }
        if (job_.bounces > 0) {
            counts.walks.emplace(receivers_, kNets, job_.bounces, counts.points);
            for (std::int64_t i = 0; i < receivers_ && fits; ++i) {
                for (int r = 0; r < kNets; ++r) {
                    const auto row = counts.walks->Row(i, r);
                    get(row.data(), row.size());
                }
            }
            get(&counts.walks->lost, 1);
        }
        if (job_.reach_m > 0) {
            counts.near = NearSums{.replicates = kNets,
                                   .points = counts.points,
                                   .sum = std::vector<double>(cells)};
            get(counts.near->sum.data(), cells);
        }
        return fits && at == bytes.size() ? std::optional(std::move(counts)) : std::nullopt;
    }

  private:
    template <class T>
    static void Put(std::string& bytes, const T* values, std::size_t n) {
        bytes.append(reinterpret_cast<const char*>(values), n * sizeof(T));
    }

    std::string key_;
    std::int64_t receivers_;
    const TruthJob& job_;
};

// All that decides the counts, but not when to stop.
std::string KeyOf(const LoadedScene& loaded, const Camera& camera, const TruthJob& job,
                  const std::string& tool_version) {
    std::ostringstream text;
    text << std::hexfloat << tool_version << ' ' << loaded.digest << ' ' << job.seed << ' '
         << job.alpha << ' ' << job.bounces << ' ' << job.reach_m << ' ' << int(job.falloff)
         << ' ' << camera.fov_rad << ' ' << camera.width_px << ' ' << camera.height_px;
    for (const Vec3& v : {camera.position_m, camera.target_m, camera.up}) {
        text << ' ' << v.x() << ' ' << v.y() << ' ' << v.z();
    }
    return Sha256Hex(text.str());
}

// Takes the passes; stands for one run.
class Run {
  public:
    Run(const RayCaster& caster, const Mesh& mesh, const std::vector<Receiver>& receivers,
        const TruthJob& job, Monitor& monitor)
        : caster_(caster), mesh_(mesh), receivers_(receivers), job_(job), monitor_(monitor) {}

    // `points` more of each net. All of it or nothing reaches `counts`.
    void Pass(Counts& counts, std::int64_t points) const {
        const NetSampling sampling{
            .replicates = kNets, .first = counts.points, .points = points, .seed = job_.seed};
        std::optional<OpenCounts> alpha, V;
        std::optional<EscapeCounts> walks;
        std::optional<NearSums> near;
        if (job_.alpha) {
            alpha = CountOpenSky(
                caster_, mesh_, receivers_,
                {.sampling = sampling, .weighting = HemisphereWeight::kUniform}, monitor_);
        }
        if (job_.bounces > 0) {
            walks = WalkToTheSky(caster_, mesh_, receivers_,
                                 {.sampling = sampling, .bounces = job_.bounces}, monitor_);
        } else {
            V = CountOpenSky(caster_, mesh_, receivers_, {.sampling = sampling}, monitor_);
        }
        if (job_.reach_m > 0) {
            near = MeasureNear(
                caster_, mesh_, receivers_,
                {.sampling = sampling, .reach_m = job_.reach_m, .falloff = job_.falloff},
                monitor_);
        }
        if (alpha) MergeInto(counts.alpha, std::move(*alpha));
        if (V) MergeInto(counts.V, std::move(*V));
        if (walks) MergeInto(counts.walks, std::move(*walks));
        if (near) MergeInto(counts.near, std::move(*near));
        counts.points += points;
    }

    Measured V(const Counts& counts, std::int64_t i) const {
        return counts.walks ? counts.walks->Bounce(i, 0) : counts.V->Of(i);
    }

    double RmsErrorOfV(const Counts& counts) const {
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

// Turns counts into channels; where the sky is seen everything is open and sure.
class Pictures {
  public:
    explicit Pictures(const PixelGeometry& pixels) : pixels_(pixels) {}

    void Add(const std::string& name, double sky,
             const std::function<Measured(std::int64_t)>& measured) {
        const int w = pixels_.depth_m.Width(), h = pixels_.depth_m.Height();
        Image<float> value(w, h, float(sky)), error(w, h, 0);
        TruthQuantity quantity{.name = name, .mean = 0, .rms_error = 0};
        const double n = double(std::max<std::size_t>(1, pixels_.receivers.size()));
        double squares = 0;
        for (std::size_t i = 0; i < pixels_.receivers.size(); ++i) {
            const Measured m = measured(std::int64_t(i));
            const std::uint32_t pixel = pixels_.pixel_of_receiver[i];
            value.Pixels()[pixel] = float(m.value);
            error.Pixels()[pixel] = float(m.standard_error);
            quantity.mean += m.value / n;
            squares += m.standard_error * m.standard_error / n;
        }
        quantity.rms_error = std::sqrt(squares);
        quantities.push_back(quantity);
        channels.push_back({name, std::move(value)});
        channels.push_back({name + ".error", std::move(error)});
    }

    void AddGeometry() {
        const auto add = [&](const std::string& name, const auto& of_pixel) {
            Image<float> image(pixels_.depth_m.Width(), pixels_.depth_m.Height());
            for (std::size_t p = 0; p < image.Pixels().size(); ++p) {
                image.Pixels()[p] = of_pixel(p);
            }
            channels.push_back({name, std::move(image)});
        };
        add("depth_m", [&](std::size_t p) { return pixels_.depth_m.Pixels()[p]; });
        for (int c = 0; c < 3; ++c) {
            const std::string axis(1, "xyz"[c]);
            add("normal." + axis, [&](std::size_t p) { return pixels_.normal.Pixels()[p][c]; });
            add("position_m." + axis,
                [&](std::size_t p) { return pixels_.position_m.Pixels()[p][c]; });
            add("albedo." + std::string(1, "RGB"[c]),
                [&](std::size_t p) { return pixels_.albedo.Pixels()[p][std::size_t(c)]; });
        }
        // As bits: a float holds whole numbers up to 2^24 only.
        add("triangle_bits",
            [&](std::size_t p) { return std::bit_cast<float>(pixels_.triangle.Pixels()[p]); });
    }

    std::vector<NamedChannel> channels;
    std::vector<TruthQuantity> quantities;

  private:
    const PixelGeometry& pixels_;
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
    if (job.max_spp < kNets * kFirstPass || !std::has_single_bit(std::uint32_t(job.max_spp))) {
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

    const EmbreeCaster caster(scene.mesh);
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
              .nets = kNets,
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
    const State state(KeyOf(loaded, camera, job, tool_version), report.pixels_seen, job);
    Counts counts;
    if (job.resume) {
        if (!std::filesystem::exists(state_path)) {
            throw Error(state_path.string() + ": is missing, must be there to resume");
        }
        std::optional<Counts> kept = state.Read(ReadWholeFile(state_path));
        if (!kept) {
            throw Error(state_path.string() +
                        ": is of another scene or other settings, or damaged");
        }
        counts = std::move(*kept);
    }

    const Run run(caster, scene.mesh, pixels.receivers, job, monitor);
    const std::int64_t max_points = job.max_spp / kNets;
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
        WriteWholeFile(state_path, state.Write(counts));
    }

    Pictures pictures(pixels);
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
    report.spp = counts.points * kNets;
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
