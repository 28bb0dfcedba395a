#include "rays/packets/bsp_split.h"

#include <algorithm>
#include <array>
#include <limits>

namespace plumb {
namespace {

constexpr int kBins = 128;

class Search {
  public:
    Search(std::size_t n, const BspBox& cell, const BspCosts& costs)
        : n_(double(n)), cell_(cell), costs_(costs), least_(costs.test * double(n)) {
        for (std::size_t k = 0; k < 3; ++k) {
            size_[k] = double(cell.high_m[k]) - double(cell.low_m[k]);
        }
        surface_ = size_[0] * size_[1] + size_[1] * size_[2] + size_[2] * size_[0];
    }

    bool CanSplit() const { return surface_ > 0 && n_ > 1; }
    const std::optional<BspSplit>& Best() const { return best_; }

    void Try(std::uint32_t axis, float at_m, double left, double right) {
        if (!(at_m > cell_.low_m[axis] && at_m < cell_.high_m[axis])) return;
        const double a = size_[(axis + 1) % 3], b = size_[(axis + 2) % 3];
        const double ends = a * b, around = a + b;
        const double s_left = ends + around * (double(at_m) - double(cell_.low_m[axis]));
        const double s_right = ends + around * (double(cell_.high_m[axis]) - double(at_m));
        double cost = costs_.step + costs_.test * (s_left * left + s_right * right) / surface_;
        if (left == 0 || right == 0) cost *= 1 - costs_.empty;
        if (cost < least_) {
            least_ = cost;
            best_ = BspSplit{axis, at_m};
        }
    }

  private:
    double n_;
    const BspBox& cell_;
    const BspCosts& costs_;
    double least_;
    std::array<double, 3> size_;
    double surface_;
    std::optional<BspSplit> best_;
};

void TryEveryEnd(std::span<const BspReference> references, BspScratch& scratch,
                 Search& search) {
    const std::size_t n = references.size();
    scratch.lows.resize(n);
    scratch.highs.resize(n);
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        for (std::size_t i = 0; i < n; ++i) {
            scratch.lows[i] = references[i].box.low_m[axis];
            scratch.highs[i] = references[i].box.high_m[axis];
        }
        std::ranges::sort(scratch.lows);
        std::ranges::sort(scratch.highs);
        // Left of a plane begins what is lower, right of it ends what is higher. What lies in
        // the plane itself is counted on neither side here: it does not change the choice.
        std::size_t begun = 0, ended = 0, i = 0, j = 0;
        while (i < n || j < n) {
            const float at = i < n && (j == n || scratch.lows[i] <= scratch.highs[j])
                                 ? scratch.lows[i]
                                 : scratch.highs[j];
            while (i < n && scratch.lows[i] == at) ++i;
            while (j < n && scratch.highs[j] == at) ++j;
            ended = j;
            search.Try(axis, at, double(begun), double(n - ended));
            begun = i;
        }
    }
}

void TryEvenly(std::span<const BspReference> references, const BspBox& cell, Search& search) {
    std::array<std::array<std::uint32_t, kBins>, 3> begin{}, end{};
    std::array<float, 3> per_m;
    for (std::size_t k = 0; k < 3; ++k) {
        const double size = double(cell.high_m[k]) - double(cell.low_m[k]);
        per_m[k] = size > 0 ? float(std::min(kBins / size, 1e37)) : 0;
    }
    const auto bin = [&](float x, std::size_t k) {
        const float b = (x - cell.low_m[k]) * per_m[k];
        return std::size_t(std::clamp(b, 0.0f, kBins - 1.0f));
    };
    for (const BspReference& reference : references) {
        for (std::size_t k = 0; k < 3; ++k) {
            ++begin[k][bin(reference.box.low_m[k], k)];
            ++end[k][bin(reference.box.high_m[k], k)];
        }
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
        const double size = double(cell.high_m[k]) - double(cell.low_m[k]);
        double begun = 0, left = double(references.size());
        for (int b = 1; b < kBins; ++b) {
            begun += begin[k][std::size_t(b - 1)];
            left -= end[k][std::size_t(b - 1)];
            const float at = float(double(cell.low_m[k]) + size * b / kBins);
            search.Try(k, at, begun, left);
        }
    }
}

}  // namespace

std::optional<BspSplit> CheapestSplit(std::span<const BspReference> references,
                                      const BspBox& cell, const BspCosts& costs,
                                      BspScratch& scratch) {
    Search search(references.size(), cell, costs);
    if (!search.CanSplit()) return std::nullopt;
    if (references.size() <= costs.few) {
        TryEveryEnd(references, scratch, search);
    } else {
        TryEvenly(references, cell, search);
    }
    return search.Best();
}

}  // namespace plumb
