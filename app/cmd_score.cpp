// plumb score: pictures against a reference.
//
// Options -> struct -> call -> print.
#include <map>
#include <memory>
#include <string>

#include "app/command.h"
#include "app/process.h"
#include "core/error.h"
#include "core/names.h"
#include "jobs/score/like_tool.h"
#include "jobs/score/score_pictures.h"

namespace plumb::app {
namespace {

struct Options {
    std::vector<std::string> files;
    std::vector<int> crop;
    ScoreJob job;
    bool no_maps = false;
    Common common{.out = "out/score"};
};

template <class T>
CLI::Option* AddChoice(CLI::App& command, const std::string& flag, T& value,
                       const std::map<std::string, T>& choices, const std::string& help) {
    return command.add_option(flag, value, help)->transform(CLI::CheckedTransformer(choices));
}

void Run(Options o) {
    if (o.files.size() < 2) {
        throw Error("score needs at least two files, the reference last; only " +
                    o.files.front() + " was given");
    }
    const auto monitor = MakeMonitor(o.common);
    o.job.reference = o.files.back();
    o.files.pop_back();
    o.job.candidates = o.files;
    o.job.maps = !o.no_maps;
    if (!o.crop.empty())
        o.job.compare.crop = Rectangle{o.crop[0], o.crop[1], o.crop[2], o.crop[3]};
    const ScoreResult result = ScorePictures(o.job, ContextOf(o.common, *monitor));
    Publish(result.document, o.common);
    if (!result.failures.empty()) throw CheckFailed(Joined(result.failures, "\n"));
}

void Add(CLI::App& program) {
    auto o = std::make_shared<Options>();
    CLI::App* command = program.add_subcommand(
        "score",
        "Compare pictures with a reference, the last file: errors, PSNR, SSIM, FLIP, each with "
        "its\n"
        "uncertainty; which is closest, and which cannot be told apart. About 0.5 s a "
        "megapixel.\n"
        "Examples: plumb score mine.png reference.png\n"
        "          plumb score a.exr:V b.exr:V truth.exr:V --region seen\n"
        "          plumb score new.png old.png --fail-under psnr=40 --fail-over flip=0.05");
    command
        ->add_option("files", o->files,
                     "Candidates, then the reference: PNG, TIFF, EXR, PFM or HDR; FILE:NAME "
                     "chooses a channel or a layer")
        ->required();
    command->add_option("--channel", o->job.channel,
                        "Channel or layer of every file that names none of its own");
    AddChoice<Encoding>(*command, "--encoding", o->job.compare.encoding,
                        {{"srgb", Encoding::kSrgb}, {"linear", Encoding::kLinear}},
                        "What integers are: srgb or linear");
    AddChoice<BadPixels>(*command, "--bad-pixels", o->job.compare.bad,
                         {{"refuse", BadPixels::kRefuse}, {"skip", BadPixels::kSkip}},
                         "Pixels that are not finite: refuse (the default) or skip");
    command->add_option("--mask", o->job.compare.mask,
                        "A picture: what is not 0 counts; FILE or FILE:NAME");
    command->add_option("--crop", o->crop, "X Y WIDTH HEIGHT: this part alone, in pixels")
        ->expected(4);
    command->add_option("--region", o->job.compare.region,
                        "Part of a truth with depth_m: " + Joined(kRegionNames));
    AddChoice<FlipMode>(
        *command, "--flip", o->job.figures.flip,
        {{"ldr", FlipMode::kLdr}, {"hdr", FlipMode::kHdr}, {"none", FlipMode::kNone}},
        "ldr, hdr or none; without it hdr for colours of floats, else ldr");
    command
        ->add_option("--pixels-per-degree", o->job.figures.pixels_per_degree,
                     "Of the field of view, for FLIP")
        ->capture_default_str();
    AddChoice<ToneCurve>(*command, "--tone", o->job.figures.curve,
                         {{"aces", ToneCurve::kAces},
                          {"hable", ToneCurve::kHable},
                          {"reinhard", ToneCurve::kReinhard}},
                         "Curve of FLIP for high dynamic range: aces, hable or reinhard");
    command->add_option("--peak", o->job.figures.peak, "Peak of PSNR")->capture_default_str();
    command->add_option(
        "--like", o->job.like,
        "Other programs' figures too, as they define them: " + Joined(kLikeNames));
    command->add_option(
        "--fail-under", o->job.fail_under,
        "FIGURE=NUMBER: status 1 where it is less. Figures: " + Joined(FigureKeys()));
    command->add_option("--fail-over", o->job.fail_over,
                        "FIGURE=NUMBER: status 1 where it is greater");
    command->add_flag("--no-maps", o->no_maps, "No error maps");
    AddCommon(*command, o->common);
    command->callback([o] { Run(*o); });
}

const Listed kListed("", 45, Add);

}  // namespace
}  // namespace plumb::app
