#include "formfactor/links.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"

namespace plumb {

std::int64_t Links::Count() const {
    std::int64_t count = 0;
    for (const LinkBlock& block : blocks) count += std::int64_t(block.facet.size());
    return count;
}

std::size_t Links::MemoryBytes() const {
    std::size_t bytes = 0;
    for (const LinkBlock& block : blocks) {
        bytes += block.row_begin.capacity() * sizeof(std::uint32_t) +
                 block.facet.capacity() * sizeof(std::uint32_t) +
                 block.weight.capacity() * sizeof(float);
    }
    return bytes;
}

double AppendRow(LinkRow& row, LinkBlock& block) {
    if (block.row_begin.empty()) block.row_begin.push_back(0);
    // Equal j are summed in the order in which they came: a stable sort keeps the bits.
    std::stable_sort(row.begin(), row.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    const std::size_t begin = block.facet.size();
    for (std::size_t k = 0; k < row.size();) {
        double weight = 0;
        const std::uint32_t j = row[k].first;
        for (; k < row.size() && row[k].first == j; ++k) weight += row[k].second;
        if (weight > 0) {
            block.facet.push_back(j);
            block.weight.push_back(float(weight));
        }
    }
    const auto rounded_sum = [&] {
        double sum = 0;
        for (std::size_t k = begin; k < block.weight.size(); ++k) sum += block.weight[k];
        return sum;
    };
    double sum = rounded_sum();
    while (sum > 1) {
        float& largest =
            *std::max_element(block.weight.begin() + std::ptrdiff_t(begin), block.weight.end());
        largest = std::nextafter(largest, 0.0F);
        sum = rounded_sum();
    }
    block.row_begin.push_back(std::uint32_t(block.facet.size()));
    return 1 - sum;
}

std::vector<double> Gather(const Links& links, std::span<const double> x, Monitor& monitor) {
    assert(std::int64_t(x.size()) == links.Facets());
    std::vector<double> y(x.size());
    ParallelFor(
        std::int64_t(links.blocks.size()), 1,
        [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t b = begin; b < end; ++b) {
                const LinkBlock& block = links.blocks[std::size_t(b)];
                const std::size_t rows = block.row_begin.size() - 1;
                for (std::size_t r = 0; r < rows; ++r) {
                    double sum = 0;
                    for (std::uint32_t k = block.row_begin[r]; k < block.row_begin[r + 1];
                         ++k) {
                        sum += double(block.weight[k]) * x[block.facet[k]];
                    }
                    y[std::size_t(b * Links::kFacetsPerBlock) + r] = sum;
                }
            }
        },
        monitor);
    return y;
}

}  // namespace plumb
