#include "jobs/screen_space/temporal_study.h"

#include "core/camera.h"
#include "core/error.h"
#include "core/sobol.h"
#include "jobs/screen_space/score_columns.h"
#include "score/temporal.h"
#include "screen_space/raster/draw_gbuffer.h"
#include "screen_space/raster/near_plane.h"

namespace plumb {
namespace {

// The camera turned so that the picture moves by `shift` pixels at its middle.
Camera Turned(const Camera& camera, const Vec2& shift_px) {
    const CameraFrame frame(camera);
    const Vec3 w = frame.Direction(camera, 0.5 * camera.width_px + shift_px.x(),
                                   0.5 * camera.height_px + shift_px.y());
    Camera turned = camera;
    const double distance = (camera.target_m - camera.position_m).norm();
    turned.target_m = camera.position_m + distance * w.normalized();
    return turned;
}

}  // namespace

doc::Section StudyFlicker(const Scene& scene, const Camera& camera, const RayCaster& caster,
                          std::span<const ChosenTechnique> techniques,
                          const TemporalOptions& options, const RunContext& run) {
    if (options.frames < 2 || options.frames > 1024) {
        throw Error(MustBe("TemporalOptions::frames", options.frames, "in [2, 1024]"));
    }
    Camera small = camera;
    small.width_px = options.width_px;
    small.height_px = options.height_px;
    std::vector<Image<float>> truths, errors;
    std::vector<std::vector<Image<float>>> frames(techniques.size());
    Mask seen(small.width_px, small.height_px, 1);
    const std::vector<Falloff> hard{Falloff::kHard};
    for (int frame = 0; frame < options.frames; ++frame) {
        const Camera at = Turned(
            small, SobolOwenPair(std::uint32_t(frame), 0, options.seed) - Vec2(0.5, 0.5));
        ViewTruth truth = MeasureViewTruth(caster, scene, at, hard,
                                           {.radius_m = options.radius_m,
                                            .spp = options.spp,
                                            .seed = options.seed + 1 + std::uint64_t(frame),
                                            .far = false},
                                           SilentMonitor());
        seen = Both(seen, RegionsOf(truth).seen);
        truths.push_back(std::move(truth.near.at(Falloff::kHard).value));
        errors.push_back(std::move(truth.near.at(Falloff::kHard).standard_error));
        const GBuffer gbuffer = DrawGBuffer(scene, at, SuitedTo(scene, at, options.guard_px));
        for (std::size_t t = 0; t < techniques.size(); ++t) {
            const std::vector<Pass> passes =
                techniques[t].Made().run({gbuffer, scene, at, caster}, run.clock);
            frames[t].push_back(Shown(passes.back().A, gbuffer.view));
        }
        if (run.monitor.Cancelled()) throw Interrupted();
        run.monitor.Progress("flicker", double(frame + 1) / options.frames);
    }
    const auto variance = [](std::string key, std::string title, doc::Better better) {
        return doc::Column{
            .key = std::move(key), .title = std::move(title), .unit = "10⁻⁶", .better = better};
    };
    doc::Table table{.key = "flicker",
                     .columns = {doc::Name("technique", "Technique"),
                                 variance("candidate", "Technique", doc::Better::kNeither),
                                 variance("truth", "Truth", doc::Better::kNeither),
                                 variance("flicker", "Flicker", doc::Better::kLess)}};
    for (std::size_t t = 0; t < techniques.size(); ++t) {
        const TemporalScore score =
            ScoreTemporal(frames[t], truths, errors, seen, {.truth_dof = kTruthNets - 1.0});
        table.Add({techniques[t].name, 1e6 * score.candidate, 1e6 * score.truth,
                   1e6 * score.flicker});
    }
    return {.id = "flicker",
            .title = "Flicker",
            .sentences = {"The camera turns by parts of a pixel. Variance of a pixel over the "
                          "frames, averaged over the picture: of the technique, of the truth "
                          "(which changes at edges), and of the error alone: what the eye sees "
                          "as flicker."},
            .facts = {{{.key = "frames", .title = "Frames"}, options.frames}},
            .tables = {std::move(table)}};
}

}  // namespace plumb
