// plumb score: how far pictures are from a reference, which one is closest, and whether they pass.
#pragma once

#include <string>
#include <vector>

#include "core/run_context.h"
#include "jobs/score/compared.h"
#include "jobs/score/score_candidate.h"
#include "reports/document.h"

namespace plumb {

struct ScoreJob {
    std::vector<std::string> candidates = {};  ///< FILE or FILE:CHANNEL, at least one.
    std::string reference = {};
    std::string channel = {};  ///< Of every file that names none of its own.
    CompareOptions compare = {};
    FigureOptions figures = {};
    std::vector<std::string> like = {};        ///< Other programs, of kLikeNames.
    std::vector<std::string> fail_under = {};  ///< "psnr=40": fails where it is less.
    std::vector<std::string> fail_over = {};   ///< "flip=0.05"
    bool maps = true;                          ///< Writes error maps to the folder.
};

struct ScoreResult {
    doc::Document document;
    std::vector<std::string> failures;  ///< "b.png: flip = 0.07, must be <= 0.05"
};

/// Throws Error naming file or flag, value and rule. Writes nothing before all is computed.
ScoreResult ScorePictures(const ScoreJob& job, const RunContext& run);

}  // namespace plumb
