// Quantiles of how wrong the pixels of a picture are.
//
//       Q(p)         the least v that a share p of the |c - t| does not exceed
//       interval     [Q(p - h), Q(p + h)],  h the half width of the interval of the share of
//                    |c - t| <= Q(p) over the tiles (score/over_tiles.h)              [Woodruff52]
//
//       Q_w(p)       the least v at which the values up to v add up to more than p times the
//                    sum of all: each value counts as often as it is large
//
// Source   [Woodruff52] R. Woodruff, Confidence Intervals for Medians and Other Position
//          Measures, Journal of the American Statistical Association 47, 1952. Q_w:
//          [Andersson20] section 5, for maps of FLIP.
// Symbols  c candidate, t measured truth.
// Beware   The truth's noise makes |c - t| larger and is not taken off: below a few of its standard
//          errors these are quantiles of the noise.
#pragma once

#include <span>
#include <vector>

#include "score/errors.h"
#include "score/over_tiles.h"

namespace plumb {

/// Q of each share in (0, 1], over all channels of the pixels that count, with its interval and
/// no standard error. NaN where none counts. Throws Error as ScoreErrors.
std::vector<Measured> AbsoluteErrorQuantiles(ChannelSpan candidate, ChannelSpan truth,
                                             std::span<const double> shares,
                                             const Mask& mask = {},
                                             const ErrorOptions& options = {});

/// Q_w of a map of numbers >= 0, over the pixels of `mask` (empty: all). 0 if all are 0, NaN if
/// there are none.
std::vector<double> WeightedQuantiles(const Image<float>& map, std::span<const double> shares,
                                      const Mask& mask = {});

/// The same of a map in [0, 1] as the published FLIP program gives it: from a histogram of 100
/// bins, straight within a bin.
std::vector<double> BinnedWeightedQuantiles(const Image<float>& map,
                                            std::span<const double> shares,
                                            const Mask& mask = {});

}  // namespace plumb
