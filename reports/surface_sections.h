// The parts of documents that speak of surfaces: figures, pictures, histograms, the amplitude
// sweep, and what went into a run.
#pragma once

#include <span>
#include <string>
#include <utility>
#include <vector>

#include "reports/amplitude_sweep.h"
#include "reports/document.h"
#include "reports/provenance.h"
#include "reports/surface_report.h"
#include "reports/timings.h"

namespace plumb {

/// Its figures one by one.
std::vector<doc::Fact> FactsOf(const SurfaceFigures& figures);

/// A row a map.
doc::Table FiguresTable(std::span<const SurfaceReport> maps);

/// Relief and V, those that there are.
std::vector<doc::Picture> PicturesOf(const SurfaceReport& map);

/// A row a bin that holds facets, of all histograms, each called by its name in column `what`;
/// the other columns are those of the histogram's own CSV (docs/light.md). Data.
doc::Table HistogramTable(
    std::string key, std::string title, std::string what,
    const std::vector<std::pair<std::string, const BounceHistogram*>>& histograms);

doc::Section AmplitudeSection(const AmplitudeSweep& sweep);

/// Command, version, seed and maps.
doc::Provenance DocumentProvenance(const Provenance& provenance);

/// Maps, sampling and, if there are any, times of the stages.
doc::Section OriginSection(const Provenance& provenance, const Timings& timings);

}  // namespace plumb
