#include "formfactor/slice_links.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/conventions.h"
#include "core/error.h"
#include "core/random.h"
#include "formfactor/make_links.h"
#include "heightfield/facet.h"
#include "heightfield/facet_walk.h"

namespace plumb {
namespace {

// Dimensions of the random numbers of one facet, apart from those of its origins.
constexpr std::uint32_t kRotation = 0, kDrawTogether = 1;

struct Stretch {
    std::uint32_t facet;
    double weight;
};

// Zenith angle and its sine and cosine of a line of slope m.
struct Zenith {
    double theta, sin, cos;
    explicit Zenith(double m) : theta(std::atan2(1.0, m)) {
        const double s = 1 / std::sqrt(1 + m * m);
        sin = s, cos = m * s;
    }
};

// G of the header for the cosine measure.
double CosineBelow(const Zenith& z, double c, double n_z) {
    return (c * (z.theta - z.sin * z.cos) + n_z * z.sin * z.sin) / 2;
}

// Draws thin neighbours together; see SliceOptions::links_per_slice.
void AppendDrawnTogether(const std::vector<Stretch>& stretches, int most, double scale,
                         const SliceOptions& o, std::uint64_t facet, std::uint32_t slice,
                         LinkRow& row) {
    if (int(stretches.size()) <= most) {
        for (const Stretch& s : stretches) row.emplace_back(s.facet, s.weight * scale);
        return;
    }
    double seen = 0;
    for (const Stretch& s : stretches) seen += s.weight;
    const double thin = seen / most;
    double run = 0;
    std::uint32_t chosen = 0, draws = 0;
    for (const Stretch& s : stretches) {
        if (s.weight >= thin) {
            row.emplace_back(s.facet, s.weight * scale);
            continue;
        }
        run += s.weight;
        // Keeps each member of the run with a chance proportional to its weight.
        const double xi = RandomUnit(o.seed, facet, slice, kDrawTogether + draws++);
        if (xi * run < s.weight) chosen = s.facet;
        if (run >= thin) {
            row.emplace_back(chosen, run * scale);
            run = 0;
        }
    }
    if (run > 0) row.emplace_back(chosen, run * scale);
}

// Everything that one thread needs to make the row of one facet after another.
class SliceRow {
  public:
    SliceRow(const HeightField& field, const FacetPieces& pieces, const WalkGrid& grid,
             const SliceOptions& options, const Monitor& monitor)
        : field_(field),
          pieces_(pieces),
          grid_(grid),
          options_(options),
          monitor_(monitor),
          far_m_(FarM(field, options)),
          z_rounding_m_(kRoundings *
                        std::max(std::abs(field.LowestM()), std::abs(field.HighestM()))),
          xy_rounding_m_(kRoundings * (field.WidthM() + field.HeightM())) {}

    FacetResult Make(std::int64_t piece, LinkBlock& block) {
        const std::int64_t facet = pieces_.FacetOf(piece);
        const Facet f = FacetOf(field_, facet);
        const int slices = SlicesAPiece(options_.slices, pieces_.PiecesOf(facet));
        const double turn = options_.rotate
                                ? RandomUnit(options_.seed, std::uint64_t(piece), 0, kRotation)
                                : 0.5;
        row_.clear();
        slices_.clear();
        stretches_.clear();
        double cosine_all = 0, solid_all = 0, solid_open = 0, cut_short = 0;
        for (int k = 0; k < slices; ++k) {
            // A slice through a forest of towers can be long, a block of rows longer than anyone
            // waits for.
            if (monitor_.Cancelled()) throw Interrupted();
            const double phi = 2 * kPi * (k + turn) / slices;
            const Slice slice = Look(f, facet, piece, k, std::cos(phi), std::sin(phi));
            cosine_all += slice.cosine_all;
            solid_all += slice.solid_all;
            solid_open += slice.solid_open;
            cut_short += slice.cut_short;
        }
        std::size_t begin = 0;
        for (std::size_t k = 0; k < slices_.size(); ++k) {
            one_.assign(stretches_.begin() + std::ptrdiff_t(begin),
                        stretches_.begin() + std::ptrdiff_t(slices_[k]));
            begin = slices_[k];
            AppendDrawnTogether(one_, options_.links_per_slice, 1 / cosine_all, options_,
                                std::uint64_t(piece), std::uint32_t(k), row_);
        }
        const double V = AppendRow(row_, block);
        // A facet that sees only sky has alpha = 1 exactly: the sums are then the same numbers.
        return {solid_open / solid_all, V, cut_short / cosine_all};
    }

  private:
    // A crossing knows heights and positions to a few roundings of the largest of them.
    static constexpr double kRoundings = 16 * std::numeric_limits<double>::epsilon();

    struct Slice {
        double cosine_all, solid_all, solid_open, cut_short;
    };

    static double FarM(const HeightField& field, const SliceOptions& options) {
        const double relief = field.HighestM() - field.LowestM();
        return relief / options.horizon_tolerance_rad + field.WidthM() + field.HeightM();
    }

