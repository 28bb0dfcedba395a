#include "formfactor/bounces.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

constexpr std::int64_t kChunk = 4096;

// What the totals need besides E_k: the light under way now and before, and the partial sums.
struct Tail {
    std::vector<double> under_way, under_way_before;
    std::vector<std::vector<double>> partial;  // Sum_{m<=k} rho^m E_m for each albedo.
};

double Closure(double rho_power, double rho, double R, double R_before) {
    if (R <= 0) return 0;
    const double q = R_before > 0 ? std::clamp(R / R_before, 0.0, 1.0) : 1.0;
    if (q == 1)
        return rho < 1 ? 0 : rho_power * R;  // Nothing moves: bounds 0 and R; R at rho = 1.
    return rho_power * R * (1 - q) / (1 - rho * q);
}

}  // namespace

void ForEachBounce(const Links& links, int bounces,
                   const std::function<void(int k, std::span<const double> E_k)>& visit,
                   Monitor& monitor) {
    if (bounces < 0) throw Error(MustBe("bounces", bounces, ">= 0"));
    std::vector<double> E = links.V;
    for (int k = 0;; ++k) {
        visit(k, E);
        if (k == bounces) return;
        E = Gather(links, E, monitor);
        monitor.Progress("bounces", (k + 1.0) / bounces);
    }
}

void Validate(const SeriesOptions& o) {
    if (o.bounces < 0 || o.bounces > 1000) {
        throw Error(MustBe("SeriesOptions::bounces", o.bounces, "in [0, 1000]"));
    }
    for (const double rho : o.albedos) {
        if (!(rho >= 0 && rho <= 1)) {
            throw Error(MustBe("SeriesOptions::albedos", rho, "in [0, 1]"));
        }
    }
    if (!(o.tolerance > 0 && o.tolerance < 1)) {
        throw Error(MustBe("SeriesOptions::tolerance", o.tolerance, "in (0, 1)"));
    }
    if (o.max_bounces < 1 || o.max_bounces > 100000) {
        throw Error(MustBe("SeriesOptions::max_bounces", o.max_bounces, "in [1, 100000]"));
    }
}

namespace {

// Means over facets of what holds for the rows of links; the same where rows are facets.
using ToFacets = std::function<std::vector<double>(std::span<const double>)>;

Series RunSeriesOver(std::size_t n, const Links& links, const ToFacets& to_facets,
                     const SeriesOptions& options,
                     const std::function<void(int k, std::span<const double> E_k)>& visit,
                     Monitor& monitor) {
    Validate(options);
    const std::size_t albedos = options.albedos.size();
    Series out;
    out.total.assign(albedos, std::vector<float>(n));
    Tail tail{std::vector<double>(n, 1), std::vector<double>(n, 1),
              std::vector<std::vector<double>>(albedos, std::vector<double>(n))};
    std::vector<double> of_rows = links.V;
    std::vector<double> moved(n);
    for (int k = 0;; ++k) {
        const std::vector<double> E = to_facets(of_rows);
        if (k <= options.bounces) visit(k, E);
        ParallelFor(std::int64_t(n), kChunk, [&](std::int64_t begin, std::int64_t end) {
            for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i) {
                tail.under_way_before[i] = tail.under_way[i];
                tail.under_way[i] -= E[i];
                moved[i] = 0;
            }
            for (std::size_t r = 0; r < albedos; ++r) {
                const double rho = options.albedos[r], power = std::pow(rho, k);
                for (std::size_t i = std::size_t(begin); i < std::size_t(end); ++i) {
                    double& partial = tail.partial[r][i];
                    partial += power * E[i];
                    const double rest =
                        Closure(power * rho, rho, tail.under_way[i], tail.under_way_before[i]);
                    const float total = float(partial + rest);
                    moved[i] = std::max(moved[i], std::abs(double(total) - out.total[r][i]));
                    out.total[r][i] = total;
                }
            }
        });
        out.bounces_run = k;
        out.last_move = albedos == 0 ? 0 : *std::max_element(moved.begin(), moved.end());
        out.settled = k >= 2 && out.last_move <= options.tolerance;
        if (k >= options.bounces && (out.settled || k >= options.max_bounces)) break;
        if (k >= options.bounces && albedos == 0) break;
        of_rows = Gather(links, of_rows, monitor);
        monitor.Progress("bounces", std::min(1.0, (k + 1.0) / options.bounces));
    }
    out.largest_under_way = *std::max_element(tail.under_way.begin(), tail.under_way.end());
    return out;
}

}  // namespace

Series RunSeries(const Links& links, const SeriesOptions& options,
                 const std::function<void(int k, std::span<const double> E_k)>& visit,
                 Monitor& monitor) {
    return RunSeriesOver(
        links.V.size(), links,
        [](std::span<const double> x) { return std::vector<double>(x.begin(), x.end()); },
        options, visit, monitor);
}

Series RunSeries(const Links& links, const FacetPieces& pieces, const SeriesOptions& options,
                 const std::function<void(int k, std::span<const double> E_k)>& visit,
                 Monitor& monitor) {
    return RunSeriesOver(
        std::size_t(pieces.Facets()), links,
        [&](std::span<const double> x) { return pieces.FacetMeans(x); }, options, visit,
        monitor);
}

}  // namespace plumb
