#include "jobs/light/albedo_light.h"

#include <string>

#include "core/error.h"
#include "formfactor/total.h"
#include "heightfield/facet.h"

namespace plumb {

std::array<std::vector<double>, 3> FacetAlbedos(const HeightField& field,
                                                const Image<Rgb>& albedo) {
    if (albedo.Width() != field.Width() || albedo.Height() != field.Height()) {
        throw Error("albedo map: " + std::to_string(albedo.Width()) + " x " +
                    std::to_string(albedo.Height()) + " pixels, must be " +
                    std::to_string(field.Width()) + " x " + std::to_string(field.Height()) +
                    ", one a texel");
    }
    for (int j = 0; j < albedo.Height(); ++j) {
        for (int i = 0; i < albedo.Width(); ++i) {
            for (const float rho : albedo(i, j)) {
                if (!(rho >= 0 && rho <= 1)) {
                    throw Error(MustBe("albedo map: pixel (" + std::to_string(i) + ", " +
                                           std::to_string(j) + ")",
                                       rho, "in [0, 1]"));
                }
            }
        }
    }
    std::array<std::vector<double>, 3> out;
    for (auto& channel : out) channel.resize(std::size_t(field.Facets()));
    for (std::int64_t f = 0; f < field.Facets(); ++f) {
        const std::array<TexelIndex, 3> corners = FacetTexels(field, f);
        for (std::size_t c = 0; c < 3; ++c) {
            double sum = 0;
            for (const TexelIndex& texel : corners) sum += albedo(texel.i, texel.j)[c];
            out[c][std::size_t(f)] = sum / 3;
        }
    }
    return out;
}

std::array<std::vector<double>, 3> ColouredLight(
    const Links& links, const FacetPieces& pieces,
    const std::array<std::vector<double>, 3>& albedo, Monitor& monitor) {
    std::array<std::vector<double>, 3> out;
    for (std::size_t c = 0; c < 3; ++c) {
        // A grey surface is solved once.
        if (c > 0 && albedo[c] == albedo[c - 1]) {
            out[c] = out[c - 1];
            continue;
        }
        std::vector<double> of_pieces(std::size_t(pieces.Count()));
        for (std::size_t p = 0; p < of_pieces.size(); ++p) {
            of_pieces[p] = albedo[c][std::size_t(pieces.FacetOf(std::int64_t(p)))];
        }
        const TotalLight total = SolveTotal(links, of_pieces, 1e-8, monitor);
        if (!total.converged) {
            throw Error("albedo: the light did not converge, residual " +
                        std::to_string(total.residual));
        }
        out[c] = pieces.FacetMeans(std::span<const double>(total.E));
    }
    return out;
}

}  // namespace plumb
