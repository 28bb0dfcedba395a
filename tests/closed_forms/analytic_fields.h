// Height fields whose light is known in closed form, laid on the grid so that as much of it as
// possible stays exact: the yardsticks of every test.
//
//   Flat      z = 0                                      exact on the grid
//   Tilted    z = g_x x + g_y y                          exact on the grid
//   VGroove   two faces of length L that meet at phi     exact on the grid
//   Trench    w wide, d deep, land between               walls are ramps of one texel
//   Pit       round, radius R, depth d                   wall is a jagged ramp of one texel
//   Bowl      cap of a sphere, half-angle psi            chords of the sphere, order s^2
//   Sinusoid  A/2 sin 2 pi (k_x u + k_y v)               chords of the wave, order s^2
//
// Source   Closed forms: V-groove, trench and bowl are textbook radiative transfer (Lambert's
//          law in the plane; the sphere's constant form factor). They stand beside this;
//          here each struct says for which surface they hold and how the grid departs from it.
// Symbols  s spacing (m), square texels throughout; other letters at each struct.
// Beware   "Exact on the grid" means: the triangulated field is the continuous surface, up to
//          the rounding of a double. The centre of texel 0 lies at s/2, not at 0.
#pragma once

#include "heightfield/height_field.h"

namespace plumb {

/// Level ground: alpha = V = 1, no bounce ever. Exact on the grid, any boundary.
struct Flat {
    int width_texels = 64;   ///< [2, 16384]
    int height_texels = 64;  ///< [2, 16384]
    double spacing_m = 1;    ///< s. (0, ...)
    double height_m = 0;     ///< z of every texel. finite
    Boundary boundary = Boundary::kWrap;
};

/// An inclined plane, open: it sees nothing of itself, so no facet ever links to another; its
/// normal has n_z = 1 / sqrt(1 + g_x^2 + g_y^2), and it sees (1 + n_z) / 2 of the cosine-
/// weighted sky above the horizontal. Exact on the grid.
struct Tilted {
    int width_texels = 64;   ///< [2, 16384]
    int height_texels = 64;  ///< [2, 16384]
    double spacing_m = 1;    ///< s. (0, ...)
    double slope_x = 0.5;    ///< g_x, metres up per metre along x. finite
    double slope_y = 0;      ///< g_y. finite
};

/// Grooves along y, crest to crest, all crests level at z = 0: plane faces of length L meet at
/// the opening angle phi. At the distance s from the apex, in units of L,
/// V = 1/2 (1 - (cos phi - s) / sqrt(s^2 + 1 - 2 s cos phi)); the mean over a face is
/// sin(phi / 2). Exact on the grid: apexes and crests stand on texel centres, a crest on texel
/// 0, and no cell spans two faces.
struct VGroove {
    double opening_rad = 1.5707963267948966;  ///< phi. (0, pi)
    double face_m = 1;                        ///< L. (0, ...)
    int texels_per_face = 32;                 ///< Cells along one face. [1, 16384]
    int grooves = 1;                          ///< Along x. [1, 16384]
    int rows = 4;                             ///< Texels along y. [2, 16384]

    double DepthM() const;    ///< L cos(phi / 2).
    double PeriodM() const;   ///< 2 L sin(phi / 2), crest to crest.
    double SpacingM() const;  ///< s = L sin(phi / 2) / texels_per_face, along x and y.
};

/// Trenches along y in level land at z = 0, floor at -d. For vertical walls w apart, at the
/// distance t from a wall, the floor has
/// V = 1/2 ((w - t) / sqrt((w - t)^2 + d^2) + t / sqrt(t^2 + d^2)).
/// On the grid a wall is a ramp one texel wide whose middle stands where the wall should: the
/// floor is w - s wide, the rims are w + s apart (half-height width exactly w), and the form
/// above holds exactly with w - t + s/2 and t + s/2 for w - t and t. So V of the floor is too
/// large, by first order in s.
struct Trench {
    double width_m = 1;     ///< w. (0, ...)
    double depth_m = 1;     ///< d. (0, ...)
    int width_texels = 32;  ///< Floor texels: s = w / width_texels. [1, 16384]
    int land_texels = 32;  ///< Level texels between trenches: land of land_texels s. [1, 16384]
    int rows = 4;          ///< Texels along y. [2, 16384]

