// The figures of another program, by its name, as rows of a table.
//
//       idiff       OpenImageIO: mean, RMS, PSNR, max over all channels, colours times alpha
//       pbrt        imgtool diff: MAE, MSE, MRSE; integers decoded from sRGB; FLIP of [0, 1]
//       falcor      ImageCompare: mse, rmse, mae, mape of R, G and B
//       flip        NVIDIA's program: mean, weighted median and quartiles from 100 bins, min, max; HDR
//                   with ACES for floats, else LDR
//       oiio-flip   FLIP_diff: HDR with ACES and an assumed maximum of 2 and median of 0.18
//
// Formulas: score/other_tools.h, score/flip.h. Whole pictures: these programs know no mask.
#pragma once

#include <string>
#include <vector>

#include "jobs/score/picture_file.h"
#include "reports/document.h"

namespace plumb {

inline const std::vector<std::string> kLikeNames{"idiff", "pbrt", "falcor", "flip",
                                                 "oiio-flip"};

/// A table "like_idiff" ...: a row for each candidate and figure. Throws Error for a name that is none
/// of the above.
doc::Table LikeTable(const std::string& tool, const std::vector<PictureFile>& candidates,
                     const PictureFile& reference);

}  // namespace plumb
