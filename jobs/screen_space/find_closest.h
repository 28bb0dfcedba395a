// Which of several pictures is closest to the truth, and which are not told apart from it.
//
//       winner   the least mean over the views of its MSE
//       tie      the 95 % interval of  D = MSE - MSE of the winner   holds 0           of one view
//                that of the mean over views of  D / (half the sum of both MSE)  does   of several
//
// D is paired: the same pixels, the same noise of the truth (CompareMse). Of one view the interval is
// that of its tiles, of several that between views, Student's t (score/over_views.h). There it is
// of shares, because views err by different amounts: a technique with half the MSE in every view is
// told apart, however much darker one of them is.
//
// Beware   With three views t is 4.3: much is a tie, and more cameras tell more apart.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/image.h"
#include "jobs/truth/view_truth.h"
#include "score/over_tiles.h"

namespace plumb {

/// The technique or setting with the least MSE, and those that are not told apart from it: the
/// interval of the difference in MSE, paired view by view and pixel by pixel, holds 0.
struct Closest {
    std::string name;
    std::vector<std::string> ties;
};

/// What all are compared with in one view.
struct ComparedView {
    const TruthImage* truth;
    const Mask* mask;
};

struct Contestant {
    std::string name;
    std::vector<Image<float>> pictures;  ///< One a view.
};

/// Needs a contestant and a view.
Closest FindClosest(std::span<const Contestant> contestants,
                    std::span<const ComparedView> views);

/// The names of those that are not told apart from contestant `winner`.
std::vector<std::string> TiesOf(std::size_t winner, std::span<const Contestant> contestants,
                                std::span<const ComparedView> views);

}  // namespace plumb
