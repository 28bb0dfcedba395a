#include "screen_space/antialiasing/smaa_weights.h"

#include "core/parallel.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 8;

/// The edges as a run along rows sees them: along, across; columns are transposed.
class Turned {
  public:
    Turned(const SmaaEdges& edges, SmaaAxis axis)
        : edges_(edges), rows_(axis == SmaaAxis::kAlongRows) {}

    /// Of the run itself.
    bool Line(int along, int across) const {
        return rows_ ? edges_.Top(along, across) : edges_.Left(across, along);
    }
    bool Cross(int along, int across) const {
        return rows_ ? edges_.Left(along, across) : edges_.Top(across, along);
    }
    /// A crossing edge on either side of the line.
    bool Crossed(int along, int across) const {
        return Cross(along, across) || Cross(along, across - 1);
    }

  private:
    const SmaaEdges& edges_;
    bool rows_;
};

SmaaShares AreaOf(const SmaaRun& run, SmaaAreaSource source) {
    if (source == SmaaAreaSource::kTable) {
        return TabledOrthogonalArea(run.code_before, run.code_after, run.before, run.after);
    }
    return OrthogonalArea(OrthogonalPattern(run.code_before, run.code_after), run.before,
                          run.after);
}

SmaaShares RunShares(const SmaaEdges& edges, SmaaAxis axis, int x, int y,
                     const SmaaOptions& options) {
    const SmaaRun run = FindSmaaRun(edges, axis, x, y, options.search_steps);
    SmaaShares shares = AreaOf(run, options.areas);
    if (options.corner_rounding == 100) return shares;
    const Turned turned(edges, axis);
    const int along = axis == SmaaAxis::kAlongRows ? x : y,
              across = axis == SmaaAxis::kAlongRows ? y : x;
    const int before = along - run.before, after = along + run.after + 1;
    const bool equal = run.before == run.after;
    const double less = (1 - options.corner_rounding / 100) / (equal ? 2 : 1);
    for (std::size_t k = 0; k < 2; ++k) {
        const int row = k == 0 ? across + 1 : across - 2;
        double factor = 1;
        if (run.before <= run.after && turned.Cross(before, row)) factor -= less;
        if (run.after <= run.before && turned.Cross(after, row)) factor -= less;
        shares[k] *= std::clamp(factor, 0.0, 1.0);
    }
    return shares;
}

/// What of a stair's two edges a pixel has.
using HasStair = bool (*)(const SmaaEdges&, int x, int y);

bool RisingStair(const SmaaEdges& edges, int x, int y) {
    return edges.Top(x, y) && edges.Left(x, y);
}

bool FallingStair(const SmaaEdges& edges, int x, int y) {
    return edges.Top(x, y) && edges.Left(x + 1, y);
}

struct Stairs {
    int count = 0;      ///< Beyond the pixel itself.
    bool ended = true;  ///< By an edge that is missing; not by the limit.
};

/// `more`: one stair more if the pixel looked at last has a top edge, as half a stair.
Stairs Walk(const SmaaEdges& edges, HasStair has, int x, int y, int dx, int dy, int steps,
            bool more) {
    Stairs stairs{-1, false};
    while (stairs.count < steps - 1 && !stairs.ended) {
        x += dx;
        y += dy;
        ++stairs.count;
        stairs.ended = !has(edges, x, y);
    }
    if (more && edges.Top(x, y)) ++stairs.count;
    return stairs;
}

/// Of the edges that cross at an end, unless the walk never came there.
int CodeOf(const Stairs& stairs, bool u, bool v) {
    return stairs.ended ? 2 * u + v : 0;
}

SmaaShares AreaOf(const Stairs& a, const Stairs& b, int code_a, int code_b,
                  SmaaAreaSource source) {
    return source == SmaaAreaSource::kTable
               ? TabledDiagonalArea(code_a, code_b, a.count, b.count)
               : DiagonalArea(DiagonalPattern(code_a, code_b), a.count, b.count);
}

