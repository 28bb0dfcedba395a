// The loop that all makers of links share: rows in blocks, blocks over the cores.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/parallel.h"
#include "formfactor/links.h"

namespace plumb {

/// What a maker says of one facet besides its row.
struct FacetResult {
    double alpha, V;
    double cut_short;  ///< Share of the hemisphere given to the wrong end at worst.
};

/// Links of `facets` facets. `new_maker()` gives an object that one thread uses for one block;
/// its FacetResult Make(facet, block) appends one row to the block.
template <class NewMaker>
Links MakeLinks(std::int64_t facets, NewMaker&& new_maker, Monitor& monitor) {
    Links links;
    links.alpha.resize(std::size_t(facets));
    links.V.resize(std::size_t(facets));
    const std::int64_t per_block = Links::kFacetsPerBlock;
    links.blocks.resize(std::size_t((facets + per_block - 1) / per_block));
    std::vector<double> cut_short(links.blocks.size());
    ParallelFor(
        std::int64_t(links.blocks.size()), 1,
        [&](std::int64_t first, std::int64_t last) {
            for (std::int64_t b = first; b < last; ++b) {
                auto maker = new_maker();
                LinkBlock& block = links.blocks[std::size_t(b)];
                const std::int64_t end = std::min((b + 1) * per_block, facets);
                for (std::int64_t i = b * per_block; i < end; ++i) {
                    const FacetResult result = maker.Make(i, block);
                    links.alpha[std::size_t(i)] = result.alpha;
                    links.V[std::size_t(i)] = result.V;
                    cut_short[std::size_t(b)] += result.cut_short;
                }
                block.facet.shrink_to_fit();
                block.weight.shrink_to_fit();
            }
        },
        monitor, "links");
    for (const double share : cut_short) links.mean_cut_short += share / double(facets);
    return links;
}

}  // namespace plumb
