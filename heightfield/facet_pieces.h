// Pieces of steep facets: strips between level lines, on each of which light may differ.
//
//       m = ceil( (z_2 - z_0) / (e sqrt(s_x s_y)) )   strips of equal height,   1 <= m <= m_max
//
// A wall is one facet high at any resolution, and light that is constant over a facet does not
// converge on it. The surface stays what it is: only what light is constant on becomes smaller.
// The share of a facet below height z, in area and in footprint alike, is
//
//       S(z) = (z - z_0)^2 / ((z_1 - z_0) (z_2 - z_0))           z <= z_1
//              1 - (z_2 - z)^2 / ((z_2 - z_1) (z_2 - z_0))       z >= z_1
//
// Source   ours.
// Symbols  z_0 <= z_1 <= z_2 heights of a facet's corners (m), s_x, s_y spacing (m), e largest
//          extent of a strip in texels (unitless).
// Beware   Pieces are numbered facet after facet, upwards within each; where nothing is cut the
//          piece is the facet and has its number.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "heightfield/facet.h"
#include "heightfield/height_field.h"

namespace plumb {

struct CutOptions {
    double extent_texels = 0;  ///< e; 0 = no facet is cut. [0, ...)
    int most_pieces = 8;       ///< m_max. [1, 256]
};

/// Throws Error, naming field, value and rule.
void Validate(const CutOptions& options);

class FacetPieces {
  public:
    explicit FacetPieces(const HeightField& field, const CutOptions& options = {});

    std::int64_t Count() const { return count_; }
    std::int64_t Facets() const { return facets_; }

    /// The pieces of a facet: First(f) ... First(f) + PiecesOf(f) - 1.
    std::int64_t First(std::int64_t facet) const {
        return first_.empty() ? facet : first_[std::size_t(facet)];
    }
    int PiecesOf(std::int64_t facet) const {
        return first_.empty()
                   ? 1
                   : int(first_[std::size_t(facet) + 1] - first_[std::size_t(facet)]);
    }
    std::int64_t FacetOf(std::int64_t piece) const {
        return facet_.empty() ? piece : facet_[std::size_t(piece)];
    }

    /// Lowest height of a piece of a cut facet. [m]
    double LowM(std::int64_t piece) const { return low_m_[std::size_t(piece)]; }

    /// The piece of `facet` at a height; beyond the facet's heights, the lowest or highest.
    std::int64_t At(std::int64_t facet, double z_m) const {
        const std::int64_t first = First(facet), last = first + PiecesOf(facet) - 1;
        std::int64_t piece = first;
        while (piece < last && z_m >= LowM(piece + 1)) ++piece;
        return piece;
    }

    /// Its share of its facet's area. (0, 1]
    double Share(std::int64_t piece) const {
        return share_.empty() ? 1 : share_[std::size_t(piece)];
    }

    /// Means over facets of values of pieces, weighted by Share.
    template <class T>
    std::vector<T> FacetMeans(std::span<const T> of_pieces) const;

  private:
    std::int64_t facets_, count_;
    // Empty where nothing is cut.
    std::vector<std::uint32_t> first_, facet_;
    std::vector<double> low_m_, share_;
};

/// The point of a facet that has the share `u` of its area below it, at the share `v` along its
/// level line: uniform over the facet if (u, v) is over the unit square. u, v in [0, 1].
Vec3 PointAboveShareM(const Facet& facet, double u, double v);

/// S(z) of the header.
double ShareBelow(const Facet& facet, double z_m);

template <class T>
std::vector<T> FacetPieces::FacetMeans(std::span<const T> of_pieces) const {
    if (first_.empty()) return {of_pieces.begin(), of_pieces.end()};
    std::vector<T> means(first_.size() - 1);
    for (std::size_t f = 0; f < means.size(); ++f) {
        if (first_[f + 1] - first_[f] == 1) {
            means[f] = of_pieces[first_[f]];
            continue;
        }
        double mean = 0;
        for (std::size_t p = first_[f]; p < first_[f + 1]; ++p) {
            mean += share_[p] * double(of_pieces[p]);
        }
        means[f] = T(mean);
    }
    return means;
}

}  // namespace plumb
