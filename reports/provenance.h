// Where the numbers of a report come from: enough to compute them again.
//
// Nothing here may differ from run to run on the same input: no clock, host or absolute path.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace plumb {

/// One height map as it went into the simulation.
struct MapSource {
    std::string name;
    std::string file;    ///< Name without folder; empty if the map was made by the program.
    std::string sha256;  ///< Of the file (or of the heights made), lower-case hex.
    int width_texels = 0, height_texels = 0;
    double spacing_x_m = 0, spacing_y_m = 0;
    double amplitude_m = 0;   ///< Highest minus lowest height.
    std::string boundary;     ///< "wrap", "mirror" or "open".
    std::string preparation;  ///< Filters that were run, with their numbers; empty = none.
    std::string source;       ///< Who made the map.
    std::string licence;
};

/// How the hemisphere of a facet was covered.
struct Sampling {
    std::string method;  ///< "slices" or "rays".
    int per_facet = 0;   ///< Slices or rays of a facet.
    std::uint64_t seed = 0;
    double cut_texels =
        0;                ///< Height of the strips that steep facets are cut into; 0 = none is.
    int most_pieces = 1;  ///< Of one facet.
};

struct Provenance {
    std::string tool_version;     ///< Of this program, from CMake.
    std::string command;          ///< The command line that makes the report again.
    std::vector<MapSource> maps;  ///< In the order of the report's maps.
    Sampling sampling;
    int bounces = 0;              ///< K: bounces whose curves are kept.
    int bins = 0;                 ///< Bins of a histogram over [0, 1].
    std::vector<double> albedos;  ///< rho of the totals.
    std::string weighting;        ///< Of the fits' samples; empty if nothing was fitted.
};

}  // namespace plumb
