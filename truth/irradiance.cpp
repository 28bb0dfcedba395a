#include "truth/irradiance.h"

#include <algorithm>
#include <mutex>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/sobol.h"
#include "core/surface.h"
#include "core/warp.h"
#include "rays/leave_surface.h"
#include "truth/direct_light.h"

namespace plumb {
namespace {

using Colour = std::array<double, 3>;

constexpr std::int64_t kReceiversPerChunk = 8;
constexpr std::uint64_t kRouletteKey =
    0x726f756c65747465u;  // Apart from the nets' own numbers.

// Follows the walks of one receiver together, bounce by bounce.
class Walker {
  public:
    Walker(const RayCaster& caster, const Scene& scene, const ShadingModel& lights,
           const IrradianceOptions& options, const Monitor& monitor)
        : caster_(caster),
          scene_(scene),
          options_(options),
          monitor_(monitor),
          direct_(caster, lights) {}

    void Walk(const Receiver& receiver, std::int64_t number, std::span<Colour> sums,
              std::array<SampleSpread, 3>& spread) {
        Start(receiver, number, sums);
        for (int k = 0; !walks_.empty(); ++k) {
            CheckCancelled(monitor_);
            if (k > options_.max_bounces) {
                cut_ += std::int64_t(walks_.size());
                for (const State& walk : walks_) AddSample(walk, spread);
                return;
            }
            hits_.resize(rays_.size());
            caster_.Closest(rays_, hits_);
            std::size_t kept = 0;
            for (std::size_t i = 0; i < walks_.size(); ++i) {
                if (!Step(i, k, sums)) {
                    AddSample(walks_[i], spread);
                    continue;
                }
                walks_[kept] = walks_[i];
                rays_[kept] = rays_[i];
                ++kept;
            }
            walks_.resize(kept);
            rays_.resize(kept);
            AddDirect(sums);
        }
    }

    const Lost& GetLost() const { return lost_; }
    std::int64_t Cut() const { return cut_; }

  private:
    struct State {
        int replicate;
        std::uint32_t index;  // Of the point in its net.
        Colour T;
        Colour T_at_light;  // Before the roulette: what the surface itself reflects.
        Colour brought;     // So far, by this walk.
    };

    static void AddSample(const State& walk, std::array<SampleSpread, 3>& spread) {
        for (std::size_t c = 0; c < 3; ++c) spread[c].Add(walk.brought[c]);
    }

    void Start(const Receiver& receiver, std::int64_t number, std::span<Colour> sums) {
        const NetSampling& sampling = options_.sampling;
        const Triangle triangle = TriangleOf(scene_.mesh, receiver.triangle);
        const Basis frame(receiver.Normal(triangle));
        nets_.clear();
        walks_.clear();
        rays_.clear();
        for (int r = 0; r < sampling.replicates; ++r) {
            nets_.push_back(NetSeed(sampling.seed, number, r));
            for (std::int64_t s = 0; s < sampling.points; ++s) {
                const std::uint32_t index = std::uint32_t(sampling.first + s);
                const Vec2 b = receiver.Place(SobolOwenPair(index, kPlace, nets_.back()));
                walks_.push_back({r, index, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}});
                rays_.push_back(LeaveSurface(triangle, b.x(), b.y(), frame.n));
                if (receiver.spread) direct_.Ask(rays_.back(), frame.n);
                rays_.back().direction = Direction(frame, walks_.back(), kFirstDirection);
            }
        }
        if (receiver.spread) {
            AddDirect(sums);
            return;
        }
        direct_.Ask(rays_.front(), frame.n);  // The same for every sample.
        const Colour D = direct_.Answer().front();
        for (Colour& sum : sums) {
            for (std::size_t c = 0; c < 3; ++c) sum[c] += double(sampling.points) * D[c];
        }
        for (State& walk : walks_) walk.brought = D;
    }

    Vec3f Direction(const Basis& frame, const State& walk, std::uint32_t pair) const {
        const Vec2 u = SobolOwenPair(walk.index, pair, nets_[std::size_t(walk.replicate)]);
        return frame.ToWorld(SampleCosineHemisphere(u)).cast<float>();
    }

    // D of the places that walks_ have reached, which were asked about in their order.
    void AddDirect(std::span<Colour> sums) {
        const std::vector<Colour>& answer = direct_.Answer();
        for (std::size_t i = 0; i < answer.size(); ++i) {
            State& walk = walks_[i];
            for (std::size_t c = 0; c < 3; ++c) {
                const double light = walk.T_at_light[c] * answer[i][c];
                sums[std::size_t(walk.replicate)][c] += light;
                walk.brought[c] += light;
            }
        }
    }

