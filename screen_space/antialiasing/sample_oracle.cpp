#include "screen_space/antialiasing/sample_oracle.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/windows.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 8;
constexpr int kMost = 255;

/// f(k) and what one sample more brings, for one n.
class ErrorCurve {
  public:
    ErrorCurve(int n, SampleDraw draw) : n_(n) {
        for (int k = 1; k <= n; ++k) f_[std::size_t(k)] = Of(k, draw);
        for (int k = 1; k < n; ++k) {
            gain_[std::size_t(k)] = f_[std::size_t(k)] - f_[std::size_t(k + 1)];
        }
    }

    double F(int k) const { return f_[std::size_t(k)]; }
    /// f(k) - f(k + 1), falling in k; for k < n.
    double Gain(int k) const { return gain_[std::size_t(k)]; }

    /// Samples of a pixel all of whose gains are above `least`.
    int CountAbove(double v, double least) const {
        int low = 1, high = n_;  // Gain(low - 1) is above; Gain(high) is not.
        while (low < high) {
            const int k = (low + high) / 2;
            if (v * Gain(k) > least) {
                low = k + 1;
            } else {
                high = k;
            }
        }
        return low;
    }

  private:
    double Of(int k, SampleDraw draw) const {
        if (draw == SampleDraw::kIndependent) return 1.0 / k;
        return n_ == 1 ? 0 : double(n_ - k) / (double(n_ - 1) * k);
    }

    int n_;
    std::array<double, kMost + 1> f_{}, gain_{};
};

struct Totals {
    std::int64_t samples = 0;
    double squares = 0;  ///< Sum_p v_p f(k_p)
};

/// Sums by rows, then over rows: the same on any number of threads. count(x, y) gives k.
template <class CountOf>
Totals Sum(const Image<double>& v, const ErrorCurve& curve, const CountOf& count) {
    std::vector<Totals> rows(std::size_t(v.Height()));
    ParallelFor(v.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t y = begin; y < end; ++y) {
            Totals& row = rows[std::size_t(y)];
            for (int x = 0; x < v.Width(); ++x) {
                const int k = count(x, int(y));
                row.samples += k;
                row.squares += v(x, int(y)) * curve.F(k);
            }
        }
    });
    Totals all;
    for (const Totals& row : rows) {
        all.samples += row.samples;
        all.squares += row.squares;
    }
    return all;
}

double Mean(double sum, const Image<double>& v) {
    return v.Empty() ? 0 : sum / double(v.Pixels().size());
}

void CheckInput(const Image<double>& v, int n) {
    if (n < 1 || n > kMost) throw Error(MustBe("most samples of a pixel", n, "in [1, 255]"));
    for (const double of : v.Pixels()) {
        if (!(of >= 0 && std::isfinite(of))) {
            throw Error(MustBe("variance of a pixel", of, "finite and not negative"));
        }
    }
}

/// Gives samples in the order of their gains until enough(totals) holds.
template <class Enough>
Allocation Greedy(const Image<double>& v, int n, SampleDraw draw, const Enough& enough) {
    const ErrorCurve curve(n, draw);
    const auto above = [&](double least) {
        return Sum(v, curve, [&](int x, int y) { return curve.CountAbove(v(x, y), least); });
    };
    // Positive doubles are in the order of their bits: the border between enough and too few is
    // found to the last of them.
    std::uint64_t low = 0;  // Gains above it are all that there are.
    std::uint64_t high = std::bit_cast<std::uint64_t>(std::numeric_limits<double>::max());
    const bool one_is_enough = enough(above(std::bit_cast<double>(high)));
    while (!one_is_enough && high - low > 1) {
        const std::uint64_t middle = low + (high - low) / 2;
        (enough(above(std::bit_cast<double>(middle))) ? low : high) = middle;
    }
    const double last = std::bit_cast<double>(high);
    Allocation out{.counts = Image<std::uint8_t>(v.Width(), v.Height())};
    for (int y = 0; y < v.Height(); ++y) {
        for (int x = 0; x < v.Width(); ++x) {
            out.counts(x, y) = std::uint8_t(curve.CountAbove(v(x, y), last));
        }
    }
    Totals totals = above(last);
    for (std::size_t i = 0; i < v.Pixels().size() && !enough(totals); ++i) {
        std::uint8_t& k = out.counts.Pixels()[i];
        while (k < n && v.Pixels()[i] * curve.Gain(k) == last && !enough(totals)) {
            totals.squares -= v.Pixels()[i] * curve.Gain(k);
            ++totals.samples;
            ++k;
        }
    }
    out.reached = enough(totals);
    totals = Sum(v, curve, [&](int x, int y) { return int(out.counts(x, y)); });
    out.samples = totals.samples;
    out.mse = Mean(totals.squares, v);
    return out;
}

