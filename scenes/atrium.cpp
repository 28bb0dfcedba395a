#include "scenes/atrium.h"

#include <algorithm>
#include <cmath>

#include "core/conventions.h"
#include "core/error.h"
#include "core/random.h"
#include "scenes/builder.h"

namespace plumb {
namespace {

// The court is open to the sky; galleries run along its two long sides, on both storeys.
constexpr double kHalfLength = 14, kHalfCourt = 3.5, kGallery = 3.2;
constexpr double kStorey = 4.6, kColumn = 0.28, kWallThick = 0.5;
constexpr int kBays = 8;
constexpr double kBay = 2 * kHalfLength / kBays;
constexpr double kSpring = 2.6;  // Height over its floor where an arch leaves its columns.

class Hall {
  public:
    Hall(SceneBuilder& build, double detail) : build_(build), detail_(detail) {}

    void Build() {
        Floor();
        Walls();
        for (const int side : {-1, 1}) {
            for (const int storey : {0, 1}) Arcade(side, storey);
            Balustrade(side);
            Furnish(side);
        }
    }

  private:
    int N(int segments) const { return std::max(3, int(std::lround(segments * detail_))); }

    // Tiles with bevelled edges, each at a height of its own within 3 mm.
    void Floor() {
        constexpr double kTile = 0.5, kGap = 0.008;
        build_.Use("floor", {0.42f, 0.38f, 0.34f});
        const double half_width = kHalfCourt + kGallery;
        build_.Rectangle({-kHalfLength, -half_width, -0.01}, {2 * kHalfLength, 0, 0},
                         {0, 2 * half_width, 0});
        const int nx = int(2 * kHalfLength / kTile), ny = int(2 * half_width / kTile);
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                const double z = 0.003 * RandomUnit(1, i, j, 0);
                const Vec3 low(-kHalfLength + i * kTile + kGap, -half_width + j * kTile + kGap,
                               -0.01);
                const double wide = kTile - 2 * kGap, in = 0.012;
                const Vec3 a = low, b = low + Vec3(wide, 0, 0), c = low + Vec3(wide, wide, 0),
                           d = low + Vec3(0, wide, 0);
                const double up = 0.01 + z;
                const Vec3 e = a + Vec3(in, in, up), f = b + Vec3(-in, in, up),
                           g = c + Vec3(-in, -in, up), h = d + Vec3(in, -in, up);
                build_.Quad(e, f, g, h);
                build_.Quad(a, b, f, e);
                build_.Quad(b, c, g, f);
                build_.Quad(c, d, h, g);
                build_.Quad(d, a, e, h);
            }
        }
    }

    // Rough masonry at the back of the galleries and at the ends, upper floors, roofs.
    void Walls() {
        build_.Use("masonry", {0.62f, 0.52f, 0.42f});
        const double back = kHalfCourt + kGallery, top = 2 * kStorey;
        const auto rough = [](double s, double z, int wall) {
            const int course = int(std::max(z, 0.0) / 0.3);
            const int stone = int(s / 0.6 + 0.5 * (course % 2));
            return 0.025 * RandomUnit(2, wall, course, stone);
        };
        for (const int side : {-1, 1}) {
            build_.Sheet(N(140), N(36), [&](double u, double v) {
                const double s = side > 0 ? 1 - u : u, z = top * v - 0.05 * (1 - v);
                return Vec3(kHalfLength * (1 - 2 * s),
                            side * (back - rough(2 * kHalfLength * s, z, side + 1)), z);
            });
            build_.Sheet(N(60), N(36), [&](double u, double v) {
                const double s = side > 0 ? 1 - u : u, z = top * v - 0.05 * (1 - v);
                return Vec3(side * (kHalfLength - rough(2 * back * s, z, side + 5)),
                            back * (2 * s - 1), z);
            });
        }
        build_.Use("plaster", {0.72f, 0.68f, 0.6f});
        for (const int side : {-1, 1}) {
            const double inner = side * kHalfCourt, outer = side * back;
            for (const int storey : {1, 2}) {
                const double z = storey * kStorey;
                build_.Box({-kHalfLength, std::min(inner, outer), z - 0.25},
                           {kHalfLength, std::max(inner, outer), z});
            }
        }
    }

    double FloorM(int storey) const { return storey * kStorey; }

    // Columns, and arches with their wall above them.
    void Arcade(int side, int storey) {
        const double y = side * kHalfCourt, floor = FloorM(storey);
        build_.Use("columns", {0.7f, 0.66f, 0.58f});
        for (int k = 0; k <= kBays; ++k) {
            Column({-kHalfLength + k * kBay, y, floor});
        }
        build_.Use("arches", {0.66f, 0.58f, 0.47f});
        for (int k = 0; k < kBays; ++k) Arch(-kHalfLength + k * kBay, y, floor);
    }

