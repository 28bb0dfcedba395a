// The scores as sections of a document.
#pragma once

#include <vector>

#include "jobs/score/compared.h"
#include "jobs/score/rank.h"
#include "jobs/score/score_candidate.h"
#include "reports/document.h"

namespace plumb {

/// Who is closest, and the figures by which people choose.
doc::Section VerdictSection(const std::vector<CandidateScore>& scores, const Ranking& ranking);

/// Every figure, with its uncertainty.
doc::Section FiguresSection(const std::vector<CandidateScore>& scores,
                            const Compared& compared);

/// Every pair's difference. No tables for one candidate.
doc::Section PairsSection(const std::vector<CandidateScore>& scores, const Ranking& ranking);

/// What was compared, and how: encoding, pixels, noise, exposures.
doc::Section MethodSection(const std::vector<CandidateScore>& scores, const Compared& compared,
                           bool hdr_flip, const FigureOptions& options);

}  // namespace plumb
