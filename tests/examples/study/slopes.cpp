#include "tests/examples/study/slopes.h"

#include <cmath>
#include <numbers>

#include "heightfield/facet.h"

namespace plumb {

doc::Section StudySlopes(const HeightField& field) {
    doc::Table table{.key = "slopes",
                     .columns = {{.key = "slope_deg",
                                  .title = "Steeper than",
                                  .unit = "°",
                                  .role = doc::Role::kName},
                                 {.key = "share", .title = "Share of the facets"}}};
    for (const int slope_deg : {15, 30, 45, 60}) {
        const double least_nz = std::cos(slope_deg * std::numbers::pi / 180);
        std::int64_t steeper = 0;
        for (std::int64_t i = 0; i < field.Facets(); ++i) {
            steeper += FacetOf(field, i).normal.z() < least_nz;
        }
        table.Add({slope_deg, double(steeper) / double(field.Facets())});
    }
    return {.id = "slopes",
            .title = "How steep it is",
            .sentences = {"A facet's slope is the angle between its normal and the vertical."},
            .facts = {{{.key = "facets", .title = "Facets"}, field.Facets()}},
            .tables = {std::move(table)}};
}

}  // namespace plumb
