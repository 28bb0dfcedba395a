// Height fields, light and errors as pictures for eyes.
#pragma once

#include <span>

#include "core/image.h"
#include "heightfield/height_field.h"

namespace plumb {

/// Relief lit from the upper left at 45 degrees, one pixel a cell, row 0 at the top: the mean
/// cosine of the cell's two facets with the light, linear.
Image<float> ShadedRelief(const HeightField& field);

/// One value a facet as one pixel a cell, the mean of its two.
Image<float> CellImage(const HeightField& field, std::span<const double> per_facet);

/// At most so many columns wide: means of whole blocks of pixels, what is left of a block at the
/// right and below dropped. The same picture if it is not wider.
Image<float> Smaller(const Image<float>& image, int most_columns);
Image<Rgb> Smaller(const Image<Rgb>& image, int most_columns);

/// Of a picture of half the size (rounded up), each pixel four times.
Image<float> Doubled(const Image<float>& half, int width_px, int height_px);

}  // namespace plumb
