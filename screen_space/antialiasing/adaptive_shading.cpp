#include "screen_space/antialiasing/adaptive_shading.h"

#include <array>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"
#include "screen_space/antialiasing/index_matrix.h"
#include "screen_space/antialiasing/windows.h"

namespace plumb {
namespace {

constexpr std::int64_t kRowsAtATime = 4, kPixelsAtATime = 1024;

using Pixel = std::array<int, 2>;

/// Samples that wait to be shaded, and what becomes of them; one a thread's chunk.
struct Batch {
    std::vector<SampleToShade> samples;
    std::vector<Rgb> colours;

    void Shade(const SampleShader& shader) {
        colours.resize(samples.size());
        if (!samples.empty()) shader(samples, colours);
    }
};

/// Which samples of a pixel are still to be shaded.
enum class Rest { kAfterFirst, kAllOfMany, kAll };

class Resolver {
  public:
    Resolver(int m, Rest rest, const SampleShader& shader)
        : m_(m), rest_(rest), order_(SampleOrder(m)), shader_(shader) {}

    void Add(int x, int y, int from, int to, int of_pixel, Batch& batch) const {
        for (int k = from; k < to; ++k) {
            const SamplePlace& at = order_[std::size_t(k)];
            batch.samples.push_back({x * m_ + at.i, y * m_ + at.j, of_pixel});
        }
    }

    /// The pixels listed: each the mean of its samples, S among them where that is known.
    void ShadeRestOf(std::span<const Pixel> pixels, const Image<Rgb>& first,
                     const Image<std::uint8_t>& counts, Image<Rgb>& out, Batch& batch) const {
        batch.samples.clear();
        for (const auto& [x, y] : pixels) {
            const int count = counts(x, y);
            Add(x, y, FirstOfRest(count), count, count, batch);
        }
        batch.Shade(shader_);
        std::size_t next = 0;
        for (const auto& [x, y] : pixels) {
            const int count = counts(x, y);
            const int from = FirstOfRest(count);
            std::array<double, 3> sum{};
            if (from == 1) sum = {first(x, y)[0], first(x, y)[1], first(x, y)[2]};
            for (int k = from; k < count; ++k, ++next) {
                for (std::size_t c = 0; c < 3; ++c) sum[c] += batch.colours[next][c];
            }
            for (std::size_t c = 0; c < 3; ++c) out(x, y)[c] = float(sum[c] / count);
        }
    }

  private:
    int FirstOfRest(int count) const {
        return rest_ == Rest::kAll || (rest_ == Rest::kAllOfMany && count > 1) ? 0 : 1;
    }

    int m_;
    Rest rest_;
    std::vector<SamplePlace> order_;
    const SampleShader& shader_;
};

void CheckCounts(const Image<Rgb>& first, const Image<std::uint8_t>& counts, int m) {
    CheckEnlargement(m);
    if (first.Width() != counts.Width() || first.Height() != counts.Height()) {
        throw Error(MustBe("ShadeRest: width of the counts", counts.Width(),
                           "that of the first samples, " + std::to_string(first.Width()) +
                               ", and the height likewise"));
    }
    for (const std::uint8_t count : counts.Pixels()) {
        if (count < 1 || count > m * m) {
            throw Error(MustBe("ShadeRest: samples of a pixel", count,
                               "in [1, " + std::to_string(m * m) + "]"));
        }
    }
}

Image<Rgb> InOneLoop(const Resolver& resolver, const Image<Rgb>& first,
                     const Image<std::uint8_t>& counts) {
    Image<Rgb> out(counts.Width(), counts.Height());
    ParallelFor(counts.Height(), kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        Batch batch;
        std::vector<Pixel> row(std::size_t(counts.Width()));
        for (int y = int(begin); y < int(end); ++y) {
            for (int x = 0; x < counts.Width(); ++x) row[std::size_t(x)] = {x, y};
            resolver.ShadeRestOf(row, first, counts, out, batch);
        }
    });
    return out;
}

/// Those with few samples first, each count row by row.
std::vector<Pixel> SortedByCount(const Image<std::uint8_t>& counts) {
    std::array<std::size_t, kMaxSamples + 2> begin{};
    for (const std::uint8_t count : counts.Pixels()) ++begin[std::size_t(count) + 1];
    for (std::size_t k = 1; k < begin.size(); ++k) begin[k] += begin[k - 1];
    std::vector<Pixel> sorted(counts.Pixels().size());
    for (int y = 0; y < counts.Height(); ++y) {
        for (int x = 0; x < counts.Width(); ++x) sorted[begin[counts(x, y)]++] = {x, y};
    }
    return sorted;
}

Image<Rgb> ByCount(const Resolver& resolver, const Image<Rgb>& first,
                   const Image<std::uint8_t>& counts) {
    const std::vector<Pixel> sorted = SortedByCount(counts);
    Image<Rgb> out(first.Width(), first.Height());
    ParallelFor(
        std::int64_t(sorted.size()), kPixelsAtATime, [&](std::int64_t begin, std::int64_t end) {
            Batch batch;
            const std::span<const Pixel> some(sorted.data() + begin, std::size_t(end - begin));
            resolver.ShadeRestOf(some, first, counts, out, batch);
        });
    return out;
}

}  // namespace

Image<Rgb> ShadeFirst(int width_px, int height_px, int m, const SampleShader& shader) {
    const Resolver resolver(m, Rest::kAll, shader);
    Image<Rgb> first(width_px, height_px);
    ParallelFor(height_px, kRowsAtATime, [&](std::int64_t begin, std::int64_t end) {
        Batch batch;
        for (int y = int(begin); y < int(end); ++y) {
            batch.samples.clear();
            for (int x = 0; x < width_px; ++x) resolver.Add(x, y, 0, 1, 1, batch);
            batch.Shade(shader);
            for (int x = 0; x < width_px; ++x) first(x, y) = batch.colours[std::size_t(x)];
        }
    });
    return first;
}

Image<Rgb> ShadeRest(const Image<Rgb>& first, const Image<std::uint8_t>& counts, int m,
                     const SampleShader& shader, const RestOptions& options) {
    CheckCounts(first, counts, m);
    const Rest rest =
        options.first == FirstShade::kReused ? Rest::kAfterFirst : Rest::kAllOfMany;
    const Resolver resolver(m, rest, shader);
    return options.order == RestOrder::kOneLoop ? InOneLoop(resolver, first, counts)
                                                : ByCount(resolver, first, counts);
}

Image<Rgb> ShadeAll(int width_px, int height_px, int m, const SampleShader& shader) {
    CheckEnlargement(m);
    const Image<std::uint8_t> counts(width_px, height_px, std::uint8_t(m * m));
    return InOneLoop(Resolver(m, Rest::kAll, shader), Image<Rgb>(), counts);
}

}  // namespace plumb
