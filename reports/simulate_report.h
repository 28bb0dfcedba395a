// What a light simulation of one height map says.
//
// Symbols  alpha, V, E_k, E(rho) as in core/conventions.h.
#pragma once

#include <optional>

#include "reports/amplitude_sweep.h"
#include "reports/document.h"
#include "reports/provenance.h"
#include "reports/surface_report.h"
#include "reports/timings.h"

namespace plumb {

struct SimulateReport {
    Provenance provenance;  ///< Of one map.
    SurfaceReport surface;
    std::optional<AmplitudeSweep> amplitudes;
    Timings timings;
};

/// Findings, figures, light over both visibilities, the amplitude sweep, what went in. Throws
/// Error unless it is of one map.
doc::Document DocumentOf(const SimulateReport& report);

}  // namespace plumb