    double SpacingM() const;  ///< s.
    double LandM() const;     ///< land_texels s.
};

/// A round pit in level ground at z = 0, floor at -d, centred on texel (n/2, n/2). The middle
/// of the floor of a pit with a vertical wall has V = R^2 / (R^2 + d^2),
/// alpha = 1 - d / sqrt(R^2 + d^2). On the grid a texel is low if its centre lies nearer than R
/// to the middle: the rim lies between R - s^2 / (4 R) (a chord) and R + sqrt(2) s, so V in the
/// middle is too large by first order in s, never too small but by second.
struct Pit {
    double radius_m = 1;        ///< R. (0, ...)
    double depth_m = 1;         ///< d. (0, ...)
    double radius_texels = 24;  ///< R / s. [1, texels / 2 - 2]
    int texels = 64;            ///< n, along either side; the field wraps. [6, 16384]

    double SpacingM() const;  ///< s.
};

/// A cap of a sphere of radius R sunk into level ground at z = 0, centred on texel (n/2, n/2).
/// Every point of it has V = (1 + cos psi) / 2, and with f = 1 - V: E_k = V f^k,
/// E(rho) = V / (1 - rho f). On the grid texel centres stand on the sphere and facets are
/// chords inside it, off by at most s^2 / (4 R cos^3 psi) except in the cells that the rim
/// crosses, which cut the corner between cap and ground. psi = pi/2 has an upright rim: there
/// the departure is of order sqrt(s).
struct Bowl {
    double sphere_radius_m = 1;                ///< R. (0, ...)
    double half_angle_rad = 1.04719755119660;  ///< psi, of the cap at the centre. (0, pi/2]
    double rim_texels = 24;                    ///< Rim radius over s. [2, texels / 2 - 2]
    int texels = 64;  ///< n, along either side; the field wraps. [8, 16384]

    double DepthM() const;      ///< h = R (1 - cos psi) <= R.
    double RimRadiusM() const;  ///< R sin psi.
    double SpacingM() const;    ///< s = R sin psi / rim_texels.
};

/// A plane wave, z = A/2 sin(2 pi (k_x u + k_y v)) with u, v in [0, 1) across the tile and
/// u = (i + 1/2) / width_texels. No closed form of its light, but the smooth member of the
/// family: on the grid it is off by at most pi^2 A s^2 (k_x^2 / W^2 + k_y^2 / H^2) / 2, with
/// W, H the extents of the tile, so an error of order s^2 can be told from one of order s.
struct Sinusoid {
    double amplitude_m = 0.3;  ///< A, trough to crest. [0, ...)
    int periods_x = 1;         ///< k_x. [0, width_texels / 2)
    int periods_y = 0;         ///< k_y. [0, height_texels / 2), not both 0
    int width_texels = 64;     ///< [3, 16384]
    int height_texels = 64;    ///< [3, 16384]
    double width_m = 1;        ///< Extent along x; s = width_m / width_texels. (0, ...)
};

/// Each throws Error, naming the first field that breaks its range above.
void Validate(const Flat& p);
void Validate(const Tilted& p);
void Validate(const VGroove& p);
void Validate(const Trench& p);
void Validate(const Pit& p);
void Validate(const Bowl& p);
void Validate(const Sinusoid& p);

/// The fields themselves; each validates first. Tilted is open, all others but Flat wrap.
HeightField MakeFlat(const Flat& p);
HeightField MakeTilted(const Tilted& p);
HeightField MakeVGroove(const VGroove& p);
HeightField MakeTrench(const Trench& p);
HeightField MakePit(const Pit& p);
HeightField MakeBowl(const Bowl& p);
HeightField MakeSinusoid(const Sinusoid& p);

}  // namespace plumb
