#include "jobs/truth_pictures.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace plumb {

void TruthPictures::Add(const std::string& name, double sky,
                        const std::function<Measured(std::int64_t)>& measured) {
    const int w = pixels_.depth_m.Width(), h = pixels_.depth_m.Height();
    Image<float> value(w, h, float(sky)), error(w, h, 0);
    TruthQuantity quantity{.name = name, .mean = 0, .rms_error = 0};
    const double n = double(std::max<std::size_t>(1, pixels_.receivers.size()));
    double squares = 0;
    for (std::size_t i = 0; i < pixels_.receivers.size(); ++i) {
        const Measured m = measured(std::int64_t(i));
        const std::uint32_t pixel = pixels_.pixel_of_receiver[i];
        value.Pixels()[pixel] = float(m.value);
        error.Pixels()[pixel] = float(m.standard_error);
        quantity.mean += m.value / n;
        squares += m.standard_error * m.standard_error / n;
    }
    quantity.rms_error = std::sqrt(squares);
    quantities.push_back(quantity);
    channels.push_back({name, std::move(value)});
    channels.push_back({name + ".error", std::move(error)});
}

void TruthPictures::AddPlain(const std::string& name,
                             const std::function<float(std::size_t)>& of_pixel) {
    Image<float> image(pixels_.depth_m.Width(), pixels_.depth_m.Height());
    for (std::size_t p = 0; p < image.Pixels().size(); ++p) image.Pixels()[p] = of_pixel(p);
    channels.push_back({name, std::move(image)});
}

void TruthPictures::AddGeometry() {
    AddPlain("depth_m", [&](std::size_t p) { return pixels_.depth_m.Pixels()[p]; });
    for (int c = 0; c < 3; ++c) {
        const std::string axis(1, "xyz"[c]);
        AddPlain("normal." + axis,
                 [&](std::size_t p) { return pixels_.normal.Pixels()[p][c]; });
        AddPlain("position_m." + axis,
                 [&](std::size_t p) { return pixels_.position_m.Pixels()[p][c]; });
        AddPlain("albedo." + std::string(1, "RGB"[c]),
                 [&](std::size_t p) { return pixels_.albedo.Pixels()[p][std::size_t(c)]; });
    }
    // As bits: a float holds whole numbers up to 2^24 only.
    AddPlain("triangle_bits",
             [&](std::size_t p) { return std::bit_cast<float>(pixels_.triangle.Pixels()[p]); });
}

}  // namespace plumb
