#include "screen_space/antialiasing/smaa_area.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace plumb {
namespace {

struct Point {
    double x, y;
};

SmaaShares operator+(const SmaaShares& a, const SmaaShares& b) {
    return {a[0] + b[0], a[1] + b[1]};
}

// The shares of the pixel [x, x + 1] under the segment from p to q; below the edge is negative.
SmaaShares UnderSegment(const Point& p, const Point& q, double x) {
    const double slope = (q.y - p.y) / (q.x - p.x);
    const bool touches = (x >= p.x && x < q.x) || (x + 1 > p.x && x + 1 <= q.x);
    if (!touches) return {0, 0};
    const double y_1 = p.y + slope * (x - p.x), y_2 = p.y + slope * (x + 1 - p.x);
    constexpr double kOnTheEdge = 1e-4;  // The published script's.
    const bool one_side = std::signbit(y_1) == std::signbit(y_2) ||
                          std::abs(y_1) < kOnTheEdge || std::abs(y_2) < kOnTheEdge;
    if (one_side) {
        const double a = (y_1 + y_2) / 2;
        return a < 0 ? SmaaShares{-a, 0} : SmaaShares{0, a};
    }
    // It crosses the edge within the pixel: a triangle on each side.
    const double x_0 = p.x - p.y / slope, share = x_0 - std::floor(x_0);
    const double a_1 = x_0 > p.x ? y_1 * share / 2 : 0;
    const double a_2 = x_0 < q.x ? y_2 * (1 - share) / 2 : 0;
    const double sign = std::abs(a_1) > std::abs(a_2) ? a_1 : -a_2;
    return sign < 0 ? SmaaShares{std::abs(a_1), std::abs(a_2)}
                    : SmaaShares{std::abs(a_2), std::abs(a_1)};
}

SmaaShares Smoothed(const SmaaShares& shares, double d) {
    SmaaShares out;
    for (std::size_t k = 0; k < 2; ++k) {
        const double a = shares[k], b = std::sqrt(2 * a) / 2;
        out[k] = b + (a - b) * std::min(1.0, d / 32);
    }
    return out;
}

// Which share of 30 x 30 points of the pixel at `corner` lies on the positive side of the line.
double SideOfLine(const Point& p, const Point& q, const Point& corner) {
    if (p.x == q.x && p.y == q.y) return 1;
    constexpr int kPoints = 30;
    const double middle_x = (p.x + q.x) / 2, middle_y = (p.y + q.y) / 2;
    int inside = 0;
    for (int i = 0; i < kPoints; ++i) {
        for (int j = 0; j < kPoints; ++j) {
            const double x = corner.x + i / (kPoints - 1.0), y = corner.y + j / (kPoints - 1.0);
            inside += (q.y - p.y) * (x - middle_x) + (p.x - q.x) * (y - middle_y) > 0;
        }
    }
    return double(inside) / (kPoints * kPoints);
}

// From p to q + (d, d).
SmaaShares BesideDiagonal(const Point& p, const Point& q, int left, int right) {
    const double d = left + right + 1, l = left;
    const Point end{q.x + d, q.y + d};
    return {1 - SideOfLine(p, end, {1 + l, l}), SideOfLine(p, end, {1 + l, 1 + l})};
}

struct DiagonalLine {
    Point from, to;
};

// One or two lines of each pattern; one line twice is that line.
constexpr std::array<std::array<DiagonalLine, 2>, 16> kDiagonalLines{{
    {{{{1, 1}, {1, 1}}, {{1, 0}, {1, 0}}}},
    {{{{1, 0}, {0, 0}}, {{1, 0}, {1, 0}}}},
    {{{{0, 0}, {1, 0}}, {{1, 0}, {1, 0}}}},
    {{{{1, 0}, {1, 0}}, {{1, 0}, {1, 0}}}},
    {{{{1, 1}, {0, 0}}, {{1, 1}, {1, 0}}}},
    {{{{1, 1}, {0, 0}}, {{1, 0}, {1, 0}}}},
    {{{{1, 1}, {1, 0}}, {{1, 1}, {1, 0}}}},
    {{{{1, 1}, {1, 0}}, {{1, 0}, {1, 0}}}},
    {{{{0, 0}, {1, 1}}, {{1, 0}, {1, 1}}}},
    {{{{1, 0}, {1, 1}}, {{1, 0}, {1, 1}}}},
    {{{{0, 0}, {1, 1}}, {{1, 0}, {1, 0}}}},
    {{{{1, 0}, {1, 1}}, {{1, 0}, {1, 0}}}},
    {{{{1, 1}, {1, 1}}, {{1, 1}, {1, 1}}}},
    {{{{1, 1}, {1, 1}}, {{1, 0}, {1, 1}}}},
    {{{{1, 1}, {1, 1}}, {{1, 1}, {1, 0}}}},
    {{{{1, 1}, {1, 1}}, {{1, 0}, {1, 0}}}},
}};

class TableWriter {
  public:
    TableWriter() : bytes_(std::size_t(kSmaaAreaWidth) * kSmaaAreaHeight * 2) {}

