#include "screen_space/antialiasing/index_matrix.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "screen_space/antialiasing/windows.h"

namespace plumb {
namespace {

int SquaredDistance(const SamplePlace& a, const SamplePlace& b) {
    return (a.i - b.i) * (a.i - b.i) + (a.j - b.j) * (a.j - b.j);
}

std::vector<int> NumbersOf(const std::vector<SamplePlace>& order, int m) {
    std::vector<int> numbers(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        numbers[std::size_t(order[k].j * m + order[k].i)] = int(k);
    }
    return numbers;
}

std::vector<SamplePlace> PlacesOf(const std::vector<int>& numbers, int m) {
    std::vector<SamplePlace> order(numbers.size());
    for (std::size_t at = 0; at < numbers.size(); ++at) {
        order[std::size_t(numbers[at])] = {int(at) % m, int(at) / m};
    }
    return order;
}

std::vector<int> Plain(int m);

std::vector<int> Doubled(int m) {
    static constexpr int kBlock[2][2] = {{0, 2}, {3, 1}};
    const std::vector<int> half = Plain(m / 2);
    std::vector<int> numbers;
    for (int j = 0; j < m; ++j) {
        for (int i = 0; i < m; ++i) {
            const int of_half = half[std::size_t(j % (m / 2) * (m / 2) + i % (m / 2))];
            numbers.push_back(4 * of_half + kBlock[j / (m / 2)][i / (m / 2)]);
        }
    }
    return numbers;
}

/// From the middle, each next one as far from all before it as it can be.
std::vector<int> Spread(int m) {
    std::vector<SamplePlace> order{{m / 2, m / 2}};
    while (int(order.size()) < m * m) {
        SamplePlace best;
        std::pair best_rank{0, 0};
        for (int at = 0; at < m * m; ++at) {
            const SamplePlace place{at % m, at / m};
            int nearest = std::numeric_limits<int>::max();
            for (const SamplePlace& taken : order) {
                nearest = std::min(nearest, SquaredDistance(place, taken));
            }
            const std::pair rank{nearest, SquaredDistance(place, order.back())};
            if (nearest > 0 && rank > best_rank) {
                best_rank = rank;
                best = place;
            }
        }
        order.push_back(best);
    }
    return NumbersOf(order, m);
}

std::vector<int> Plain(int m) {
    if (m == 1) return {0};
    if (m == 3) return {2, 6, 3, 5, 0, 8, 1, 7, 4};
    return m % 2 == 0 ? Doubled(m) : Spread(m);
}

/// Four times the squared distance to the window's middle.
int FromMiddle(const SamplePlace& place, int m) {
    return SquaredDistance({2 * place.i + 1, 2 * place.j + 1}, {m, m});
}

}  // namespace

std::vector<SamplePlace> SampleOrder(int m) {
    CheckEnlargement(m);
    std::vector<SamplePlace> order = PlacesOf(Plain(m), m);
    if (m > 1 && FromMiddle(order[1], m) < FromMiddle(order[0], m)) {
        std::swap(order[0], order[1]);
    }
    return order;
}

std::vector<int> IndexMatrix(int m) {
    return NumbersOf(SampleOrder(m), m);
}

}  // namespace plumb
