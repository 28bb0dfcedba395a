#include "screen_space/antialiasing/normal_metric.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/metric_rows.h"
#include "screen_space/antialiasing/windows.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 4;

// The largest 1 - |<n_mean, n>|, as it stands.
double PrintedGap(std::span<const Vec3f> normals, MeanNormal mean) {
    Vec3f sum(0, 0, 0);
    for (const Vec3f& n : normals) sum += n;
    Vec3f n_mean = sum / float(normals.size());
    if (mean == MeanNormal::kUnit && n_mean.norm() > 0) n_mean /= n_mean.norm();
    float least = 1;
    for (const Vec3f& n : normals) least = std::min(least, std::abs(n_mean.dot(n)));
    return 1 - least;
}

// In the order in which screen_space/antialiasing/metric_rows.cpp adds.
double Dot(const Vec3& a, const Vec3& b) {
    return a.x() * b.x() + a.y() * b.y() + a.z() * b.z();
}

double StableGap(std::span<const Vec3f> normals, MeanNormal mean) {
    Vec3 sum(0, 0, 0);
    for (const Vec3f& n : normals) sum += n.cast<double>();
    Vec3 n_mean = sum / double(normals.size());
    const double length = std::sqrt(Dot(n_mean, n_mean));
    if (!(length > 0)) return 1;
    if (mean == MeanNormal::kUnit) n_mean /= length;
    double most = 0;
    for (const Vec3f& of : normals) {
        const Vec3 n = of.cast<double>();
        if (n.isZero(0)) return 1;
        if (mean == MeanNormal::kUnit) {
            const Vec3 apart = n_mean - n, together = n_mean + n;
            most = std::max(most, std::min(Dot(apart, apart), Dot(together, together)) / 2);
        } else {
            const double less = Dot(n - n_mean, n);  // 1 - <n_mean, n>
            most = std::max(most, std::min(less, 2 - less));
        }
    }
    return most;
}

void PrintedRow(const NormalMetric& metric, const Image<Vec3f>& normals, int m, int y,
                Image<float>& k_n) {
    std::array<Vec3f, kMaxSamples> n;
    for (int x = 0; x < k_n.Width(); ++x) {
        ReadWindow(normals, m, x, y, n);
        k_n(x, y) = float(metric.c * NormalSpread({n.data(), std::size_t(m) * m}, metric.mean,
                                                  MetricForm::kPrinted));
    }
}

}  // namespace

void Validate(const NormalMetric& metric) {
    if (!(metric.c >= 0 && std::isfinite(metric.c))) {
        throw Error(MustBe("NormalMetric::c", metric.c, "finite and not negative"));
    }
}

double NormalSpread(std::span<const Vec3f> normals, MeanNormal mean, MetricForm form) {
    const bool sky_only =
        std::all_of(normals.begin(), normals.end(), [](const Vec3f& n) { return n.isZero(0); });
    if (sky_only) return 0;
    const double gap =
        form == MetricForm::kPrinted ? PrintedGap(normals, mean) : StableGap(normals, mean);
    return std::sqrt(std::clamp(gap, 0.0, 1.0));
}

// [Hollander13 eq. 2]
Image<float> NormalSamples(const Image<Vec3f>& normals, int m, const NormalMetric& metric) {
    Validate(metric);
    CheckWindows(m, normals.Width(), normals.Height(), "size of the enlarged normals");
    Image<float> k_n(normals.Width() / m, normals.Height() / m);
    ParallelFor(k_n.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        for (int y = int(begin); y < int(end) && k_n.Width() > 0; ++y) {
            if (metric.form == MetricForm::kStable) {
                NormalRow(metric, normals, m, y, &k_n(0, y));
            } else {
                PrintedRow(metric, normals, m, y, k_n);
            }
        }
    });
    return k_n;
}

}  // namespace plumb
