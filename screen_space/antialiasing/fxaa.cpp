#include "screen_space/antialiasing/fxaa.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/luma.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 8;

float LumaOf(FxaaLuma kind, const Rgb& colour) {
    switch (kind) {
        case FxaaLuma::kRec601:
            return Luma(LumaWeights::kRec601, colour);
        case FxaaLuma::kRootOfLinear:
            return std::sqrt(std::max(0.f, Luma(LumaWeights::kRec601, colour)));
        case FxaaLuma::kGreen:
            return colour[1];
    }
    return 0;
}

/// With a border of one pixel, which repeats the outermost ones.
Image<float> PaddedLuma(const Image<Rgb>& picture, FxaaLuma kind) {
    const int W = picture.Width(), H = picture.Height();
    Image<float> luma(W + 2, H + 2);
    ParallelFor(H + 2, kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int j = int(begin); j < int(end); ++j) {
            const int y = std::clamp(j - 1, 0, H - 1);
            for (int x = 0; x < W; ++x) luma(x + 1, j) = LumaOf(kind, picture(x, y));
            luma(0, j) = luma(1, j);
            luma(W + 1, j) = luma(W, j);
        }
    });
    return luma;
}

/// The line between two rows (of a horizontal span) or two columns, seen from one pixel.
class EdgeLine {
  public:
    EdgeLine(const Image<float>& padded, bool horizontal, int x, int y, int side)
        : luma_(padded),
          horizontal_(horizontal),
          along_(horizontal ? x : y),
          here_(horizontal ? y : x),
          there_(here_ + side),
          last_((horizontal ? padded.Width() : padded.Height()) - 1) {}

    /// Luma at `steps_px` along the line from the pixel.
    float At(double steps_px) const {
        const double whole = std::floor(steps_px);
        const float share = float(steps_px - whole);
        const float a = Between(along_ + int(whole));
        return share == 0 ? a : a + (Between(along_ + int(whole) + 1) - a) * share;
    }

  private:
    float Between(int i) const {
        i = std::clamp(i, 0, last_);
        return horizontal_ ? (luma_(i, here_) + luma_(i, there_)) / 2
                           : (luma_(here_, i) + luma_(there_, i)) / 2;
    }

    const Image<float>& luma_;
    bool horizontal_;
    int along_, here_, there_, last_;
};

struct LineEnd {
    double distance_px;
    float off;  ///< Luma there less that of the edge.
};

LineEnd FindEnd(const EdgeLine& line, int direction, float edge, float stop,
                const std::vector<double>& steps_px) {
    LineEnd end{0, 0};
    for (std::size_t i = 0; i < steps_px.size(); ++i) {
        end.distance_px += steps_px[i];
        if (i + 1 == steps_px.size()) break;
        end.off = line.At(direction * end.distance_px) - edge;
        if (std::abs(end.off) >= stop) break;
    }
    return end;
}

class Filter {
  public:
    Filter(const Image<Rgb>& picture, const FxaaOptions& options)
        : picture_(picture), options_(options), luma_(PaddedLuma(picture, options.luma)) {}

    void Row(int y, Image<Rgb>& out) const {
        const int W = picture_.Width();
        const float t = float(options_.edge_threshold),
                    t_min = float(options_.edge_threshold_min);
        const float *n = &luma_(1, y), *m = &luma_(1, y + 1), *s = &luma_(1, y + 2);
        for (int x = 0; x < W; ++x) {
            const float high =
                std::max(std::max(std::max(n[x], s[x]), std::max(m[x - 1], m[x + 1])), m[x]);
            const float low =
                std::min(std::min(std::min(n[x], s[x]), std::min(m[x - 1], m[x + 1])), m[x]);
            const float range = high - low;
            const bool flat = !(range > 0) || range < std::max(t_min, high * t);
            out(x, y) = flat ? picture_(x, y) : Pixel(x, y, range);
        }
    }

