// The forms of the total set against each other: chosen on one half of the maps, reported on the
// other (reports/form_choice.h).
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "core/monitor.h"
#include "fit/least_squares.h"
#include "fit/samples.h"
#include "jobs/light/simulate_surface.h"
#include "reports/form_choice.h"

namespace plumb {

/// The forms that are compared: all models of E(rho) that keep its laws, and the GTAO cubic.
std::vector<std::string_view> ComparedForms();

/// Each form that has constants is fitted with `options`. None with fewer than four maps: of two
/// that choose, one is held out.
std::optional<FormChoice> ChooseForm(std::span<const SurfaceLight> lights,
                                     std::span<const std::string_view> forms,
                                     const SampleOptions& sampling,
                                     const LeastSquaresOptions& options,
                                     Monitor& monitor = SilentMonitor());

}  // namespace plumb
