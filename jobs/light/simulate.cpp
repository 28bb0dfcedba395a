#include "jobs/light/simulate.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "io/image_io.h"
#include "jobs/light/albedo_light.h"
#include "jobs/light/amplitude_study.h"
#include "jobs/pictures.h"
#include "jobs/write_results.h"

namespace plumb {
namespace {

// The sweep runs on a piece of the map: 13 amplitudes cost 13 simulations.
constexpr int kSweepTexels = 128;

// E of the user's albedo as a picture and as EXR channels.
void WriteColouredLight(const std::filesystem::path& folder, const HeightField& field,
                        const std::array<std::vector<double>, 3>& E) {
    std::vector<NamedChannel> channels;
    Image<Rgb> picture(field.CellsX(), field.CellsY());
    const char* names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        channels.push_back({names[c], CellImage(field, E[c])});
        for (std::size_t cell = 0; cell < picture.Pixels().size(); ++cell) {
            picture.Pixels()[cell][c] = channels.back().pixels.Pixels()[cell];
        }
    }
    WriteExr(folder / "light_albedo.exr", channels,
             {{"quantity", "irradiance over that of open ground, for the given albedo"}});
    WritePreview(folder / "light_albedo.png", picture);
}

std::array<std::vector<double>, 3> UniformAlbedos(const std::vector<double>& albedo,
                                                  std::int64_t facets) {
    std::array<std::vector<double>, 3> out;
    for (std::size_t c = 0; c < 3; ++c) {
        out[c].assign(std::size_t(facets), albedo.size() == 3 ? albedo[c] : albedo[0]);
    }
    return out;
}

}  // namespace

SimulateReport Simulate(const Surface& surface, const SimulateJob& job, const RunContext& run) {
    if (job.albedo.size() == 2) throw Error("--albedo: two numbers, must be one or three");
    for (const double rho : job.albedo) {
        if (!(rho >= 0 && rho <= 1)) throw Error(MustBe("--albedo", rho, "in [0, 1]"));
    }
    const bool coloured = !job.albedo.empty() || !job.albedo_map.empty();
    std::array<std::vector<double>, 3> albedo;
    if (!job.albedo_map.empty()) {
        // A picture of another size is refused by its header; none has so many channels.
        constexpr std::int64_t kMostChannels = 64;
        const std::int64_t texels =
            std::int64_t(surface.field.Width()) * surface.field.Height();
        albedo = FacetAlbedos(
            surface.field,
            ReadPicture(job.albedo_map, std::min(kMaxImageNumbers, kMostChannels * texels)));
    } else if (coloured) {
        albedo = UniformAlbedos(job.albedo, surface.field.Facets());
    }

    SimulateReport report;
    std::vector<std::vector<float>> bounces;
    std::array<std::vector<double>, 3> E;
    const SurfaceLight light =
        SimulateSurface(surface.source.name, surface.field, job.settings, run.monitor,
                        &report.timings, run.clock,
                        {.bounce =
                             [&](int k, std::span<const double> E_k) {
                                 if (job.write_maps && k <= kMappedBounces) {
                                     bounces.emplace_back(E_k.begin(), E_k.end());
                                 }
                             },
                         .links =
                             [&](const Links& links, const FacetPieces& pieces) {
                                 if (coloured)
                                     E = ColouredLight(links, pieces, albedo, run.monitor);
                             }});
    report.provenance.tool_version = run.version;
    report.provenance.command = run.command;
    report.provenance.maps = {surface.source};
    report.provenance.sampling = SamplingOf(job.settings);
    report.provenance.bounces = job.settings.bounces;
    report.provenance.bins = job.settings.bins;
    report.provenance.albedos = job.settings.albedos;
    report.surface = {light.name, "", "", light.over_alpha, light.over_V, light.figures};

    if (job.write_maps) WriteLightMaps(run.folder, surface, light, bounces);
    if (coloured) WriteColouredLight(run.folder, surface.field, E);
    if (job.sweep_amplitude) {
        SimulateSettings brief = job.settings;
        brief.check_furnace = false;
        report.amplitudes =
            StudyAmplitude(NameOfMiddle(surface.source.name, surface.field, kSweepTexels),
                           MiddleOf(surface.field, kSweepTexels), SweptAmplitudes(), brief,
                           nullptr, nullptr, run.monitor);
    }
    WritePictures(run.folder, surface.field, light.V, report.surface);
    WriteHistograms(run.folder, report.surface);
    return report;
}

}  // namespace plumb
