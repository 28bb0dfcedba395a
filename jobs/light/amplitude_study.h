// One map with its heights stretched from almost flat to almost closed.
//
// Source   [Mayaux18] "Effect of Maximum Height over the Curves".
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/monitor.h"
#include "fit/model.h"
#include "heightfield/height_field.h"
#include "jobs/light/simulate_surface.h"
#include "reports/amplitude_sweep.h"

namespace plumb {

/// What a report calls MiddleOf(field, n): the name, and which part of the map it is.
std::string NameOfMiddle(const std::string& name, const HeightField& field, int n);

/// Shares of the width from 0.1 % to 1000 %, three a decade.
std::vector<double> SweptAmplitudes();

/// Simulates `field` at every share of its width (of the piece, where it is one). If given, `recommended` and `published` are
/// scored at each amplitude. Throws Error if the field is flat.
AmplitudeSweep StudyAmplitude(const std::string& name, const HeightField& field,
                              std::span<const double> shares_of_width,
                              const SimulateSettings& settings,
                              const Formula* recommended = nullptr,
                              const Formula* published = nullptr,
                              Monitor& monitor = SilentMonitor());

}  // namespace plumb