    void Write(int x, int y, const SmaaShares& shares) {
        for (std::size_t k = 0; k < 2; ++k) {
            bytes_[(std::size_t(y) * kSmaaAreaWidth + x) * 2 + k] =
                std::uint8_t(std::floor(255 * shares[k]));
        }
    }

    std::vector<std::uint8_t> Take() { return std::move(bytes_); }

  private:
    std::vector<std::uint8_t> bytes_;
};

std::vector<std::uint8_t> MakeTable() {
    TableWriter table;
    ParallelFor(16, 1, [&](std::int64_t begin, std::int64_t) {
        const int p = int(begin), below_l = p & 1, below_r = p >> 1 & 1, above_l = p >> 2 & 1,
                  above_r = p >> 3;
        const int x = (3 * below_l + above_l) * kSmaaCell,
                  y = (3 * below_r + above_r) * kSmaaCell;
        for (int r = 0; r < kSmaaCell; ++r) {
            for (int l = 0; l < kSmaaCell; ++l) {
                table.Write(x + l, y + r, OrthogonalArea(p, l * l, r * r));
            }
        }
        const int right_half = kSmaaAreaWidth / 2;
        const int xd = right_half + (below_l + 2 * above_l) * kSmaaDiagonalCell,
                  yd = (2 * below_r + above_r) * kSmaaDiagonalCell;
        for (int r = 0; r < kSmaaDiagonalCell; ++r) {
            for (int l = 0; l < kSmaaDiagonalCell; ++l) {
                table.Write(xd + l, yd + r, DiagonalArea(p, l, r));
            }
        }
    });
    return table.Take();
}

double Texel(int x, int y, std::size_t channel) {
    static const std::vector<std::uint8_t>& table = SmaaAreaTable();
    return table[(std::size_t(y) * kSmaaAreaWidth + x) * 2 + channel] / 255.0;
}

}  // namespace

SmaaShares OrthogonalArea(int pattern, int left, int right) {
    const double d = left + right + 1, x = left;
    const Point from_above{0, 0.5}, from_below{0, -0.5}, middle{d / 2, 0}, to_above{d, 0.5},
        to_below{d, -0.5};
    switch (pattern) {
        case 1:
            return left <= right ? UnderSegment(from_below, middle, x) : SmaaShares{0, 0};
        case 4:
            return left <= right ? UnderSegment(from_above, middle, x) : SmaaShares{0, 0};
        case 2:
            return left >= right ? UnderSegment(middle, to_below, x) : SmaaShares{0, 0};
        case 8:
            return left >= right ? UnderSegment(middle, to_above, x) : SmaaShares{0, 0};
        case 3:
            return Smoothed(UnderSegment(from_below, middle, x), d) +
                   Smoothed(UnderSegment(middle, to_below, x), d);
        case 12:
            return Smoothed(UnderSegment(from_above, middle, x), d) +
                   Smoothed(UnderSegment(middle, to_above, x), d);
        case 6:
        case 7:
        case 14:
            return UnderSegment(from_above, to_below, x);
        case 9:
        case 11:
        case 13:
            return UnderSegment(from_below, to_above, x);
        default:
            return {0, 0};
    }
}

SmaaShares DiagonalArea(int pattern, int left, int right) {
    const auto& lines = kDiagonalLines[std::size_t(pattern)];
    const SmaaShares sum = BesideDiagonal(lines[0].from, lines[0].to, left, right) +
                           BesideDiagonal(lines[1].from, lines[1].to, left, right);
    return {sum[0] / 2, sum[1] / 2};
}

int OrthogonalPattern(int left_code, int right_code) {
    return (left_code >= 3) + 2 * (right_code >= 3) + 4 * (left_code % 3) +
           8 * (right_code % 3);
}

int DiagonalPattern(int left_code, int right_code) {
    return (left_code & 1) + 2 * (right_code >> 1) + 4 * (left_code >> 1) +
           8 * (right_code & 1);
}

const std::vector<std::uint8_t>& SmaaAreaTable() {
    static const std::vector<std::uint8_t> table = MakeTable();
    return table;
}

SmaaShares TabledOrthogonalArea(int left_code, int right_code, int left, int right) {
    const double u = std::sqrt(double(left)), v = std::sqrt(double(right));
    const int l = std::min(int(u), kSmaaCell - 2), r = std::min(int(v), kSmaaCell - 2);
    const int x = left_code * kSmaaCell + l, y = right_code * kSmaaCell + r;
    const double s = u - l, t = v - r;
    SmaaShares out;
    for (std::size_t k = 0; k < 2; ++k) {
        out[k] = (1 - t) * ((1 - s) * Texel(x, y, k) + s * Texel(x + 1, y, k)) +
                 t * ((1 - s) * Texel(x, y + 1, k) + s * Texel(x + 1, y + 1, k));
    }
    return out;
}

SmaaShares TabledDiagonalArea(int left_code, int right_code, int left, int right) {
    const int x = kSmaaAreaWidth / 2 + left_code * kSmaaDiagonalCell + left;
    const int y = right_code * kSmaaDiagonalCell + right;
    return {Texel(x, y, 0), Texel(x, y, 1)};
}

}  // namespace plumb
