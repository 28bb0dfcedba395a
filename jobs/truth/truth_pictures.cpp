#include "jobs/truth/truth_pictures.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "core/program_monitor.h"

namespace plumb {

void TruthPictures::Add(const std::string& name, double sky,
                        const std::function<Measured(std::int64_t)>& measured) {
    AddMeasured(name, "", sky, PlacesOfReceivers(), measured);
}

void TruthPictures::AddColour(const std::string& name, const RgbSums& of_receivers) {
    AddColour(name, of_receivers, PlacesOfReceivers());
}

void TruthPictures::AddColourOfPixels(const std::string& name, const RgbSums& of_pixels) {
    std::vector<Place> places;
    for (std::size_t p = 0; p < pixels_.depth_m.Pixels().size(); ++p) {
        places.push_back({std::int64_t(p), p});
    }
    AddColour(name, of_pixels, places);
}

void TruthPictures::AddColour(const std::string& name, const RgbSums& sums,
                              const std::vector<Place>& places) {
    for (std::size_t c = 0; c < 3; ++c) {
        AddMeasured(name, std::string(".") + "RGB"[c], 0, places,
                    [&](std::int64_t i) { return sums.Of(i, c); });
    }
}

std::vector<TruthPictures::Place> TruthPictures::PlacesOfReceivers() const {
    std::vector<Place> places;
    for (std::size_t i = 0; i < pixels_.receivers.size(); ++i) {
        places.push_back({std::int64_t(i), pixels_.pixel_of_receiver[i]});
    }
    return places;
}

void TruthPictures::AddMeasured(const std::string& name, const std::string& part, double sky,
                                const std::vector<Place>& places,
                                const std::function<Measured(std::int64_t)>& measured) {
    const int w = pixels_.depth_m.Width(), h = pixels_.depth_m.Height();
    Image<float> value(w, h, float(sky)), error(w, h, 0);
    Image<float> low = value, high = value;
    std::vector<Measured> all(places.size());
    const auto measure = [&](std::int64_t begin, std::int64_t end) {
        for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i) {
            all[i] = measured(places[i].number);
        }
    };
    // An interrupted run still writes what it has.
    ParallelFor(std::int64_t(places.size()), 4096, measure, DeafMonitor());
    TruthQuantity quantity{.name = name + part};
    const double n = double(std::max<std::size_t>(1, places.size()));
    double squares = 0, squares_below = 0, squares_above = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Measured& m = all[i];
        const std::size_t pixel = places[i].pixel;
        value.Pixels()[pixel] = float(m.value);
        error.Pixels()[pixel] = float(m.standard_error);
        low.Pixels()[pixel] = float(m.interval.low);
        high.Pixels()[pixel] = float(m.interval.high);
        quantity.mean += m.value / n;
        squares += m.standard_error * m.standard_error / n;
        squares_below += std::pow(m.value - m.interval.low, 2) / n;
        squares_above += std::pow(m.interval.high - m.value, 2) / n;
    }
    quantity.rms_error = std::sqrt(squares);
    quantity.rms_below = std::sqrt(squares_below);
    quantity.rms_above = std::sqrt(squares_above);
    quantities.push_back(quantity);
    channels.push_back({name + part, std::move(value)});
    channels.push_back({name + ".error" + part, std::move(error)});
    channels.push_back({name + ".low" + part, std::move(low)});
    channels.push_back({name + ".high" + part, std::move(high)});
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
