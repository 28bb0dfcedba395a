// The links of a surface: which facets a facet sees, and with what form factor.
//
//       E_i = V_i + Sum_j F_ij rho_j E_j,        V_i + Sum_j F_ij = 1
//
// F_ij is the share of the cosine-weighted hemisphere of facet i that facet j fills, averaged
// over i's area; what is left is sky. V is stored as 1 - Sum_j F_ij of the very weights that
// the bounces use, so the rows close exactly and the furnace (rho = 1, E = 1) holds by
// construction.
//
// Source   [Mayaux18] "Collecting Data", step 1: the links of each texel.
// Symbols  alpha, V, E as in core/conventions.h; F_ij form factor. All unitless.
// Beware   Light is constant on what a row stands for: a facet here is a piece of one where links
//          are made between pieces (heightfield/facet_pieces.h). V and alpha do not depend on
//          that; bounces are of first order in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/monitor.h"

namespace plumb {

/// The links of kFacetsPerBlock consecutive facets, row after row.
struct LinkBlock {
    std::vector<std::uint32_t> row_begin;  ///< One entry a row and one past the end.
    std::vector<std::uint32_t> facet;      ///< j
    std::vector<float> weight;             ///< F_ij, in (0, 1]
};

struct Links {
    static constexpr std::int64_t kFacetsPerBlock = 1024;

    std::vector<double> alpha;  ///< Uniform visibility of every facet.
    std::vector<double> V;      ///< Cosine visibility of every facet; closes its row.
    std::vector<LinkBlock> blocks;

    /// Mean share of a facet's hemisphere whose light was given to the wrong end because a line
    /// of sight was cut short (never called sky if it does not rise); see the makers of links.
    double mean_cut_short = 0;

    std::int64_t Facets() const { return std::int64_t(V.size()); }
    std::int64_t Count() const;       ///< Links in all.
    std::size_t MemoryBytes() const;  ///< Of the blocks.
};

/// One row under construction: (j, F_ij) in any order, an entry of the same j any number of
/// times.
using LinkRow = std::vector<std::pair<std::uint32_t, double>>;

/// Appends a row to a block, sorted by j, equal j merged, weights rounded to float so that
/// their sum does not exceed 1. Returns V, what the rounded weights leave.
double AppendRow(LinkRow& row, LinkBlock& block);

/// (F x)_i = Sum_j F_ij x_j for all i: one bounce. Cost: 8 bytes streamed and one gather a
/// link.
std::vector<double> Gather(const Links& links, std::span<const double> x,
                           Monitor& monitor = SilentMonitor());

}  // namespace plumb
