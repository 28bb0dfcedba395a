// What a light simulation of one height map says: a page, a JSON document, a table.
//
// Pure, as reports/fit_report.h: the same input gives the same bytes if `timings` is empty.
//
// Symbols  alpha, V, E_k, E(rho) as in core/conventions.h.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <ostream>
#include <string>

#include "reports/amplitude_sweep.h"
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

/// Everything but the pictures.
nlohmann::ordered_json ToJson(const SimulateReport& report);

/// The same as the text of a file; see reports/json_text.h.
std::string ToJsonText(const SimulateReport& report);

/// One page that needs nothing else: it opens offline.
std::string ToHtml(const SimulateReport& report);

/// The figures of the surface, for a terminal.
void WriteTable(std::ostream& out, const SimulateReport& report);

}  // namespace plumb
