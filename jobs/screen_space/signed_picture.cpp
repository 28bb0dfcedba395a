#include "jobs/screen_space/signed_picture.h"

#include <algorithm>
#include <cmath>

namespace plumb {
namespace {

// Linear colours; red and blue that people with any colour vision tell apart.
constexpr Rgb kTooDark{0.0F, 0.13F, 0.45F}, kTooBright{0.63F, 0.09F, 0.0F},
    kSkyGrey{0.5F, 0.5F, 0.5F};

}  // namespace

Image<Rgb> SignedPicture(const Image<float>& A, const Image<float>& truth, const Mask& seen) {
    Image<Rgb> picture(A.Width(), A.Height(), kSkyGrey);
    for (std::size_t p = 0; p < picture.Pixels().size(); ++p) {
        if (seen.Pixels()[p] == 0) continue;
        const double d = (double(A.Pixels()[p]) - truth.Pixels()[p]) / kSignedScale;
        const float share = float(std::min(1.0, std::abs(d)));
        const Rgb& end = d < 0 ? kTooDark : kTooBright;
        for (std::size_t c = 0; c < 3; ++c) picture.Pixels()[p][c] = 1 + share * (end[c] - 1);
    }
    return picture;
}

}  // namespace plumb
