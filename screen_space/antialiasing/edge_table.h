// The edge table: how far each method is from the exact coverage of straight edges and of bars.
//
//       RMS = sqrt( mean (value - C)^2 )
//
// over edges at every angle and offset and over the pixels near them: those whose centre is within
// `band_px` of an edge, in the inner part of the picture. Around it each method gets the margin that
// it may depend on, so that no border shows.
//
// Source   ours. Values are shares of coverage: for a filter, the encoded picture's.
// Beware   An offset is a distance along the edge's normal, in equal steps over one pixel: at the
//          angles of the axes that is every phase of the grid once.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "screen_space/antialiasing/coverage_methods.h"

namespace plumb {

struct EdgeTableOptions {
    int angles = 360;      ///< Of the full turn, from 0 in equal steps. [1, 3600]
    int offsets = 64;      ///< Of one pixel, in the middles of equal parts. [1, 1024]
    int inner_px = 16;     ///< Edge of the part that is judged. [4, 256]
    double band_px = 1.5;  ///< (0, 64]
};

/// Throws Error, naming field, value and rule.
void Validate(const EdgeTableOptions& options);

/// How a method does on one kind of strip. Errors are value - coverage.
struct CoverageError {
    std::int64_t pixels = 0;
    double rms = 0, bias = 0, largest = 0;
    double samples = 0;  ///< Mean of a pixel near an edge.
    /// Sum of values over sum of coverages: how much of a bar's light is kept. Of the pixels near
    /// it only.
    double kept = 0;
    std::vector<double> rms_by_angle;  ///< One an angle.
};

/// Of half planes.
CoverageError EdgeError(const CoverageMethod& method, const EdgeTableOptions& options = {});

/// Of bars `width_px` wide, white on black. Offsets are those of their middle line. > 0, <= 64
CoverageError BarError(const CoverageMethod& method, double width_px,
                       const EdgeTableOptions& options = {});

struct EdgeRow {
    std::string method;
    CoverageError edge;
    std::vector<CoverageError> bars;  ///< One a width.
};

/// 0.1, 0.2, ... 2 pixels.
std::vector<double> BarWidthsPx();

std::vector<EdgeRow> EdgeTable(std::span<const CoverageMethod> methods,
                               std::span<const double> bar_widths_px,
                               const EdgeTableOptions& options = {});

}  // namespace plumb
