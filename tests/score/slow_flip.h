// FLIP once more, straight from its definition: whole two-dimensional filters, no line, no row
// shared. For small pictures.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "core/image.h"

namespace plumb {

class SlowFlip {
  public:
    explicit SlowFlip(double ppd) : ppd_(ppd) {}

    double At(const Image<Rgb>& c, const Image<Rgb>& t, int i, int j) const {
        const double limit = Distance({0, 1, 0}, {0, 0, 1});
        const double d = Distance(Seen(c, i, j), Seen(t, i, j)), knee = 0.4 * limit;
        const double E = d < knee ? d * 0.95 / knee : 0.95 + 0.05 * (d - knee) / (limit - knee);
        const double edges = std::abs(Feature(c, i, j, false) - Feature(t, i, j, false));
        const double points = std::abs(Feature(c, i, j, true) - Feature(t, i, j, true));
        return std::pow(E, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2.0)));
    }

  private:
    using V = std::array<double, 3>;

    static double Linear(const Image<Rgb>& p, int i, int j, int c) {
        const Rgb& pixel = p(std::clamp(i, 0, p.Width() - 1), std::clamp(j, 0, p.Height() - 1));
        return std::clamp(double(pixel[std::size_t(c)]), 0.0, 1.0);
    }

    /// X, Y, Z of linear sRGB over those of white.
    static V Xyz(const V& rgb) {
        const double x = (10135552 * rgb[0] + 8788810 * rgb[1] + 4435075 * rgb[2]) / 24577794;
        const double y = (2613072 * rgb[0] + 8788810 * rgb[1] + 887015 * rgb[2]) / 12288897;
        const double z = (1425312 * rgb[0] + 8788810 * rgb[1] + 70074185 * rgb[2]) / 73733382;
        return {x / 0.950428545, y, z / 1.088900371};
    }

    static double Opponent(const V& xyz, int c) {
        if (c == 0) return 116 * xyz[1] - 16;
        return c == 1 ? 500 * (xyz[0] - xyz[1]) : 200 * (xyz[1] - xyz[2]);
    }

    static double At(const Image<Rgb>& p, int i, int j, int c) {
        return Opponent(Xyz({Linear(p, i, j, 0), Linear(p, i, j, 1), Linear(p, i, j, 2)}), c);
    }

    static double Distance(const V& a, const V& b) {
        const auto lab = [](const V& rgb) {
            V f = Xyz(rgb);
            for (double& v : f) {
                v = v > 216.0 / 24389 ? std::pow(v, 1.0 / 3) : (24389.0 / 27 * v + 16) / 116;
            }
            const double L = Opponent(f, 0);
            return V{L, 0.01 * L * Opponent(f, 1), 0.01 * L * Opponent(f, 2)};
        };
        const V p = lab(a), q = lab(b);
        return std::pow(std::abs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]), 0.7);
    }

    /// The picture as an eye sees it: linear sRGB.
    V Seen(const Image<Rgb>& p, int i, int j) const {
        using std::numbers::pi;
        const int radius = int(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd_));
        V ycc{};
        for (int c = 0; c < 3; ++c) {
            const auto weight = [&](int x, int y) {
                const double r2 = (x * x + y * y) / (ppd_ * ppd_);
                const auto g = [&](double a, double b) {
                    return a * std::sqrt(pi / b) * std::exp(-pi * pi * r2 / b);
                };
                if (c == 0) return g(1, 0.0047);
                return c == 1 ? g(1, 0.0053) : g(34.1, 0.04) + g(13.5, 0.025);
            };
            double sum = 0, weights = 0;
            for (int y = -radius; y <= radius; ++y) {
                for (int x = -radius; x <= radius; ++x) {
                    sum += weight(x, y) * At(p, i + x, j + y, c);
                    weights += weight(x, y);
                }
            }
            ycc[std::size_t(c)] = sum / weights;
        }
        const double y = (ycc[0] + 16) / 116;
        const double X = (y + ycc[1] / 500) * 0.950428545, Z = (y - ycc[2] / 200) * 1.088900371;
        V rgb{3.241003275 * X - 1.537398934 * y - 0.498615861 * Z,
              -0.969224334 * X + 1.875930071 * y + 0.041554224 * Z,
              0.055639423 * X - 0.204011202 * y + 1.057148933 * Z};
        for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
        return rgb;
    }

    double Feature(const Image<Rgb>& p, int i, int j, bool point) const {
        const double sigma = 0.5 * 0.082 * ppd_;
        const int radius = int(std::ceil(3 * sigma));
        const auto raw = [&](int x, int y) {
            const double G = std::exp(-(x * x + y * y) / (2 * sigma * sigma));
            return point ? (x * x / (sigma * sigma) - 1) * G : -x * G;
        };
        double above = 0, below = 0;
        for (int y = -radius; y <= radius; ++y) {
            for (int x = -radius; x <= radius; ++x) {
                (raw(x, y) > 0 ? above : below) += std::abs(raw(x, y));
            }
        }
        double along_x = 0, along_y = 0;
        for (int y = -radius; y <= radius; ++y) {
            for (int x = -radius; x <= radius; ++x) {
                const double luma = (At(p, i + x, j + y, 0) + 16) / 116;
                const auto w = [&](int a, int b) {
                    return raw(a, b) / (raw(a, b) > 0 ? above : below);
                };
                along_x += w(x, y) * luma;
                along_y += w(y, x) * luma;
            }
        }
        return std::hypot(along_x, along_y);
    }

    double ppd_;
};

}  // namespace plumb