    // What became of ray i, the k-th of its walk; if it goes on, rays_[i] is the next one.
    bool Step(std::size_t i, int k, std::span<Colour> sums) {
        Ray& ray = rays_[i];
        State& walk = walks_[i];
        const Hit& hit = hits_[i];
        const Vec3 w = ray.direction.cast<double>();
        if (!w.allFinite()) {
            ++lost_.not_a_number;
            return false;
        }
        if (!hit.Met()) {
            const Rgb L = SkyRadiance(scene_.light, w);
            Colour& sum = sums[std::size_t(walk.replicate)];
            for (std::size_t c = 0; c < 3; ++c) {
                sum[c] += walk.T[c] * L[c];
                walk.brought[c] += walk.T[c] * L[c];
            }
            return false;
        }
        const Rgb rho = AlbedoAt(scene_, hit.triangle, hit.b_1, hit.b_2);
        for (std::size_t c = 0; c < 3; ++c) walk.T[c] *= rho[c];
        if (*std::ranges::max_element(walk.T) == 0) return false;  // Brings nothing back.

        const Triangle triangle = TriangleOf(scene_.mesh, hit.triangle);
        const Vec3 front = triangle.Normal();
        const Vec3 n = front.dot(w) <= 0 ? front : Vec3(-front);
        ray = LeaveSurface(triangle, hit.b_1, hit.b_2, n);
        walk.T_at_light = walk.T;
        const bool goes_on = PassesRoulette(walk, k + 1);
        direct_.Ask(ray, n);
        ray.direction = Direction(Basis(n), walk, kLaterDirections + std::uint32_t(k));
        if (!goes_on) walk.T = {0, 0, 0};
        return true;
    }

    // Roulette at bounce k: T / q with probability q, else the walk has to end.
    bool PassesRoulette(State& walk, int k) const {
        if (k < options_.roulette_from) return true;
        const double q = std::min(1.0, *std::ranges::max_element(walk.T));
        const std::uint64_t net = nets_[std::size_t(walk.replicate)];
        if (RandomUnit(kRouletteKey, net, walk.index, std::uint64_t(k)) >= q) return false;
        for (double& T : walk.T) T /= q;
        return true;
    }

    const RayCaster& caster_;
    const Scene& scene_;
    const IrradianceOptions& options_;
    const Monitor& monitor_;
    DirectLight direct_;
    std::vector<std::uint64_t> nets_;
    std::vector<State> walks_;
    std::vector<Ray> rays_;
    std::vector<Hit> hits_;
    Lost lost_;
    std::int64_t cut_ = 0;
};

}  // namespace

void Validate(const IrradianceOptions& options) {
    Validate(options.sampling);
    for (const auto& [name, value] : {std::pair{"roulette_from", options.roulette_from},
                                      std::pair{"max_bounces", options.max_bounces}}) {
        if (value < 1 || value > 10000) {
            throw Error(
                MustBe(std::string("IrradianceOptions::") + name, value, "in [1, 10000]"));
        }
    }
}

IrradianceSums MeasureIrradiance(const RayCaster& caster, const Scene& scene,
                                 std::span<const Receiver> receivers,
                                 const IrradianceOptions& options, Monitor& monitor) {
    Validate(options);
    const std::size_t R = std::size_t(options.sampling.replicates);
    const ShadingModel lights(scene.light);
    IrradianceSums out;
    out.sums = RgbSums(std::int64_t(receivers.size()), int(R), options.sampling.points);
    std::mutex mutex;
    ParallelFor(
        std::int64_t(receivers.size()), kReceiversPerChunk,
        [&](std::int64_t begin, std::int64_t end) {
            InParts(options.sampling, monitor, [&](const NetSampling& part) {
                IrradianceOptions of_part = options;
                of_part.sampling = part;
                Walker walker(caster, scene, lights, of_part, monitor);
                for (std::int64_t i = begin; i < end; ++i) {
                    walker.Walk(receivers[std::size_t(i)], i,
                                std::span(out.sums.sum).subspan(std::size_t(i) * R, R),
                                out.sums.spread[std::size_t(i)]);
                }
                const std::lock_guard lock(mutex);
                out.lost += walker.GetLost();
                out.cut += walker.Cut();
            });
        },
        monitor, "irradiance");
    out.sums.FindCeiling();
    return out;
}

}  // namespace plumb
