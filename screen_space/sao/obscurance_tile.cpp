#include "screen_space/sao/obscurance_tile.h"

#include <algorithm>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "screen_space/sao/obscurance_tile.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace plumb::HWY_NAMESPACE {
namespace {

#include "screen_space/simd/lanes.inc"
// Made of these:
#include "screen_space/sao/pixel_turns.inc"

/// A block of pixels, side by side in a row.
struct Block {
    F x, y;      // pixel
    F z;         // m
    F s_x, s_y;  // C = z (s_x, s_y, 1)
    F n_x, n_y, n_z;
    F open;  // 1 where A = 1 whatever the taps meet, else 0
};

inline F FromMask(M mask) {
    return hn::IfThenElseZero(mask, Set(1));
}

// The neighbour of preference, or the other one, or none: its depth, and the step to it.
struct Partner {
    F z, step;
};

inline Partner Choose(F z_first, F step_first, F z_second, F z) {
    const F sky = Set(GBuffer::kSkyZ);
    const auto first = hn::Gt(z_first, sky), second = hn::Gt(z_second, sky);
    return {hn::IfThenElse(first, z_first, hn::IfThenElse(second, z_second, z)),
            hn::IfThenElse(first, step_first, hn::IfThenElseZero(second, hn::Neg(step_first)))};
}

// [McGuire12 eq. 4], as in depth_normal.h.
void NormalsFromDepth(const ObscuranceTask& task, const float* row, int x, int y, Block& b) {
    const Floats df;
    const Ints di;
    const F sky = Set(GBuffer::kSkyZ);
    const std::int32_t pitch = task.pyramid->Pitch();
    const F column = hn::Add(hn::Iota(df, 0), Set(float(x)));
    const F right = hn::IfThenElse(hn::Lt(column, Set(float(task.width - 1))),
                                   hn::LoadU(df, row + x + 1), sky);
    const F left = hn::IfThenElse(hn::Gt(column, Set(0)), hn::LoadU(df, row + x - 1), sky);
    const F lower = y + 1 < task.height ? hn::LoadU(df, row + pitch + x) : sky;
    const F upper = y > 0 ? hn::LoadU(df, row - pitch + x) : sky;
    const I parity = hn::And(hn::Add(hn::Iota(di, 0), hn::Set(di, x)), hn::Set(di, 1));
    const auto even = hn::RebindMask(df, hn::Eq(parity, hn::Zero(di)));
    const F plus = Set(1);
    const Partner across =
        Choose(hn::IfThenElse(even, right, left), hn::IfThenElse(even, plus, hn::Neg(plus)),
               hn::IfThenElse(even, left, right), b.z);
    const Partner down =
        y % 2 == 0 ? Choose(lower, plus, upper, b.z) : Choose(upper, hn::Neg(plus), lower, b.z);

    const F p = hn::Mul(across.z, Set(task.a_x)), q = hn::Mul(down.z, Set(task.a_y));
    const F slope_x = hn::Div(hn::Mul(across.step, hn::Sub(across.z, b.z)), p);
    const F slope_y = hn::Div(hn::Mul(down.step, hn::Sub(down.z, b.z)), q);
    const F m_z = hn::Add(hn::Add(Set(1), hn::Mul(slope_x, b.s_x)), hn::Mul(slope_y, b.s_y));
    const F squared = hn::Add(hn::Add(hn::Mul(slope_x, slope_x), hn::Mul(slope_y, slope_y)),
                              hn::Mul(m_z, m_z));
    const auto found =
        hn::And(hn::And(hn::Ne(across.step, hn::Zero(df)), hn::Ne(down.step, hn::Zero(df))),
                hn::And(hn::Gt(squared, hn::Zero(df)), hn::Lt(squared, Set(1e37f))));
    const F to_eye =
        hn::Sqrt(hn::Add(hn::Add(hn::Mul(b.s_x, b.s_x), hn::Mul(b.s_y, b.s_y)), Set(1)));
    const F length = hn::Sqrt(hn::IfThenElse(found, squared, Set(1)));
    b.n_x = hn::IfThenElse(found, hn::Div(hn::Neg(slope_x), length), hn::Div(b.s_x, to_eye));
    b.n_y = hn::IfThenElse(found, hn::Div(hn::Neg(slope_y), length), hn::Div(b.s_y, to_eye));
    b.n_z = hn::IfThenElse(found, hn::Div(m_z, length), hn::Div(Set(1), to_eye));
    if (task.steepest_area > 0) {
        const F pixel = Set(-task.a_x * task.a_y);
        const F area = hn::Mul(
            hn::Mul(hn::Mul(hn::Div(across.z, b.z), hn::Div(down.z, b.z)), pixel), length);
        const auto steep = hn::And(found, hn::Gt(area, Set(task.steepest_area)));
        b.open = hn::Max(b.open, FromMask(steep));
    }
}

void GivenNormals(const ObscuranceTask& task, int x, int y, Block& b) {
    const Floats df;
    const int lanes = int(hn::Lanes(df)), there = std::min(lanes, task.width - x);
    const Vec3f* from = &(*task.normals)(x, y);
    alignas(64) float n_x[16] = {}, n_y[16] = {}, n_z[16] = {};
    for (int i = 0; i < there; ++i) {
        n_x[i] = from[i].x();
        n_y[i] = from[i].y();
        n_z[i] = from[i].z();
    }
    const F X = hn::Load(df, n_x), Y = hn::Load(df, n_y), Z = hn::Load(df, n_z);
    const F squared = hn::Add(hn::Add(hn::Mul(X, X), hn::Mul(Y, Y)), hn::Mul(Z, Z));
    const auto sound = hn::Le(squared, Set(kMostNormal2));  // NaN is not
    b.n_x = hn::IfThenElseZero(sound, X);
    b.n_y = hn::IfThenElseZero(sound, Y);
    b.n_z = hn::IfThenElseZero(sound, Z);
}

/// What one tap adds to the sum.
inline F Term(const ObscuranceTask& task, F vv, F vn, F beta) {
    const F over = hn::Sub(vn, beta);
    const auto counts =
        hn::And(hn::Lt(vv, Set(task.most_vv)), hn::Gt(over, hn::Zero(Floats())));
    const F spread = hn::Add(vv, Set(task.epsilon));
    const F share = hn::Sub(Set(1), hn::Mul(vv, Set(task.per_r2)));
    F term = over;
    switch (task.options.sao.falloff) {
        case SaoFalloffKind::kEquation1:
        case SaoFalloffKind::kHpg12:
            term = hn::Div(over, spread);
            break;
        case SaoFalloffKind::kSmooth:
            term = hn::Div(hn::Mul(hn::Mul(share, share), hn::Mul(share, over)), spread);
            break;
        case SaoFalloffKind::kNoDivision:
            term = hn::Mul(share, over);
            break;
        case SaoFalloffKind::kLowContrast:
            break;
        case SaoFalloffKind::kHighQuality:
            term = hn::Div(hn::Mul(share, over), hn::Sqrt(spread));
            break;
    }
    return hn::IfThenElseZero(counts, term);
}

/// The sum of the taps' terms.
F SumOfTaps(const ObscuranceTask& task, const Block& b, const Rotation& rotation, F disc_px) {
    const Floats df;
    const Ints di;
    const TapOptions& options = task.options.taps;
    const bool sum_first = options.rounding == TapRounding::kSum;
    const bool border_point = options.outside == TapOutside::kBorderPoint;
    const F most_x = Set(float(task.width - 1)), most_y = Set(float(task.height - 1));
    const I log_first = hn::Set(di, 127 + options.log2_switch_px);
    const I coarsest = hn::Set(di, task.pyramid->Coarsest());
    const I pitch = hn::Set(di, task.pyramid->Pitch()),
            strip = hn::Set(di, task.pyramid->Strip());
    const I twice_span = hn::Set(di, 2 * task.pyramid->Span());
    const F s_n = hn::Add(hn::Add(hn::Mul(b.s_x, b.n_x), hn::Mul(b.s_y, b.n_y)), b.n_z);
    const F beta = hn::Sub(Set(task.bias), hn::Mul(b.z, Set(task.bias_per_depth)));
    F sum = hn::Zero(df);
    for (const TapInTable& tap : task.taps) {
        const F h = hn::Max(hn::Mul(Set(tap.alpha), disc_px), Set(float(options.min_tap_px)));
        const Turn u = rotation.Of(tap);  // [McGuire12 eq. 7]
        const F off_x = hn::Mul(h, u.cosine), off_y = hn::Mul(h, u.sine);
        const F met_x =
            sum_first ? hn::Trunc(hn::Add(b.x, off_x)) : hn::Add(b.x, hn::Trunc(off_x));
        const F met_y =
            sum_first ? hn::Trunc(hn::Add(b.y, off_y)) : hn::Add(b.y, hn::Trunc(off_y));
        const F t_x = hn::Min(hn::Max(met_x, hn::Zero(df)), most_x);
        const F t_y = hn::Min(hn::Max(met_y, hn::Zero(df)), most_y);

        // floor(log2 h) is the exponent of h. [McGuire12 eq. 9]
        const I exponent = hn::ShiftRight<23>(hn::BitCast(di, h));
        const I level = hn::Min(hn::Max(hn::Sub(exponent, log_first), hn::Zero(di)), coarsest);
        const I i = hn::ConvertTo(di, t_x) >> level, j = hn::ConvertTo(di, t_y) >> level;
        const I offset = hn::IfThenZeroElse(hn::Eq(level, hn::Zero(di)),
                                            hn::Sub(strip, twice_span >> level));
        const I index = hn::Add(hn::Add(hn::Mul(j, pitch), i), offset);
        const F z = hn::GatherIndex(df, task.pyramid->Data(), index);  // [McGuire12 eq. 10]

        F d_x = hn::Sub(border_point ? t_x : met_x, b.x);
        F d_y = hn::Sub(border_point ? t_y : met_y, b.y);
        if (options.place != TapPlace::kTexel) {
            F in_x = off_x, in_y = off_y;
            if (options.place == TapPlace::kLevelTexel) {
                const F size = hn::ConvertTo(df, hn::Set(di, 1) << level), half = Set(0.5f);
                const F c_x = hn::Mul(size, hn::Add(hn::ConvertTo(df, i), half));
                const F c_y = hn::Mul(size, hn::Add(hn::ConvertTo(df, j), half));
                in_x = hn::Sub(hn::Sub(c_x, half), b.x);
                in_y = hn::Sub(hn::Sub(c_y, half), b.y);
            }
            const auto inside = hn::And(hn::Eq(met_x, t_x), hn::Eq(met_y, t_y));
            d_x = hn::IfThenElse(inside, in_x, d_x);
            d_y = hn::IfThenElse(inside, in_y, d_y);
        }

        const F dz = hn::Sub(z, b.z);
        const F m_x = hn::Mul(z, hn::Mul(Set(task.a_x), d_x));
        const F m_y = hn::Mul(z, hn::Mul(Set(task.a_y), d_y));
        const F v_x = hn::Add(hn::Mul(dz, b.s_x), m_x), v_y = hn::Add(hn::Mul(dz, b.s_y), m_y);
        const F vv = hn::Add(hn::Add(hn::Mul(v_x, v_x), hn::Mul(v_y, v_y)), hn::Mul(dz, dz));
        const F vn =
            hn::Add(hn::Mul(dz, s_n), hn::Add(hn::Mul(m_x, b.n_x), hn::Mul(m_y, b.n_y)));
        sum = hn::Add(sum, Term(task, vv, vn, beta));
    }
    return sum;
}

/// A from the sum, as SaoFromMean has it.
F FromSum(const SaoParams& sao, F lacking) {
    const Floats df;
    const bool high_quality = sao.falloff == SaoFalloffKind::kHighQuality;
    const F A =
        hn::Max(hn::Zero(df), hn::Sub(Set(1), high_quality ? hn::Sqrt(lacking) : lacking));
    double power = 1;
    if (sao.falloff == SaoFalloffKind::kEquation1) power = sao.exponent;
    if (high_quality) power = sao.intensity;
    const bool lift =
        sao.lift_dark && !high_quality && sao.falloff != SaoFalloffKind::kEquation1;
    if (power == 1 && !lift) return A;
    alignas(64) float each[16];
    hn::Store(A, df, each);
    for (std::size_t k = 0; k < hn::Lanes(df); ++k) {
        const double a = each[k];
        each[k] =
            float(lift ? (std::pow(a, 0.2) + 1.2 * a * a * a * a) / 2.2 : std::pow(a, power));
    }
    return hn::Load(df, each);
}

F ObscureBlock(const ObscuranceTask& task, const float* row, int x, int y) {
    const Floats df;
    const TapOptions& taps = task.options.taps;
    Block b;
    b.x = hn::Add(hn::Iota(df, 0), Set(float(x)));
    b.y = Set(float(y));
    b.z = hn::LoadU(df, row + x);
    const auto sky = hn::Le(b.z, Set(GBuffer::kSkyZ));
    b.open = FromMask(sky);
    b.z = hn::IfThenElse(sky, Set(-1), b.z);
    const F half = Set(0.5f);
    b.s_x = hn::Add(hn::Mul(Set(task.a_x), hn::Add(b.x, half)), Set(task.b_x));
    b.s_y = hn::Add(hn::Mul(Set(task.a_y), hn::Add(b.y, half)), Set(task.b_y));
    if (task.normals == nullptr) {
        NormalsFromDepth(task, row, x, y, b);
    } else {
        GivenNormals(task, x, y, b);
    }
    // [McGuire12 eq. 5]
    const F disc_px = hn::Min(hn::Div(Set(-task.disc), b.z), Set(float(kWidestPx)));
    const Rotation rotation(task, x, y);
    F lacking = hn::Mul(SumOfTaps(task, b, rotation, disc_px), Set(task.per_tap));
    if (task.options.sao.falloff == SaoFalloffKind::kHighQuality) {
        const F facing = hn::Max(hn::Zero(df), hn::Mul(Set(1.5f), b.n_z));
        lacking = hn::Mul(lacking, hn::Add(Set(0.65f), hn::Mul(Set(0.35f), facing)));
    }
    F A = FromSum(task.options.sao, lacking);
    if (taps.min_radius_px > 0) {
        const F least = Set(float(taps.min_radius_px));
        const F in = hn::Min(hn::Max(hn::Sub(disc_px, least), hn::Zero(df)), Set(1));
        A = hn::Add(Set(1), hn::Mul(hn::Sub(A, Set(1)), in));
    }
    return hn::Max(A, b.open);
}

void Tile(const ObscuranceTask& task, const PixelRect& where, Image<float>& A) {
    const Floats df;
    const int lanes = int(hn::Lanes(df));
    alignas(64) float block[16];
    for (int y = where.y0; y < where.y1; ++y) {
        const float* row = task.pyramid->Data() + std::ptrdiff_t(y) * task.pyramid->Pitch();
        float* to = &A(0, y);
        for (int x = where.x0; x < where.x1; x += lanes) {
            const F a = ObscureBlock(task, row, x, y);
            if (x + lanes <= where.x1) {
                hn::StoreU(a, df, to + x);
            } else {
                hn::Store(a, df, block);
                std::copy(block, block + (where.x1 - x), to + x);
            }
        }
    }
}

}  // namespace
}  // namespace plumb::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace plumb {
namespace {

HWY_EXPORT(Tile);

}  // namespace

void ObscureTile(const ObscuranceTask& task, const PixelRect& where, Image<float>& A) {
    HWY_DYNAMIC_DISPATCH(Tile)(task, where, A);
}

}  // namespace plumb

#endif
