// The common ground of HBAO, GTAO and the visibility bitmask: slices through the line of
// sight, and the walk along each that finds what stands above the receiver.
//
//       V   = -C / |C|                                   towards the eye
//       t   = D - (D.V) V, of length 1                   D: direction of the slice on screen
//       a   = the unit normal of the slice, across V and t
//       n_p = n - (n.a) a,   L = |n_p|,   gamma = the angle of n_p from V towards t
//
//       offset_j = 1 + (r_px - 1) ((j + xi_2) / steps)^power  pixels,    j = 0 ... steps - 1
//       phi_k    = pi (k + xi_1) / slices,                               k = 0 ... slices - 1
//
// A sample is the point Q that the nearest pixel shows. That pixel's centre lies off the slice
// by up to 0.7 pixels, so that its direction alone would not do: a point of the receiver's own
// plane would seem to rise above it. v = Q - C is brought into the slice along that plane,
//
//       v' = v - (v.a) u,   u = (a - (n.a) n) / L^2           v'.a = 0,  v'.n = v.n
//
// which keeps its height above the plane: an open plane is open exactly, at any tilt.
//
// As published, phi is an angle on screen: t follows from D. The integrals over a slice,
// though, are those of slices spread evenly about V, and off the middle of the picture the two
// are not the same: kScreen is biased there, by 0.5 % of V for an open plane 30 degrees off
// the axis. With kLineOfSight, phi turns t about V, and D = t V_z - V t_z is where that slice
// meets the picture's plane: no bias, for a few multiplications. Ours.
//
// Source   slices: [Jimenez16]; the power: its shipped successor XeGTAO, which snaps to pixels
//          too. v': ours.
// Symbols  C, n receiver and its unit normal (m, the camera's frame), r_px radius on screen,
//          xi_1, xi_2 in [0, 1), a hash of the pixel; 1/2 without jitter.
// Domain   A pixel without a finite depth < 0 is sky: it hides nothing.
// Beware   What lies outside the drawn picture hides nothing, as if it were not there.
// Cost     2 slices steps depth lookups a pixel.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/random.h"
#include "core/vec.h"
#include "screen_space/gbuffer.h"

namespace plumb {

/// What slices are spread evenly about.
enum class SliceSpread { kScreen, kLineOfSight };

struct SliceSampling {
    double radius_m = 1;    ///< r, reach in the world. [1e-4, 1e7]
    int slices = 3;         ///< Each has two sides. [1, 4096]
    int steps = 6;          ///< Samples a side. [1, 65536]
    double step_power = 2;  ///< Above 1, near samples lie closer together. [0.25, 8]
    SliceSpread spread = SliceSpread::kScreen;
    bool jitter = true;            ///< Turn slices and shift steps from pixel to pixel.
    bool shading_normals = false;  ///< Instead of the faces' own.
    std::uint64_t seed = 1;        ///< Of the jitter.
};

/// Throws Error, naming the first field that breaks its range; `owner` is the struct's name.
void Validate(const SliceSampling& sampling, const char* owner);

/// xi_1 and xi_2 of a pixel of a picture `width` pixels wide.
struct SliceJitter {
    double turn = 0.5, shift = 0.5;
};

inline SliceJitter JitterOf(const SliceSampling& sampling, int x, int y, int width) {
    if (!sampling.jitter) return {};
    const std::uint64_t bits = RandomBits(sampling.seed, std::uint64_t(y) * width + x, 0, 0);
    return {double(bits >> 32) * 0x1p-32, double(bits & 0xffffffffu) * 0x1p-32};
}

/// One slice through a receiver.
struct Slice {
    Vec3 V, t;
    double L = 1, gamma_rad = 0;
    Vec3 along, up;  ///< v'.t = v.along, v'.V = v.up
    Vec2 step_px;    ///< D at the receiver's depth, in pixels a metre.
};

class SliceMarch {
  public:
    SliceMarch(const GBuffer& gbuffer, const SliceSampling& sampling);

    /// Makes pixel (x, y) the receiver. False where it shows the sky.
    bool Receive(int x, int y);

    const Vec3& Point() const { return C_; }
    const Vec3& Normal() const { return n_; }

    /// The slice at the angle phi, from the picture's x towards its y upwards, on screen or
    /// about the line of sight.
    Slice SliceAt(double phi_rad) const;

    /// Angle of slice k of `count` over `span`: pi, or 2 pi for directions of one side.
    double Phi(int k, int count, double span_rad) const {
        return span_rad * (k + jitter_.turn) / count;
    }

    /// visit(x, y, d2) for every sample of one side, outwards: v' = x t + y V with x > 0 for
    /// side +1 and x < 0 for side -1, d2 = |v|^2 < r^2.
    template <class Visit>
    void ForEachSample(const Slice& slice, int side, const Visit& visit) const {
        const double r2 = sampling_->radius_m * sampling_->radius_m;
        const Vec2 reach = side * sampling_->radius_m * slice.step_px;
        const double r_px = reach.norm();
        if (!(r_px > 1)) return;
        const Vec2 unit = reach / r_px;
        int last_i = i_, last_j = j_;
        for (int step = 0; step < sampling_->steps; ++step) {
            const double share = (step + jitter_.shift) / sampling_->steps;
            const double offset = 1 + (r_px - 1) * Power(share);
            const double at_i = std::floor(i_ + 0.5 + offset * unit.x());
            const double at_j = std::floor(j_ + 0.5 + offset * unit.y());
            if (!(at_i >= 0 && at_i < width_ && at_j >= 0 && at_j < height_)) return;
            const int i = int(at_i), j = int(at_j);
            if (i == last_i && j == last_j) continue;
            last_i = i;
            last_j = j;
            const double z = gbuffer_->z_m(i, j);
            if (!(z < 0 && std::isfinite(z))) continue;
            const Vec3 v = PointAt(i, j, z) - C_;
            const double d2 = v.squaredNorm();
            const double x = v.dot(slice.along);
            if (d2 >= r2 || side * x <= 0) continue;
            visit(x, v.dot(slice.up), d2);
        }
    }

  private:
    Vec3 PointAt(int i, int j, double z) const { return {-z * ray_x_[i], -z * ray_y_[j], z}; }
    double Power(double share) const {
        const double power = sampling_->step_power;
        return power == 1 ? share : power == 2 ? share * share : std::pow(share, power);
    }

    const GBuffer* gbuffer_;
    const SliceSampling* sampling_;
    int width_, height_;
    std::vector<double> ray_x_, ray_y_;  ///< Of the columns and rows, at z = -1.
    Vec2 px_per_m_;                      ///< At z = -1; y counts downwards.

    int i_ = 0, j_ = 0;
    Vec3 C_, n_;
    SliceJitter jitter_;
};

}  // namespace plumb
