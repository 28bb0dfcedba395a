// What a truth measures, pass by pass: the points of every net that a pass adds.
#pragma once

#include "core/camera.h"
#include "jobs/truth/truth.h"
#include "jobs/truth/truth_state.h"
#include "rays/ray_caster.h"
#include "truth/pixels.h"

namespace plumb {

/// Everything must outlive it.
class TruthPasses {
  public:
    TruthPasses(const RayCaster& caster, const Scene& scene, const Camera& camera,
                const PixelGeometry& pixels, const TruthJob& job, Monitor& monitor)
        : caster_(caster),
          scene_(scene),
          camera_(camera),
          pixels_(pixels),
          job_(job),
          monitor_(monitor) {}

    /// Doubles the points of `counts`, or takes the first ones. All of it or, if Interrupted is
    /// thrown, nothing reaches `counts`.
    void Next(TruthCounts& counts) const;

    /// V of receiver i, if it is measured.
    static Measured V(const TruthCounts& counts, std::int64_t i);

  private:
    double RmsError(const TruthCounts& counts) const;

    const RayCaster& caster_;
    const Scene& scene_;
    const Camera& camera_;
    const PixelGeometry& pixels_;
    const TruthJob& job_;
    Monitor& monitor_;
};

}  // namespace plumb