    // A round shaft with flutes, a swelling foot and a capital.
    void Column(const Vec3& foot) {
        const int segments = N(36), rings = N(24);
        build_.Sheet(segments, rings, [&](double u, double v) -> Vec3 {
            const double foot_swell = 0.1 * std::exp(-v / 0.03);
            const double capital = 0.14 * std::exp((v - 1) / 0.04);
            const bool shaft = v > 0.1 && v < 0.9;
            const double flute = shaft ? 0.012 * std::cos(2 * kPi * 12 * u) : 0;
            const double r = kColumn * (1 - 0.12 * v) + foot_swell + capital + flute;
            const double phi = 2 * kPi * u;
            return foot + Vec3(r * std::cos(phi), r * std::sin(phi), kSpring * v);
        });
        const double half = kColumn + 0.16;
        build_.Box(foot + Vec3(-half, -half, kSpring - 0.1), foot + Vec3(half, half, kSpring));
    }

    // The wall between two columns over a half circle, seen from both sides and from below.
    void Arch(double x, double y, double floor) {
        const double r = kBay / 2 - kColumn - 0.1, spring = floor + kSpring;
        const double top = floor + kStorey - 0.25;
        const auto arc = [&](double u) {
            const double theta = kPi * (1 - u);
            return Vec2(x + kBay / 2 + r * std::cos(theta), spring + r * std::sin(theta));
        };
        const auto outline = [&](double u) {
            if (u < 0.25) return Vec2(x, spring + (top - spring) * u / 0.25);
            if (u > 0.75) return Vec2(x + kBay, spring + (top - spring) * (1 - u) / 0.25);
            return Vec2(x + kBay * (u - 0.25) / 0.5, top);
        };
        for (const int face : {-1, 1}) {
            build_.Sheet(N(48), N(6), [&](double u, double v) {
                const double s = face < 0 ? u : 1 - u;
                const Vec2 p = (1 - v) * arc(s) + v * outline(s);
                // A moulding along the arch.
                const double out = v < 0.25 ? 0.03 * std::sin(kPi * v / 0.25) : 0;
                return Vec3(p.x(), y + face * (kWallThick / 2 + out), p.y());
            });
        }
        build_.Sheet(N(48), 4, [&](double u, double v) {
            const Vec2 p = arc(1 - u);
            return Vec3(p.x(), y + kWallThick * (v - 0.5), p.y());
        });
    }

    // Along the edge of the upper gallery, between the columns.
    void Balustrade(int side) {
        const double y = side * kHalfCourt, floor = FloorM(1);
        build_.Use("balusters", {0.68f, 0.64f, 0.57f});
        for (int k = 0; k < kBays; ++k) {
            const double from = -kHalfLength + k * kBay + kColumn + 0.2;
            const double wide = kBay - 2 * (kColumn + 0.2);
            for (int b = 0; b < 8; ++b) {
                build_.Revolve(
                    {from + wide * (b + 0.5) / 8, y, floor}, N(12), N(14),
                    [](double v) { return 0.035 + 0.025 * std::sin(kPi * v) * (1.5 - v); },
                    [](double v) { return 0.8 * v; });
            }
            build_.Box({from, y - 0.09, floor + 0.8}, {from + wide, y + 0.09, floor + 0.9});
        }
    }

    void Furnish(int side) {
        // Cloth between every second pair of columns, gathered into folds towards its foot.
        for (int k = 1; k < kBays; k += 2) {
            const bool red = (k / 2) % 2 == 0;
            build_.Use(red ? "red cloth" : "blue cloth",
                       red ? Rgb{0.55f, 0.08f, 0.06f} : Rgb{0.08f, 0.14f, 0.45f});
            const double from = -kHalfLength + k * kBay + 0.35, wide = kBay - 0.7;
            build_.Sheet(N(72), N(44), [&](double u, double v) {
                const double fold = 0.09 * (1 - 0.6 * v) *
                                    std::sin(2 * kPi * 9 * u + 1.3 * std::sin(5 * v + k));
                const double gathered = 0.5 + (u - 0.5) * (0.72 + 0.28 * v);
                return Vec3(from + wide * gathered, side * (kHalfCourt + 0.75) + fold,
                            0.25 + 2.9 * v);
            });
        }
        // Vases in the court, one before every second column.
        build_.Use("vases", {0.5f, 0.3f, 0.18f});
        for (int k = 1; k < kBays; k += 2) {
            build_.Revolve(
                {-kHalfLength + k * kBay, side * (kHalfCourt - 0.9), 0}, N(48), N(40),
                [](double v) {
                    return 0.12 + 0.24 * std::pow(std::sin(kPi * std::pow(v, 0.7)), 2) +
                           0.05 * v;
                },
                [](double v) { return 0.95 * v; });
        }
    }

    SceneBuilder& build_;
    double detail_;
};

}  // namespace

Scene Atrium(double detail) {
    if (!(detail >= 0.1 && detail <= 4)) {
        throw Error(MustBe("atrium: detail", detail, "in [0.1, 4]"));
    }
    SceneBuilder build("atrium");
    Hall(build, detail).Build();
    build.Light().sky = {1, 1, 1};
    build.Light().directional.push_back(
        {.towards = {0.35, 0.25, 1}, .irradiance = {2.2f, 2.0f, 1.7f}});
    build.AddCamera("court", {-11, -1.2, 1.7}, {6, 1.2, 2.2}, 60);
    build.AddCamera("gallery", {-9, 5.2, 6.3}, {5, 2.5, 5.2}, 60);
    build.AddCamera("vase", {-7.9, -0.9, 1.4}, {-10.5, -2.6, 0.5}, 45);
    return build.Finish();
}

}  // namespace plumb
