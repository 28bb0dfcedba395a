// Light bounce by bounce, and what all bounces sum to for any albedo.
//
//       E_0 = V,     E_{k+1} = F E_k                        at albedo 1
//       E(rho) = Sum_k rho^k E_k                            for one albedo everywhere
//
// The series is cut where its tail no longer matters. With R_k = 1 - (E_0 + ... + E_k), the
// light still under way at albedo 1 (exact, since rows close), the rest of E(rho) after bounce
// k lies in [0, rho^(k+1) R_k]; what is added for it is the sum of a geometric series of ratio
// q,
//
//       rho^(k+1) R_k (1 - q) / (1 - rho q),     q = R_k / R_(k-1)
//
// and bounces go on until that closure moves no facet's E(rho) by more than a tolerance.
//
// Source   [Mayaux18 eq. 5] and "Collecting Data", step 3. The tail is ours: 20 bounces leave a
//          tenth of the light under way at the bottom of deep pits.
// Symbols  E_k, E(rho), rho as in core/conventions.h; F links; R_k light under way; q ratio.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "formfactor/links.h"
#include "heightfield/facet_pieces.h"

namespace plumb {

/// E_0 ... E_K at albedo 1, handed over one after the other; `visit` gets k and E_k of every
/// facet. Throws Error unless bounces >= 0.
void ForEachBounce(const Links& links, int bounces,
                   const std::function<void(int k, std::span<const double> E_k)>& visit,
                   Monitor& monitor = SilentMonitor());

struct SeriesOptions {
    int bounces = 20;             ///< K: how many E_k are handed over. [0, 1000]
    std::vector<double> albedos;  ///< rho of the totals, each in [0, 1].
    double tolerance = 1e-5;      ///< Largest move of a total when bounces stop. (0, 1)
    int max_bounces = 1000;       ///< Bounces go no further than this. [1, 100000]
};

/// Throws Error, naming field, value and rule.
void Validate(const SeriesOptions& options);

struct Series {
    std::vector<std::vector<float>> total;  ///< E(rho) of every facet, for each albedo.
    int bounces_run = 0;                    ///< Including those only the totals needed.
    bool settled = false;                   ///< Within the tolerance before max_bounces.
    double last_move = 0;                   ///< Largest move of a total by the last bounce.
    double largest_under_way = 0;           ///< max_i R_k at the end, at albedo 1.
};

/// The series with totals. `visit` sees E_0 ... E_K. Memory: 12 bytes a facet and albedo.
Series RunSeries(const Links& links, const SeriesOptions& options,
                 const std::function<void(int k, std::span<const double> E_k)>& visit,
                 Monitor& monitor = SilentMonitor());

/// The same for links between pieces of facets: light bounces between pieces, and `visit` and the
/// series have its mean over each facet. The rest of a mean is the mean of the rests, so what the
/// header says of the tail holds for facets too.
Series RunSeries(const Links& links, const FacetPieces& pieces, const SeriesOptions& options,
                 const std::function<void(int k, std::span<const double> E_k)>& visit,
                 Monitor& monitor = SilentMonitor());

}  // namespace plumb
