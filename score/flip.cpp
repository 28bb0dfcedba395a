#include "score/flip.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "score/flip_colour.h"
#include "score/flip_filters.h"
#include "score/pixels.h"

namespace plumb {
namespace {

/// to[i] = Sum_k w_k from[i + k step] for i in [0, n): along a line of pixels, or across lines. Wider
/// registers where there are some: the same sums, the same bits.
[[gnu::target_clones("avx2", "default")]] void Filter(const LineFilter& filter,
                                                      const double* from, std::ptrdiff_t step,
                                                      int n, double* to) {
    constexpr int kBlock = 8;  // Sums that a loop keeps in registers.
    const int reach = filter.Reach();
    const double* w = filter.w.data();
    const double sign = filter.odd ? -1 : 1;
    int i = 0;
    for (; i + kBlock <= n; i += kBlock) {
        double sum[kBlock];
        for (int l = 0; l < kBlock; ++l) sum[l] = w[0] * from[i + l];
        for (int k = 1; k <= reach; ++k) {
            const double* after = from + i + k * step;
            const double* before = from + i - k * step;
            for (int l = 0; l < kBlock; ++l) sum[l] += w[k] * (after[l] + sign * before[l]);
        }
        for (int l = 0; l < kBlock; ++l) to[i + l] = sum[l];
    }
    for (; i < n; ++i) {
        double sum = w[0] * from[i];
        for (int k = 1; k <= reach; ++k) {
            sum += w[k] * (from[i + k * step] + sign * from[i - k * step]);
        }
        to[i] = sum;
    }
}

/// A row of pixels as numbers beside each other, with the border's pixels beyond both ends.
struct OpponentRow {
    OpponentRow(int width, int margin_px)
        : margin(margin_px), Y(width + 2 * margin_px), Cx(Y.size()), Cz(Y.size()) {}

    void Read(const Image<Rgb>& picture, int j) {
        const int width = picture.Width();
        for (int i = 0; i < width; ++i) {
            const Rgb& pixel = picture(i, j);
            Triple rgb;
            for (std::size_t c = 0; c < 3; ++c) rgb[c] = std::clamp(double(pixel[c]), 0.0, 1.0);
            const Triple ycc = YCxCzOfRgb(rgb);
            Y[margin + i] = ycc[0];
            Cx[margin + i] = ycc[1];
            Cz[margin + i] = ycc[2];
        }
        for (std::vector<double>* line : {&Y, &Cx, &Cz}) {
            std::fill_n(line->begin(), margin, (*line)[margin]);
            std::fill_n(line->end() - margin, margin, (*line)[margin + width - 1]);
        }
    }

    int margin;
    std::vector<double> Y, Cx, Cz;
};

/// What a row of the filtered picture is compared by.
struct SeenRow {
    explicit SeenRow(int width) : lab(width), edge(width), point(width) {}

    std::vector<Triple> lab;
    std::vector<double> edge, point;
};

/// Rows of one picture, filtered along the rows; then, row by row, across them.
class FilteredRows {
  public:
    FilteredRows(const FlipFilters& filters, const Image<Rgb>& picture, int first, int end)
        : filters_(filters),
          width_(picture.Width()),
          stride_(picture.Width() + kPad),
          first_(first - filters.reach_px) {
        const int rows = end - first + 2 * filters.reach_px, reach = filters.reach_px;
        for (std::vector<double>& plane : planes_) plane.resize(std::size_t(rows) * stride_);
        OpponentRow row(width_, reach);
        for (int r = 0; r < rows; ++r) {
            row.Read(picture, std::clamp(first_ + r, 0, picture.Height() - 1));
            const auto along = [&](const LineFilter& filter, const std::vector<double>& from,
                                   int plane) {
                Filter(filter, &from[reach], 1, width_, Row(plane, r));
            };
            along(filters.Y, row.Y, kY);
            along(filters.Cx, row.Cx, kCx);
            along(filters.Cz_wide, row.Cz, kCzWide);
            along(filters.Cz_narrow, row.Cz, kCzNarrow);
            for (double& Y : row.Y) Y = (Y + 16) / 116;
            along(filters.G, row.Y, kG);
            along(filters.edge, row.Y, kEdge);
            along(filters.point, row.Y, kPoint);
        }
        lines_.resize(8, std::vector<double>(width_));
    }