  private:
    Rgb Pixel(int x, int y, float range) const {
        // (x, y) of the luma's border is (0, 0).
        const int i = x + 1, j = y + 1;
        const float M = luma_(i, j), N = luma_(i, j - 1), S = luma_(i, j + 1),
                    W = luma_(i - 1, j), E = luma_(i + 1, j);
        const float NW = luma_(i - 1, j - 1), NE = luma_(i + 1, j - 1),
                    SW = luma_(i - 1, j + 1), SE = luma_(i + 1, j + 1);
        const float across_rows =
            std::abs(NW + SW - 2 * W) + 2 * std::abs(N + S - 2 * M) + std::abs(NE + SE - 2 * E);
        const float across_columns =
            std::abs(NW + NE - 2 * N) + 2 * std::abs(W + E - 2 * M) + std::abs(SW + SE - 2 * S);
        const bool horizontal = across_rows >= across_columns;
        const float first = horizontal ? N : W, second = horizontal ? S : E;
        const float first_step = std::abs(first - M), second_step = std::abs(second - M);
        const int side = first_step >= second_step ? -1 : 1;
        const float stop = std::max(first_step, second_step) / 4;
        const float edge = (M + (side < 0 ? first : second)) / 2;

        const EdgeLine line(luma_, horizontal, i, j, side);
        const LineEnd minus = FindEnd(line, -1, edge, stop, options_.steps_px);
        const LineEnd plus = FindEnd(line, 1, edge, stop, options_.steps_px);
        const LineEnd& near = minus.distance_px < plus.distance_px ? minus : plus;
        const bool good = (near.off < 0) != (M - edge < 0);
        const double offset =
            good ? 0.5 - near.distance_px / (minus.distance_px + plus.distance_px) : 0;

        const float B = (2 * (N + S + W + E) + (NW + NE + SW + SE)) / 12 - M;
        const float C = std::min(1.f, std::abs(B) / range);
        const float F = C * C * (3 - 2 * C);
        const double H = double(F) * F * options_.subpix;
        return Moved(x, y, horizontal, side, float(std::max(offset, H)));
    }

    /// The picture at (x, y) moved by `share` of a pixel.
    Rgb Moved(int x, int y, bool horizontal, int side, float share) const {
        const int x2 = horizontal ? x : std::clamp(x + side, 0, picture_.Width() - 1);
        const int y2 = horizontal ? std::clamp(y + side, 0, picture_.Height() - 1) : y;
        const Rgb &a = picture_(x, y), &b = picture_(x2, y2);
        Rgb out;
        for (std::size_t c = 0; c < 3; ++c) out[c] = a[c] + (b[c] - a[c]) * share;
        return out;
    }

    const Image<Rgb>& picture_;
    const FxaaOptions& options_;
    Image<float> luma_;
};

}  // namespace

void Validate(const FxaaOptions& options) {
    if (!(options.subpix >= 0 && options.subpix <= 1)) {
        throw Error(MustBe("FxaaOptions::subpix", options.subpix, "in [0, 1]"));
    }
    for (const auto& [name, value] :
         {std::pair{"edge_threshold", options.edge_threshold},
          std::pair{"edge_threshold_min", options.edge_threshold_min}}) {
        if (!(value >= 0 && std::isfinite(value))) {
            throw Error(
                MustBe(std::string("FxaaOptions::") + name, value, "finite and not negative"));
        }
    }
    if (options.steps_px.size() < 2) {
        throw Error(MustBe("FxaaOptions::steps_px.size()", double(options.steps_px.size()),
                           "at least 2"));
    }
    for (const double step : options.steps_px) {
        if (!(step > 0 && step <= 1024)) {
            throw Error(MustBe("FxaaOptions::steps_px", step, "in (0, 1024]"));
        }
    }
}

Image<Rgb> FxaaFiltered(const Image<Rgb>& picture, const FxaaOptions& options) {
    Validate(options);
    if (picture.Empty()) return picture;
    const Filter filter(picture, options);
    Image<Rgb> out(picture.Width(), picture.Height());
    ParallelFor(picture.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end); ++y) filter.Row(y, out);
    });
    return out;
}

}  // namespace plumb
