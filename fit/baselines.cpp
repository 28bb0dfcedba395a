#include "fit/baselines.h"

#include "fit/models/gtao_cubic.h"
#include "fit/models/mayaux_total.h"
#include "fit/models/plain_visibility.h"
#include "fit/models/uniform_cavity.h"

namespace plumb {
namespace {

template <class M>
Formula AsPublished() {
    return AtInitialValues(ModelOf<M>(), std::string(M::kName));
}

}  // namespace

std::vector<Formula> Baselines() {
    return {AsPublished<PlainAlphaModel>(),
            AsPublished<PlainVModel>(),
            AsPublished<MayauxTotalModel<PoleGuard::kNone>>(),
            AsPublished<MayauxTotalModel<PoleGuard::kDemo>>(),
            AsPublished<MayauxTotalModel<PoleGuard::kPort>>(),
            AsPublished<MayauxTotalModel<PoleGuard::kPortHalfAlbedo>>(),
            AsPublished<GtaoCubicModel>(),
            AsPublished<GtaoCubicFedAlphaModel>(),
            AsPublished<UniformCavityModel>()};
}

}  // namespace plumb
