#include "jobs/pictures.h"

#include <algorithm>

#include "heightfield/facet.h"

namespace plumb {

Image<float> CellImage(const HeightField& field, std::span<const double> per_facet) {
    Image<float> image(field.CellsX(), field.CellsY());
    for (std::size_t cell = 0; cell < image.Pixels().size(); ++cell) {
        image.Pixels()[cell] = float((per_facet[2 * cell] + per_facet[2 * cell + 1]) / 2);
    }
    return image;
}

Image<float> ShadedRelief(const HeightField& field) {
    const Vec3 to_light = Vec3(-1, -1, 1.5).normalized();
    std::vector<double> cosine(std::size_t(field.Facets()));
    for (std::int64_t i = 0; i < field.Facets(); ++i) {
        cosine[std::size_t(i)] = std::max(0.0, FacetOf(field, i).normal.dot(to_light));
    }
    return CellImage(field, cosine);
}

}  // namespace plumb
