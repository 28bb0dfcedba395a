// Errors relative to the brightness where they are made, in the forms that are in use.
//
//       kSquareOverSquare   mean (d^2 - s^2) / (t^2 + eps)
//       kSquareOverShifted  mean (d^2 - s^2) / (t + eps)^2
//       kOverShifted        mean |d| / (|t| + eps)
//       kSymmetric          mean 2 |d| / (|c| + |t| + eps)
//
// A dark corner that is off by its own brightness weighs as much as a lamp that is. The same name
// stands for different forms and different eps in different programs, so that a figure means
// nothing without both: RelativeForms() lists those that are known, with their users.
//
// Source   relMSE: [Rousselle11] F. Rousselle, C. Knaus, M. Zwicker, Adaptive Sampling and
//          Reconstruction using Greedy Error Minimization, ACM Transactions on Graphics 30(6),
//          2011, with eps = 0.01; the others: the programs that they are named for.
// Symbols  d = c - t; c candidate, t measured truth, s its standard error; per channel.
// Beware   s^2 is taken off above, not below: what noise does to the denominator is left, of second
//          order in s / t. Of the forms in |d| none is taken off. Where t + eps is 0 (a negative
//          t) kSquareOverShifted is not finite, as in the program that it comes from.
#pragma once

#include <string>
#include <vector>

#include "score/errors.h"
#include "score/over_tiles.h"

namespace plumb {

enum class RelativeKind { kSquareOverSquare, kSquareOverShifted, kOverShifted, kSymmetric };

struct RelativeForm {
    std::string key;      ///< "relmse"; [a-z0-9_]
    std::string formula;  ///< "d^2 / (t^2 + 0.01)", its constant included.
    std::string users;    ///< Who calls it what.
    RelativeKind kind;
    double epsilon;  ///< > 0
};

/// relmse first.
const std::vector<RelativeForm>& RelativeForms();

/// Over all channels of the pixels that count. Throws Error as ScoreErrors.
Measured ScoreRelative(const RelativeForm& form, ChannelSpan candidate, ChannelSpan truth,
                       ChannelSpan standard_error = {}, const Mask& mask = {},
                       const ErrorOptions& options = {});

}  // namespace plumb
