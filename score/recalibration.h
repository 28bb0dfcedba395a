// What is left of a technique's error after the best change of its contrast.
//
//       f* = the rising f that minimizes mean (f(c) - t)^2,       RMSE* = sqrt mean (f*(c) - T)^2
//
// A technique that orders all pixels rightly but is too dark or too soft has a small RMSE*: a
// curve would mend it. What RMSE* still shows is wrong shape, which no curve mends.
//
// f* is fitted to the very pixels that it is scored on, noise included, so that the score of
// the fit itself is too good: by about 2 sigma^2 levels / pixels for noise of variance
// sigma^2, the levels being the degrees of freedom of the fit [Meyer00], and by more where
// errors of neighbours are alike. So the picture's tiles are dealt into five folds, each
// spread over the whole picture, and every fold is recalibrated by the f of the other four:
// `held_out` is too bad instead, if anything. The truth lies between the two.
//
// Source   [Ayer55], see score/monotone.h; [Meyer00] M. Meyer, M. Woodroofe, On the Degrees of
//          Freedom in Shape-Restricted Regression, Annals of Statistics 28(4), 2000.
// Beware   The interval of `held_out` is that of a fit as it was made: it does not contain
//          what another draw of pixels would have changed in f.
#pragma once

#include "core/image.h"
#include "score/errors.h"
#include "score/monotone.h"
#include "score/over_tiles.h"

namespace plumb {

struct RecalibrationScore {
    MonotoneMap map;  ///< f*, of all pixels that count.
    ErrorScore fitted, held_out;
    Image<float> picture;  ///< What held_out scores: each fold by the f of the others.
};

/// As ScoreErrors, of f*(c). Where fewer than five tiles count, held_out has no pixels.
RecalibrationScore ScoreRecalibrated(const Image<float>& candidate, const Image<float>& truth,
                                     const Image<float>& standard_error = {},
                                     const Mask& mask = {}, const ErrorOptions& options = {});

}  // namespace plumb
