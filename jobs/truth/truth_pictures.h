// From counts to channels: what truth.exr holds and what the report says of it.
//
//       NAME, NAME.error    value and standard error
//       NAME.low, NAME.high the ends of its 95 % interval (truth/replicates.h), which is not
//                           about the value where events are rare
//
// Where the sky is seen, a quantity has the value that the caller names, no error, and an
// interval of no width.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/image_io.h"
#include "reports/truth_report.h"
#include "truth/pixels.h"
#include "truth/replicates.h"
#include "truth/rgb_sums.h"

namespace plumb {

class TruthPictures {
  public:
    explicit TruthPictures(const PixelGeometry& pixels) : pixels_(pixels) {}

    /// Channels `name`, `name.error`, `name.low` and `name.high` of a quantity of receiver i;
    /// `measured` is called from several threads.
    void Add(const std::string& name, double sky,
             const std::function<Measured(std::int64_t)>& measured);

    /// The same of a colour: name.R ..., name.error.R ...; where the sky is seen 0.
    void AddColour(const std::string& name, const RgbSums& of_receivers);

    /// The same of every pixel, the sky too.
    void AddColourOfPixels(const std::string& name, const RgbSums& of_pixels);

    /// depth_m, normal.xyz, position_m.xyz, albedo.RGB and triangle_bits.
    void AddGeometry();

    std::vector<NamedChannel> channels;
    std::vector<TruthQuantity> quantities;

  private:
    struct Place {
        std::int64_t number;  // Of the receiver, or of the pixel.
        std::size_t pixel;
    };

    void AddColour(const std::string& name, const RgbSums& sums,
                   const std::vector<Place>& places);
    /// `part`: ".R" of a colour, or nothing.
    void AddMeasured(const std::string& name, const std::string& part, double sky,
                     const std::vector<Place>& places,
                     const std::function<Measured(std::int64_t)>& measured);
    std::vector<Place> PlacesOfReceivers() const;
    void AddPlain(const std::string& name, const std::function<float(std::size_t)>& of_pixel);

    const PixelGeometry& pixels_;
};

}  // namespace plumb