    void See(int j, SeenRow& seen) {
        const int r = j - first_;
        const auto across = [&](const LineFilter& filter, int plane, int line) {
            Filter(filter, Row(plane, r), stride_, width_, lines_[line].data());
        };
        across(filters_.Y, kY, 0);
        across(filters_.Cx, kCx, 1);
        across(filters_.Cz_wide, kCzWide, 2);
        across(filters_.Cz_narrow, kCzNarrow, 3);
        across(filters_.G, kEdge, 4);
        across(filters_.edge, kG, 5);
        across(filters_.G, kPoint, 6);
        across(filters_.point, kG, 7);
        for (int i = 0; i < width_; ++i) {
            Triple rgb = RgbOfYCxCz({lines_[0][i], lines_[1][i], lines_[2][i] + lines_[3][i]});
            for (double& c : rgb) c = std::clamp(c, 0.0, 1.0);
            seen.lab[i] = HuntLabOfRgb(rgb);
            const auto length = [&](int x, int y) {
                return std::sqrt(lines_[x][i] * lines_[x][i] + lines_[y][i] * lines_[y][i]);
            };
            seen.edge[i] = length(4, 5);
            seen.point[i] = length(6, 7);
        }
    }

  private:
    /// Numbers behind a row, so that rows of 1024 pixels do not all fall into one set of the cache.
    static constexpr int kPad = 8;

    enum { kY, kCx, kCzWide, kCzNarrow, kG, kEdge, kPoint, kPlanes };

    double* Row(int plane, int r) { return &planes_[plane][std::size_t(r) * stride_]; }

    const FlipFilters& filters_;
    int width_, stride_, first_;
    std::vector<double> planes_[kPlanes];
    std::vector<std::vector<double>> lines_;
};

void Check(const Image<Rgb>& candidate, const Image<Rgb>& reference) {
    if (reference.Empty()) throw Error(MustBe("reference: pixels", 0, ">= 1"));
    if (candidate.Width() != reference.Width())
        throw Error(MustBe("candidate: width", candidate.Width(),
                           "that of the reference, " + std::to_string(reference.Width())));
    if (candidate.Height() != reference.Height())
        throw Error(MustBe("candidate: height", candidate.Height(),
                           "that of the reference, " + std::to_string(reference.Height())));
    for (const Image<Rgb>* picture : {&candidate, &reference}) {
        for (std::size_t p = 0; p < picture->Pixels().size(); ++p) {
            for (float value : picture->Pixels()[p]) {
                if (std::isfinite(value)) continue;
                const auto width = std::size_t(picture->Width());
                throw Error(MustBe(
                    std::string(picture == &candidate ? "candidate" : "reference") + "[" +
                        std::to_string(p % width) + ", " + std::to_string(p / width) + "]",
                    value, "finite"));
            }
        }
    }
}

}  // namespace

Image<float> FlipMap(const Image<Rgb>& candidate, const Image<Rgb>& reference,
                     const FlipOptions& options) {
    Check(candidate, reference);
    const FlipFilters filters = MakeFlipFilters(options.pixels_per_degree);
    const double d_max = GreatestColourDifference();
    const int width = reference.Width(), height = reference.Height();
    Image<float> map(width, height);
    constexpr std::int64_t kRows = 64;
    ParallelFor(height, kRows, [&](std::int64_t begin, std::int64_t end) {
        FilteredRows c(filters, candidate, int(begin), int(end));
        FilteredRows t(filters, reference, int(begin), int(end));
        SeenRow seen_c(width), seen_t(width);
        for (int j = int(begin); j < int(end); ++j) {
            c.See(j, seen_c);
            t.See(j, seen_t);
            for (int i = 0; i < width; ++i) {
                const double E = ColourError(seen_c.lab[i], seen_t.lab[i], d_max);
                const double feature = std::max(std::abs(seen_c.edge[i] - seen_t.edge[i]),
                                                std::abs(seen_c.point[i] - seen_t.point[i]));
                const double f = std::sqrt(feature * (std::numbers::sqrt2 / 2));
                map(i, j) = float(std::pow(E, 1 - f));
            }
        }
    });
    return map;
}

Measured MeanOverTiles(const Image<float>& map, const Mask& mask, const ErrorOptions& options) {
    Validate(options);
    CheckSizes(map, map, {}, mask);
    const Tiling tiling(map.Width(), map.Height(), options.tile_px);
    std::vector<double> y(tiling.Count(), 0);
    std::vector<std::int64_t> n(tiling.Count(), 0);
    ForEachCounted(tiling, {}, mask, [&](int tile, int i, int j, double) {
        y[tile] += FinitePixel(map, i, j, "map");
        ++n[tile];
    });
    return RatioOverTiles(tiling, y, n, options.confidence);
}

}  // namespace plumb
