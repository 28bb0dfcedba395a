// Where a candidate is wrong, as pictures for eyes and as numbers.
//
//       signed    c - t, mean of the channels: blue too dark, red too bright, white right; one
//                 fixed scale (jobs/screen_space/signed_picture.h)
//       FLIP      black 0, violet, orange, pale yellow 1: the usual map, magma
//
// What does not count is grey in both.
#pragma once

#include <filesystem>
#include <string>

#include "jobs/score/compared.h"
#include "jobs/score/score_candidate.h"
#include "reports/document.h"

namespace plumb {

/// Linear, for previews.
Image<Rgb> FlipPicture(const Image<float>& map, const Mask& mask);

/// Mean of the channels.
Image<float> MeanOfChannels(const Channels& channels);

/// Writes NAME_signed.png, NAME_flip.png (if there is one) and NAME.exr (the channels error or
/// error.R ..., and flip) to `folder`; returns the pictures for a document.
std::vector<doc::Picture> WriteErrorMaps(const std::filesystem::path& folder,
                                         const std::string& name, const Compared& compared,
                                         std::size_t candidate, const CandidateScore& score);

}  // namespace plumb
