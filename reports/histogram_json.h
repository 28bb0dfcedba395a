// A histogram of bounces as JSON, and back: what `simulate` writes can be fitted later.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/bounce_histogram.h"

namespace plumb {

nlohmann::ordered_json ToJson(const BounceHistogram& histogram);

/// The same histogram, bit for bit. Throws Error naming `document` (for the message), field,
/// value and rule if it is not one.
BounceHistogram HistogramFromJson(const nlohmann::ordered_json& json,
                                  const std::string& document);

}  // namespace plumb
