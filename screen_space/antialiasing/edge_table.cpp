#include "screen_space/antialiasing/edge_table.h"

#include <algorithm>
#include <cmath>

#include "core/conventions.h"
#include "core/error.h"
#include "core/parallel.h"

namespace plumb {
namespace {

/// Sums over the pixels of one angle.
struct Sums {
    std::int64_t pixels = 0;
    double squares = 0, errors = 0, largest = 0, samples = 0, values = 0, coverage = 0;

    void Add(double value, double exact, double of_samples) {
        const double error = value - exact;
        ++pixels;
        squares += error * error;
        errors += error;
        largest = std::max(largest, std::abs(error));
        samples += of_samples;
        values += value;
        coverage += exact;
    }

    void Add(const Sums& other) {
        pixels += other.pixels;
        squares += other.squares;
        errors += other.errors;
        largest = std::max(largest, other.largest);
        samples += other.samples;
        values += other.values;
        coverage += other.coverage;
    }
};

Sums OfAngle(const CoverageMethod& method, const EdgeTableOptions& options, double angle_rad,
             double width_px) {
    const int size = options.inner_px + 2 * method.margin_px;
    Sums sums;
    for (int k = 0; k < options.offsets; ++k) {
        const double offset = (k + 0.5) / options.offsets;
        Strip strip{.middle_px = {size / 2.0, size / 2.0}, .normal = UnitNormal(angle_rad)};
        strip.low_px = std::isinf(width_px) ? offset : offset - width_px / 2;
        strip.high_px = strip.low_px + width_px;
        const CoveragePicture picture = method.draw(strip, size);
        for (int y = method.margin_px; y < size - method.margin_px; ++y) {
            for (int x = method.margin_px; x < size - method.margin_px; ++x) {
                if (strip.EdgeDistance({x + 0.5, y + 0.5}) > options.band_px) continue;
                sums.Add(picture.value(x, y), strip.Coverage(x, y), picture.samples(x, y));
            }
        }
    }
    return sums;
}

double Ratio(double above, double below) {
    return below > 0 ? above / below : 0;
}

CoverageError ErrorOf(const CoverageMethod& method, const EdgeTableOptions& options,
                      double width_px) {
    Validate(options);
    std::vector<Sums> by_angle(std::size_t(options.angles));
    ParallelFor(options.angles, 1, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t a = begin; a < end; ++a) {
            const double angle_rad = 2 * kPi * double(a) / options.angles;
            by_angle[std::size_t(a)] = OfAngle(method, options, angle_rad, width_px);
        }
    });
    Sums all;
    CoverageError out;
    for (const Sums& sums : by_angle) {
        all.Add(sums);
        out.rms_by_angle.push_back(std::sqrt(Ratio(sums.squares, double(sums.pixels))));
    }
    const double n = double(all.pixels);
    out.pixels = all.pixels;
    out.rms = std::sqrt(Ratio(all.squares, n));
    out.bias = Ratio(all.errors, n);
    out.largest = all.largest;
    out.samples = Ratio(all.samples, n);
    out.kept = Ratio(all.values, all.coverage);
    return out;
}

}  // namespace

void Validate(const EdgeTableOptions& options) {
    if (options.angles < 1 || options.angles > 3600) {
        throw Error(MustBe("EdgeTableOptions::angles", options.angles, "in [1, 3600]"));
    }
    if (options.offsets < 1 || options.offsets > 1024) {
        throw Error(MustBe("EdgeTableOptions::offsets", options.offsets, "in [1, 1024]"));
    }
    if (options.inner_px < 4 || options.inner_px > 256) {
        throw Error(MustBe("EdgeTableOptions::inner_px", options.inner_px, "in [4, 256]"));
    }
    if (!(options.band_px > 0 && options.band_px <= 64)) {
        throw Error(MustBe("EdgeTableOptions::band_px", options.band_px, "in (0, 64]"));
    }
}

CoverageError EdgeError(const CoverageMethod& method, const EdgeTableOptions& options) {
    return ErrorOf(method, options, std::numeric_limits<double>::infinity());
}

CoverageError BarError(const CoverageMethod& method, double width_px,
                       const EdgeTableOptions& options) {
    if (!(width_px > 0 && width_px <= 64)) {
        throw Error(MustBe("width of a bar in pixels", width_px, "in (0, 64]"));
    }
    return ErrorOf(method, options, width_px);
}

std::vector<double> BarWidthsPx() {
    std::vector<double> widths;
    for (int tenths = 1; tenths <= 20; ++tenths) widths.push_back(tenths / 10.0);
    return widths;
}

std::vector<EdgeRow> EdgeTable(std::span<const CoverageMethod> methods,
                               std::span<const double> bar_widths_px,
                               const EdgeTableOptions& options) {
    std::vector<EdgeRow> rows;
    for (const CoverageMethod& method : methods) {
        EdgeRow row{.method = method.name, .edge = EdgeError(method, options), .bars = {}};
        for (const double width_px : bar_widths_px) {
            row.bars.push_back(BarError(method, width_px, options));
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace plumb
