#include "jobs/truth/view_truth.h"

#include <bit>
#include <cmath>
#include <functional>

#include "core/error.h"
#include "core/statistics.h"
#include "truth/open_sky.h"
#include "truth/replicates.h"

namespace plumb {
namespace {

// Mean and standard error of nets of n points by their plain scatter. A floor under the error, as
// truth/replicates.h has it for the intervals of single pixels, would be taken off every mean square
// error for noise that is not there: of 16 rays .0026 at every pixel that all of them see alike.
template <class Sum>
Measured PlainScatter(const std::vector<Sum>& sums, std::int64_t receiver, int replicates,
                      std::int64_t n) {
    Moments moments;
    for (int r = 0; r < replicates; ++r) {
        moments.Add(double(sums[std::size_t(receiver * replicates + r)]) / double(n));
    }
    return {.value = moments.Mean(), .standard_error = moments.StandardError()};
}

TruthImage ImageOf(const PixelGeometry& pixels,
                   const std::function<Measured(std::int64_t)>& of_receiver) {
    const int w = pixels.depth_m.Width(), h = pixels.depth_m.Height();
    TruthImage image{Image<float>(w, h, 1), Image<float>(w, h, 0)};
    for (std::size_t i = 0; i < pixels.receivers.size(); ++i) {
        const Measured measured = of_receiver(std::int64_t(i));
        const std::uint32_t pixel = pixels.pixel_of_receiver[i];
        image.value.Pixels()[pixel] = float(measured.value);
        image.standard_error.Pixels()[pixel] = float(measured.standard_error);
    }
    return image;
}

}  // namespace

void Validate(const ViewTruthOptions& o) {
    if (!(o.radius_m > 0 && std::isfinite(o.radius_m))) {
        throw Error(MustBe("ViewTruthOptions::radius_m", o.radius_m, "in (0, infinity)"));
    }
    RequireSpp("ViewTruthOptions::spp", o.spp);
}

void RequireSpp(const std::string& field, int spp) {
    if (spp < 16 || spp > (1 << 20) || !std::has_single_bit(unsigned(spp))) {
        throw Error(MustBe(field, spp, "a power of two in [16, 2^20]"));
    }
}

ViewTruth MeasureViewTruth(const RayCaster& caster, const Scene& scene, const Camera& camera,
                           std::span<const Falloff> falloffs, const ViewTruthOptions& options,
                           Monitor& monitor) {
    Validate(options);
    ViewTruth truth;
    truth.pixels = LookThrough(caster, scene, camera);
    const NetSampling sampling{
        .replicates = kTruthNets, .points = options.spp / kTruthNets, .seed = options.seed};
    const auto& receivers = truth.pixels.receivers;
    if (options.far) {
        const OpenCounts open =
            CountOpenSky(caster, scene.mesh, receivers, {.sampling = sampling}, monitor);
        truth.V = ImageOf(truth.pixels, [&](std::int64_t i) {
            return PlainScatter(open.open, i, open.replicates, open.points);
        });
        truth.lost += open.lost;
    }
    const std::vector<NearSums> near =
        MeasureNearEach(caster, scene.mesh, receivers,
                        {.sampling = sampling, .reach_m = options.radius_m}, falloffs, monitor);
    for (std::size_t k = 0; k < near.size(); ++k) {
        truth.near[falloffs[k]] = ImageOf(truth.pixels, [&](std::int64_t i) {
            return PlainScatter(near[k].sum, i, near[k].replicates, near[k].points);
        });
    }
    return truth;
}

}  // namespace plumb