    Slice Look(const Facet& f, std::int64_t facet, std::int64_t piece, int k, double cos_phi,
               double sin_phi) {
        const Vec3 x =
            OriginM(f, pieces_, piece, options_.origins, options_.seed, std::uint32_t(k));
        const double c = f.normal.x() * cos_phi + f.normal.y() * sin_phi, n_z = f.normal.z();
        double horizon = -c / n_z;
        const Zenith plane(horizon);
        Slice out{CosineBelow(plane, c, n_z), 1 - plane.cos, 0, 0};
        double below = out.cosine_all;  // G at the horizon so far.
        const std::size_t begin = stretches_.size();
        const WalkGrid::Start start{facet,
                                    x.x() - 0.5 * field_.SpacingXM(),
                                    x.y() - 0.5 * field_.SpacingYM(),
                                    x.z(),
                                    cos_phi,
                                    sin_phi};
        grid_.Walk(start, horizon, far_m_, options_.horizon_tolerance_rad,
                   [&](const WalkGrid::Crossing& crossing, double& slope) {
                       // Level with the horizon up to rounding: facets of one plane do not
                       // see each other.
                       const double rounding_m =
                           z_rounding_m_ + std::abs(slope) * xy_rounding_m_;
                       if (crossing.rise_m <= slope * crossing.t_m + rounding_m) return true;
                       const double before = slope;
                       slope = horizon = crossing.rise_m / crossing.t_m;
                       const auto see = [&](std::int64_t seen, double up_to) {
                           const double next = CosineBelow(Zenith(up_to), c, n_z);
                           const double weight = below - next;
                           below = next;
                           if (weight > 0) stretches_.push_back({std::uint32_t(seen), weight});
                       };
                       if (pieces_.PiecesOf(crossing.facet) == 1) {
                           see(pieces_.First(crossing.facet), slope);
                       } else {
                           SeePieces(crossing, x.z(), before, see);
                       }
                       return true;
                   });
        Zenith last(horizon);
        if (field_.GetBoundary() != Boundary::kOpen && horizon < 0) {
            // An endless surface hides all that lies below the horizontal.
            const Zenith level(0.0);
            const double next = CosineBelow(level, c, n_z);
            if (below > next) {
                out.cut_short = below - next;
                if (stretches_.size() == begin) stretches_.push_back({std::uint32_t(piece), 0});
                stretches_.back().weight += below - next;
                last = level;
            }
        }
        out.solid_open = 1 - last.cos;
        slices_.push_back(stretches_.size());
        return out;
    }

    // What the line of sight sees of a cut facet as it rises from slope `before` to that of the
    // crossing: piece after piece, up or down.
    template <class See>
    void SeePieces(const WalkGrid::Crossing& crossing, double z_m, double before,
                   See&& see) const {
        const double slope = crossing.rise_m / crossing.t_m;
        const std::int64_t last = pieces_.At(crossing.facet, z_m + crossing.rise_m);
        // Where the line of slope `before` meets the facet's plane.
        const double closing = before - crossing.grade;
        const double t_m = (crossing.rise_m - crossing.grade * crossing.t_m) / closing;
        std::int64_t piece =
            closing == 0 ? last : pieces_.At(crossing.facet, z_m + before * t_m);
        double seen = before;
        for (; piece != last; piece += piece < last ? 1 : -1) {
            const double border_m = pieces_.LowM(piece < last ? piece + 1 : piece) - z_m;
            const double t_border_m =
                crossing.t_m + (border_m - crossing.rise_m) / crossing.grade;
            const double up_to = border_m / t_border_m;
            if (!(up_to > seen && up_to < slope)) continue;  // Rounding, or crossing.grade = 0.
            see(piece, up_to);
            seen = up_to;
        }
        see(last, slope);
    }

    const HeightField& field_;
    const FacetPieces& pieces_;
    const WalkGrid& grid_;
    const SliceOptions& options_;
    const Monitor& monitor_;
    double far_m_, z_rounding_m_, xy_rounding_m_;
    LinkRow row_;
    std::vector<Stretch> stretches_, one_;  // Of all slices of a facet; of one of them.
    std::vector<std::size_t> slices_;       // Where each slice's stretches end.
};

}  // namespace

void Validate(const SliceOptions& o) {
    if (o.slices < 4 || o.slices > 65536) {
        throw Error(MustBe("SliceOptions::slices", o.slices, "in [4, 65536]"));
    }
    if (o.links_per_slice < 1) {
        throw Error(MustBe("SliceOptions::links_per_slice", o.links_per_slice, ">= 1"));
    }
    if (!(o.horizon_tolerance_rad > 0 && o.horizon_tolerance_rad <= 0.1)) {
        throw Error(MustBe("SliceOptions::horizon_tolerance_rad", o.horizon_tolerance_rad,
                           "in (0, 0.1]"));
    }
}

int SlicesAPiece(int slices, int pieces) {
    return std::max(std::min(slices, kFewestSlices), (slices + pieces - 1) / pieces);
}

Links LinksBySlices(const HeightField& field, const SliceOptions& options, Monitor& monitor) {
    return LinksBySlices(field, FacetPieces(field), options, monitor);
}

Links LinksBySlices(const HeightField& field, const FacetPieces& pieces,
                    const SliceOptions& options, Monitor& monitor) {
    Validate(options);
    const WalkGrid grid(field);
    return MakeLinks(
        pieces.Count(), [&] { return SliceRow(field, pieces, grid, options, monitor); },
        monitor);
}

}  // namespace plumb
