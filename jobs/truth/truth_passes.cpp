#include "jobs/truth/truth_passes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace plumb {
namespace {

double Rms(std::int64_t n, const std::function<double(std::int64_t)>& error) {
    double squares = 0;
    for (std::int64_t i = 0; i < n; ++i) squares += error(i) * error(i) / double(n);
    return std::sqrt(squares);
}

double RmsOfWorstColour(const RgbSums& sums) {
    const std::int64_t n = std::int64_t(sums.sum.size()) / sums.replicates;
    double worst = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        worst = std::max(worst,
                         Rms(n, [&](std::int64_t i) { return sums.Of(i, c).standard_error; }));
    }
    return worst;
}

}  // namespace

void TruthPasses::Next(TruthCounts& counts) const {
    TruthCounts pass;
    pass.points = counts.points == 0 ? kFirstPassPoints : counts.points;
    const NetSampling sampling{.replicates = kTruthNets,
                               .first = counts.points,
                               .points = pass.points,
                               .seed = job_.seed};
    const std::vector<Receiver>& receivers = pixels_.receivers;
    if (job_.alpha) {
        pass.alpha = CountOpenSky(
            caster_, scene_.mesh, receivers,
            {.sampling = sampling, .weighting = HemisphereWeight::kUniform}, monitor_);
    }
    if (job_.bounces > 0) {
        pass.walks = WalkToTheSky(caster_, scene_.mesh, receivers,
                                  {.sampling = sampling, .bounces = job_.bounces}, monitor_);
    } else if (job_.V) {
        pass.V =
            CountOpenSky(caster_, scene_.mesh, receivers, {.sampling = sampling}, monitor_);
    }
    if (job_.reach_m > 0) {
        pass.near = MeasureNear(
            caster_, scene_.mesh, receivers,
            {.sampling = sampling, .reach_m = job_.reach_m, .falloff = job_.falloff}, monitor_);
    }
    if (job_.irradiance) {
        pass.irradiance =
            MeasureIrradiance(caster_, scene_, receivers, {.sampling = sampling}, monitor_);
    }
    if (job_.beauty) pass.beauty = MeasureBeauty(caster_, scene_, camera_, sampling, monitor_);
    Merge(counts, std::move(pass));
    counts.rms_errors.push_back(RmsError(counts));
}

Measured TruthPasses::V(const TruthCounts& counts, std::int64_t i) {
    return counts.walks ? counts.walks->Bounce(i, 0) : counts.V->Of(i);
}

double TruthPasses::RmsError(const TruthCounts& counts) const {
    const std::int64_t n = std::int64_t(pixels_.receivers.size());
    if (counts.walks || counts.V) {
        return Rms(n, [&](std::int64_t i) { return V(counts, i).standard_error; });
    }
    if (counts.irradiance) return RmsOfWorstColour(counts.irradiance->sums);
    if (counts.beauty) return RmsOfWorstColour(*counts.beauty);
    if (counts.alpha) {
        return Rms(n, [&](std::int64_t i) { return counts.alpha->Of(i).standard_error; });
    }
    return Rms(n, [&](std::int64_t i) { return counts.near->Of(i).standard_error; });
}

}  // namespace plumb
