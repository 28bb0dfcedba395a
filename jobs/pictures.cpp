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

namespace {

template <class T, class Add>
Image<T> MeanBlocks(const Image<T>& image, int most_columns, const Add& add) {
    const int block = (image.Width() + most_columns - 1) / most_columns;
    if (block <= 1 || image.Height() < block) return image;
    Image<T> smaller(image.Width() / block, image.Height() / block, T{});
    const float share = 1.0F / float(block * block);
    for (int j = 0; j < smaller.Height() * block; ++j) {
        for (int i = 0; i < smaller.Width() * block; ++i) {
            add(smaller(i / block, j / block), image(i, j), share);
        }
    }
    return smaller;
}

}  // namespace

Image<float> Smaller(const Image<float>& image, int most_columns) {
    return MeanBlocks(image, most_columns,
                      [](float& sum, float value, float share) { sum += share * value; });
}

Image<Rgb> Smaller(const Image<Rgb>& image, int most_columns) {
    return MeanBlocks(image, most_columns, [](Rgb& sum, const Rgb& value, float share) {
        for (std::size_t c = 0; c < 3; ++c) sum[c] += share * value[c];
    });
}

Image<float> Doubled(const Image<float>& half, int width_px, int height_px) {
    Image<float> image(width_px, height_px);
    for (int j = 0; j < height_px; ++j) {
        for (int i = 0; i < width_px; ++i) {
            image(i, j) =
                half(std::min(i / 2, half.Width() - 1), std::min(j / 2, half.Height() - 1));
        }
    }
    return image;
}

}  // namespace plumb