/// The number of samples everywhere, a real one, with this MSE.
double UniformSamples(double mean_v, double mse, int n, SampleDraw draw) {
    if (!(mean_v > 0)) return 1;
    const double f = mse / mean_v;
    const double k = draw == SampleDraw::kIndependent ? 1 / f : n / (1 + f * (n - 1));
    return std::clamp(k, 1.0, double(n));
}

}  // namespace

Image<double> WindowVariances(const Image<Rgb>& samples, int m) {
    CheckWindows(m, samples.Width(), samples.Height(), "size of the enlarged picture");
    Image<double> v(samples.Width() / m, samples.Height() / m);
    const int n = m * m;
    ParallelFor(v.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        std::array<Rgb, kMaxSamples> window;
        for (int y = int(begin); y < int(end); ++y) {
            for (int x = 0; x < v.Width(); ++x) {
                ReadWindow(samples, m, x, y, window);
                double sum = 0;
                for (std::size_t c = 0; c < 3; ++c) {
                    double mean = 0;
                    for (int i = 0; i < n; ++i) mean += window[std::size_t(i)][c];
                    mean /= n;
                    for (int i = 0; i < n; ++i) {
                        const double d = window[std::size_t(i)][c] - mean;
                        sum += d * d;
                    }
                }
                v(x, y) = sum / (3.0 * n);
            }
        }
    });
    return v;
}

double ExpectedMse(const Image<double>& v, const Image<std::uint8_t>& counts, int n,
                   SampleDraw draw) {
    CheckInput(v, n);
    if (counts.Width() != v.Width() || counts.Height() != v.Height()) {
        throw Error(MustBe("width of the counts", counts.Width(),
                           "that of the variances, " + std::to_string(v.Width()) +
                               ", and the height likewise"));
    }
    for (const std::uint8_t k : counts.Pixels()) {
        if (k < 1 || k > n) {
            throw Error(MustBe("samples of a pixel", k, "in [1, " + std::to_string(n) + "]"));
        }
    }
    const ErrorCurve curve(n, draw);
    return Mean(Sum(v, curve, [&](int x, int y) { return int(counts(x, y)); }).squares, v);
}

Allocation LeastSamples(const Image<double>& v, int n, double target_mse, SampleDraw draw) {
    CheckInput(v, n);
    if (!(target_mse >= 0)) throw Error(MustBe("target MSE", target_mse, "not negative"));
    return Greedy(v, n, draw,
                  [&](const Totals& totals) { return Mean(totals.squares, v) <= target_mse; });
}

Allocation LeastError(const Image<double>& v, int n, std::int64_t samples, SampleDraw draw) {
    CheckInput(v, n);
    const std::int64_t pixels = std::int64_t(v.Pixels().size());
    if (samples < pixels || samples > pixels * n) {
        throw Error(
            MustBe("samples to give", double(samples),
                   "in [" + std::to_string(pixels) + ", " + std::to_string(pixels * n) + "]"));
    }
    return Greedy(v, n, draw, [&](const Totals& totals) { return totals.samples >= samples; });
}

OracleShare ShareOfGain(const Image<double>& v, const Image<std::uint8_t>& counts, int n,
                        SampleDraw draw) {
    OracleShare out;
    out.mse = ExpectedMse(v, counts, n, draw);
    const double pixels = double(v.Pixels().size());
    double used = 0, sum_v = 0;
    for (const std::uint8_t k : counts.Pixels()) used += k;
    for (const double of : v.Pixels()) sum_v += of;
    out.used = used / pixels;
    out.oracle = double(LeastSamples(v, n, out.mse, draw).samples) / pixels;
    out.uniform = UniformSamples(Mean(sum_v, v), out.mse, n, draw);
    out.share = out.uniform > out.oracle ? (out.uniform - out.used) / (out.uniform - out.oracle)
                                         : std::numeric_limits<double>::quiet_NaN();
    return out;
}

}  // namespace plumb
