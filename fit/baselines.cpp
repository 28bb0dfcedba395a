#include "fit/baselines.h"

#include "fit/cavity.h"
#include "fit/gtao_cubic.h"
#include "fit/mayaux_total.h"
#include "fit/plain_visibility.h"

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
            AsPublished<CavityModel>()};
}

}  // namespace plumb
