// The figures of several views of a scene as one, with the scatter between views.
//
//       mean          m = 1/n Sum x_v,     se^2 = 1/(n (n - 1)) Sum (x_v - m)^2
//                     m +- t se                         t of n - 1 degrees of freedom
//       mean square   m exp(+- t se / m)                the same, in its logarithm
//
// Every view counts alike, however many pixels of it show a surface. RMSE and PSNR are those of the
// mean of the views' MSE. An MSE cannot be negative: with three views, of which t is 4.3, the plain
// interval would often say that it may be.
//
// Tiles of one picture (score/over_tiles.h) tell what another picture of the same kind of surface would
// show. Another camera sees other surfaces from other distances, so that the scatter between views
// is the greater one, and the one that tells of a scene.
//
// Source   Student's t; the logarithm: the delta method, e.g. [Kish65].
// Symbols  x_v the figure of view v, n views.
// Domain   One view keeps its own interval, that of its tiles.
// Beware   Cameras that someone chose are no random views: the interval is what they would say if
//          they were. `noise_error` is that of the mean.
#pragma once

#include <span>

#include "score/errors.h"
#include "score/over_tiles.h"

namespace plumb {

Measured MeanOverViews(std::span<const Measured> views, double confidence = 0.95);

/// Of mean squares.
Measured MeanSquareOverViews(std::span<const Measured> views, double confidence = 0.95);

/// Of root mean squares: the root of the mean of their squares.
Measured RootMeanSquareOverViews(std::span<const Measured> views, double confidence = 0.95);

/// All figures. Pixels and tiles are added up; `max` is the greatest, at its own place.
ErrorScore ScoreOverViews(std::span<const ErrorScore> views, double confidence = 0.95);

}  // namespace plumb