/// Of stairs that rise to the right: down left and up right from the pixel.
SmaaShares RisingShares(const SmaaEdges& edges, int x, int y, const SmaaOptions& options) {
    const int steps = options.diagonal_steps;
    const Stairs a =
        edges.Left(x, y) ? Walk(edges, RisingStair, x, y, -1, 1, steps, true) : Stairs{};
    const Stairs b = Walk(edges, RisingStair, x, y, 1, -1, steps, false);
    if (a.count + b.count <= 2) return {0, 0};
    const int xa = x - a.count, ya = y + a.count, xb = x + b.count, yb = y - b.count;
    return AreaOf(a, b, CodeOf(a, edges.Top(xa - 1, ya), edges.Left(xa, ya)),
                  CodeOf(b, edges.Top(xb + 1, yb), edges.Left(xb + 1, yb - 1)), options.areas);
}

/// Of stairs that fall to the right: up left and down right.
SmaaShares FallingShares(const SmaaEdges& edges, int x, int y, const SmaaOptions& options) {
    const int steps = options.diagonal_steps;
    const Stairs a = Walk(edges, FallingStair, x, y, -1, -1, steps, false);
    const Stairs b =
        edges.Left(x + 1, y) ? Walk(edges, FallingStair, x, y, 1, 1, steps, true) : Stairs{};
    if (a.count + b.count <= 2) return {0, 0};
    const int xa = x - a.count, ya = y - a.count, xb = x + b.count, yb = y + b.count;
    return AreaOf(a, b, CodeOf(a, edges.Top(xa - 1, ya), edges.Left(xa, ya - 1)),
                  CodeOf(b, edges.Top(xb + 1, yb), edges.Left(xb + 1, yb)), options.areas);
}

SmaaWeights WeightsOf(const SmaaEdges& edges, int x, int y, const SmaaOptions& options) {
    SmaaShares top{0, 0}, left{0, 0};
    const std::uint8_t bits = edges.Bits(x, y);
    bool diagonal = false;
    if (bits & SmaaEdges::kTop) {
        if (options.diagonal_steps > 0) top = DiagonalShares(edges, x, y, options);
        diagonal = top[0] + top[1] > 0;
        if (!diagonal) top = RunShares(edges, SmaaAxis::kAlongRows, x, y, options);
    }
    if ((bits & SmaaEdges::kLeft) && !diagonal) {
        left = RunShares(edges, SmaaAxis::kAlongColumns, x, y, options);
    }
    return {float(top[0]), float(top[1]), float(left[0]), float(left[1])};
}

}  // namespace

SmaaRun FindSmaaRun(const SmaaEdges& edges, SmaaAxis axis, int x, int y, int search_steps) {
    const Turned turned(edges, axis);
    const int along = axis == SmaaAxis::kAlongRows ? x : y,
              across = axis == SmaaAxis::kAlongRows ? y : x;
    int first = along, last = along;
    while (along - first < 2 * search_steps - 1 && !turned.Crossed(first, across) &&
           turned.Line(first - 1, across)) {
        --first;
    }
    while (last - along < 2 * search_steps && turned.Line(last + 1, across) &&
           !turned.Crossed(last + 1, across)) {
        ++last;
    }
    const auto code = [&](int end) {
        return 3 * turned.Cross(end, across) + turned.Cross(end, across - 1);
    };
    return {along - first, last - along, code(first), code(last + 1)};
}

SmaaShares DiagonalShares(const SmaaEdges& edges, int x, int y, const SmaaOptions& options) {
    const SmaaShares rising = RisingShares(edges, x, y, options);
    const SmaaShares falling = FallingShares(edges, x, y, options);
    return {rising[0] + falling[1], rising[1] + falling[0]};
}

Image<SmaaWeights> FindSmaaWeights(const SmaaEdges& edges, const SmaaOptions& options) {
    Image<SmaaWeights> weights(edges.Width(), edges.Height(), SmaaWeights{});
    ParallelFor(edges.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end); ++y) {
            for (int x = 0; x < edges.Width(); ++x) {
                if (edges.Bits(x, y)) weights(x, y) = WeightsOf(edges, x, y, options);
            }
        }
    });
    return weights;
}

}  // namespace plumb
