#include "jobs/score/score_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/names.h"
#include "io/content_hash.h"
#include "jobs/score/error_maps.h"
#include "jobs/score/like_tool.h"
#include "jobs/score/limits.h"
#include "jobs/score/rank.h"
#include "jobs/score/score_sections.h"
#include "jobs/write_results.h"

namespace plumb {
namespace {

PictureFile ReadNamed(const std::string& text, const std::string& channel) {
    PictureName name = ParsePictureName(text);
    if (name.channel.empty()) name.channel = channel;
    return ReadPictureToScore(name);
}

std::vector<Limit> LimitsOf(const ScoreJob& job) {
    std::vector<Limit> limits;
    for (const std::string& text : job.fail_under)
        limits.push_back(ParseLimit(text, "--fail-under", true));
    for (const std::string& text : job.fail_over)
        limits.push_back(ParseLimit(text, "--fail-over", false));
    return limits;
}

/// Files of one name are told apart by the folders that they lie in, else by their number.
void TellApart(std::vector<PictureFile>& files) {
    const auto count = [&](const std::string& label) {
        return std::ranges::count(files, label, &PictureFile::label);
    };
    std::vector<std::string> labels;
    for (const PictureFile& file : files) {
        const std::string folder = file.name.path.parent_path().filename().string();
        const bool twice = count(file.label) > 1 && !folder.empty();
        labels.push_back((twice ? folder + "/" : "") + file.label);
    }
    for (std::size_t k = 0; k < files.size(); ++k) files[k].label = labels[k];
    for (std::size_t k = 0; k < files.size(); ++k) {
        if (std::ranges::count(labels, labels[k]) > 1)
            files[k].label += " (" + std::to_string(k + 1) + ")";
    }
}

}  // namespace

ScoreResult ScorePictures(const ScoreJob& job, const RunContext& run) {
    const std::vector<Limit> limits = LimitsOf(job);
    for (const std::string& tool : job.like) PlaceOf(tool, kLikeNames, "--like " + tool);
    if (!(job.figures.peak > 0 && std::isfinite(job.figures.peak)))
        throw Error(MustBe("--peak", job.figures.peak, "> 0 and finite"));
    const double ppd = job.figures.pixels_per_degree;
    if (!(ppd >= 1 && ppd <= 1000))
        throw Error(MustBe("--pixels-per-degree", ppd, "in [1, 1000]"));

    doc::Document document{.kind = "score", .title = {}, .provenance = doc::ProvenanceOf(run)};
    std::vector<PictureFile> candidates;
    for (const std::string& text : job.candidates)
        candidates.push_back(ReadNamed(text, job.channel));
    candidates.push_back(ReadNamed(job.reference, job.channel));
    TellApart(candidates);
    const PictureFile reference = std::move(candidates.back());
    candidates.pop_back();
    const auto remember = [&](const PictureFile& file) {
        document.provenance.inputs.push_back(
            {file.name.path.filename().string(), Sha256HexOfFile(file.name.path)});
    };
    for (const PictureFile& file : candidates) remember(file);
    remember(reference);

    const Compared compared = Compare(candidates, reference, job.compare);
    const bool hdr = job.figures.flip == FlipMode::kHdr ||
                     (job.figures.flip == FlipMode::kByFile && reference.is_float &&
                      reference.channels.size() == 3);
    std::vector<CandidateScore> scores;
    std::vector<double> mse;
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        run.monitor.Progress("score", double(k) / double(candidates.size()));
        scores.push_back(ScoreCandidate(compared, k, hdr, job.figures));
        mse.push_back(scores.back().errors.mse.value);
    }
    const Ranking ranking = Rank(compared, mse, job.figures.errors);

    ScoreResult result;
    document.title = candidates.size() == 1
                         ? scores[0].name + " against " + compared.reference.name
                         : std::to_string(candidates.size()) + " pictures against " +
                               compared.reference.name;
    document.sections.push_back(VerdictSection(scores, ranking));
    if (!limits.empty()) {
        document.sections.push_back({.id = "limits", .title = "Limits"});
        document.sections.back().tables.push_back(LimitTable(limits, scores, result.failures));
    }
    if (!job.like.empty()) {
        document.sections.push_back({.id = "like", .title = "Other programs' figures"});
        for (const std::string& tool : job.like)
            document.sections.back().tables.push_back(LikeTable(tool, candidates, reference));
    }
    document.sections.push_back(FiguresSection(scores, compared));
    if (scores.size() > 1) document.sections.push_back(PairsSection(scores, ranking));
    document.sections.push_back(MethodSection(scores, compared, hdr, job.figures));
    if (job.maps) {
        doc::Section maps{.id = "maps", .title = "Where"};
        for (std::size_t k = 0; k < scores.size(); ++k) {
            const std::string name =
                std::to_string(k + 1) + "_" +
                FileNamePart(candidates[k].name.path.stem().string() +
                             (candidates[k].name.channel.empty() ? "" : " ") +
                             candidates[k].name.channel);
            for (doc::Picture& picture :
                 WriteErrorMaps(run.folder, name, compared, k, scores[k]))
                maps.pictures.push_back(std::move(picture));
        }
        document.sections.push_back(std::move(maps));
    }
    result.document = std::move(document);
    return result;
}

}  // namespace plumb
