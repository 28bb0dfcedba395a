// What RunSao tells of its passes, kept: the picture after each of them.
#pragma once

#include <string>
#include <vector>

#include "screen_space/sao/sao_passes.h"

namespace plumb {

/// A of the drawn size after each pass; of one that is off, what it got.
struct SaoPictures {
    Image<float> raw, quad, packed, blur_x, blur_y;
    std::vector<std::string> told;  ///< The names, in order.
};

inline SaoPictures PicturesOf(const GBuffer& gbuffer, const SaoOptions& options) {
    SaoPictures pictures;
    SaoScratch scratch;
    RunSao(gbuffer, options, scratch, [&](std::string_view pass, const Image<float>& A) {
        pictures.told.emplace_back(pass);
        if (pass == "sample") pictures.raw = A;
        if (pass == "sample" || pass == "quads") pictures.quad = A;
        if (pass == "pack" || pass == "key") pictures.packed = pictures.blur_x = A;
        if (pass == "blur x") pictures.blur_x = A;
        if (!A.Empty()) pictures.blur_y = A;
    });
    return pictures;
}

}  // namespace plumb
