// From counts to channels: what truth.exr holds and what the report says of it.
//
// Where the sky is seen, a quantity has the value that the caller names and no error.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/image_io.h"
#include "reports/truth_report.h"
#include "truth/pixels.h"
#include "truth/replicates.h"

namespace plumb {

class TruthPictures {
  public:
    explicit TruthPictures(const PixelGeometry& pixels) : pixels_(pixels) {}

    /// Channels `name` and `name.error` of a quantity of receiver i.
    void Add(const std::string& name, double sky,
             const std::function<Measured(std::int64_t)>& measured);

    /// depth_m, normal.xyz, position_m.xyz, albedo.RGB and triangle_bits.
    void AddGeometry();

    std::vector<NamedChannel> channels;
    std::vector<TruthQuantity> quantities;

  private:
    void AddPlain(const std::string& name, const std::function<float(std::size_t)>& of_pixel);

    const PixelGeometry& pixels_;
};

}  // namespace plumb
