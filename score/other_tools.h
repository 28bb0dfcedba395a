// The figures of other programs, as those programs define them, for a history that must not break.
//
//       idiff    RMS over all channels, alpha too; PSNR = 20 log10( max(1, m) / RMS ), m the largest
//                absolute value of either picture: the peak is 1 only where nothing is brighter
//       pbrt     imgtool diff: MAE, MSE and MRSE = mean (c - t)^2 / (t + 0.01)^2; infinities are 0
//                before, and a term that is not finite counts as 0
//       falcor   ImageCompare: "rmse" is mean (c - t)^2 / (c^2 + 0.001), relative to its first
//                picture; "mae" is mean |(c - t)^2|, which is its mse; "mape" is
//                100 mean |(c - t) / (c + 0.001)|
//
// Source   the programs: OpenImageIO's compare of 2026, pbrt-v4's imgtool, Falcor's ImageCompare.
//          FLIP's own program and OpenImageIO's FLIP_diff: score/flip.h with their settings.
// Symbols  c candidate, t reference, per channel.
// Domain   Numbers as the program reads them: integers over their greatest, no sRGB decoded.
// Beware   Falcor's first picture is taken to be the candidate: swap the files on the command line
//          where your script has them the other way.
#pragma once

#include "score/errors.h"

namespace plumb {

struct IdiffFigures {
    double mean = 0, rms = 0, psnr_db = 0;  ///< psnr_db is infinite for equal pictures.
    double max = 0;
    double peak = 1;  ///< max(1, m)
};

/// NaN equals NaN and infinity infinity; where only one is so, all figures are infinite or NaN.
IdiffFigures FiguresOfIdiff(ChannelSpan candidate, ChannelSpan reference);

struct PbrtFigures {
    double mae = 0, mse = 0, mrse = 0;
};
PbrtFigures FiguresOfPbrt(ChannelSpan candidate, ChannelSpan reference);

struct FalcorFigures {
    double mse = 0, rmse = 0, mae = 0, mape = 0;
};
FalcorFigures FiguresOfFalcor(ChannelSpan candidate, ChannelSpan reference);

}  // namespace plumb
