#include "jobs/score/score_pictures.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/intervals.h"
#include "io/image_io.h"
#include "reports/render.h"
#include "tests/io/temp_folder.h"
#include "tests/score/flip_answers.h"
#include "tests/score/made_images.h"

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

class Scores : public TempFolder {
  protected:
    std::string Exr(const std::string& name, const Image<float>& value,
                    const Image<float>& error = {}) {
        std::vector<NamedChannel> channels{{"V", value}};
        if (!error.Empty()) channels.push_back({"V.error", error});
        WriteExr(Path(name), channels);
        return Path(name).string();
    }

    ScoreResult Score(ScoreJob job) { return ScorePictures(job, {.folder = Path("out")}); }

    static double At(const ScoreResult& result, const char* table, std::size_t row,
                     const char* column) {
        return doc::NumberOf(doc::TableOf(result.document, table).At(row, column));
    }
    static std::string TextAt(const ScoreResult& result, const char* table, std::size_t row,
                              const char* column) {
        const doc::Cell& cell = doc::TableOf(result.document, table).At(row, column);
        const auto* text = std::get_if<std::string>(&cell);
        return text ? *text : "";
    }
};

Image<float> Smooth() {
    return MadeImage<float>(64, 48, [](int i, int j) { return 0.3 + 0.004 * i + 0.003 * j; });
}

Image<float> Plus(Image<float> image, double offset, const Image<float>& noise = {}) {
    for (std::size_t p = 0; p < image.Pixels().size(); ++p) {
        const double n = noise.Empty() ? 0 : noise.Pixels()[p];
        image.Pixels()[p] = float(image.Pixels()[p] + offset + n);
    }
    return image;
}

Image<float> Times(Image<float> image, float factor) {
    for (float& value : image.Pixels()) value *= factor;
    return image;
}

// An offset of 1/32, exact in float where sums are: bias, MAE, RMSE, every quantile and the worst
// tile are it; PSNR = 20 log10(32).
TEST_F(Scores, OfAnOffsetByHand) {
    const Image<float> flat(64, 48, 0.5F);
    const ScoreResult result = Score(
        {.candidates = {Exr("c.exr", Plus(flat, 1 / 32.0))}, .reference = Exr("t.exr", flat)});
    EXPECT_DOUBLE_EQ(At(result, "errors", 0, "bias"), 0.03125);
    EXPECT_DOUBLE_EQ(At(result, "errors", 0, "mae"), 0.03125);
    EXPECT_DOUBLE_EQ(At(result, "scores", 0, "rmse"), 0.03125);
    EXPECT_NEAR(At(result, "scores", 0, "psnr"), 30.102999566, 1e-8);
    EXPECT_DOUBLE_EQ(At(result, "quantiles", 0, "p50"), 0.03125);
    EXPECT_DOUBLE_EQ(At(result, "worst_tile", 0, "rmse"), 0.03125);
    EXPECT_EQ(At(result, "worst_tile", 0, "tiles"), 4);
    // Of greys d = |L1 - L2|^0.7 below 0.4 of its limit 41.276096, no features.
    const double L = 116 * (std::cbrt(0.53125) - std::cbrt(0.5));
    EXPECT_NEAR(At(result, "scores", 0, "flip"), 0.95 * std::pow(L, 0.7) / (0.4 * 41.276096),
                1e-6);
    EXPECT_NEAR(At(result, "scores", 0, "ssim"),
                (2 * 0.53125 * 0.5 + 1e-4) / (0.53125 * 0.53125 + 0.25 + 1e-4), 1e-6);
    EXPECT_NEAR(At(result, "relative", 0, "value"), 0.03125 * 0.03125 / 0.26, 1e-9);
    EXPECT_THAT(result.failures, IsEmpty());
}

TEST_F(Scores, WritesMapsAndADocumentOfItsSchema) {
    const ScoreResult result = Score({.candidates = {Exr("c.exr", Plus(Smooth(), 0.1))},
                                      .reference = Exr("t.exr", Smooth())});
    EXPECT_TRUE(std::filesystem::exists(Path("out/1_c_signed.png")));
    EXPECT_TRUE(std::filesystem::exists(Path("out/1_c_flip.png")));
    const std::vector<NamedChannel> maps = ReadChannels(Path("out/1_c.exr"));
    ASSERT_EQ(maps.size(), 2u);
    EXPECT_EQ(maps[0].name, "error");
    EXPECT_NEAR(maps[0].pixels(5, 5), 0.1, 1e-6);
    EXPECT_THAT(doc::ToHtml(result.document), HasSubstr("data:image/png"));
    EXPECT_EQ(result.document.provenance.inputs.size(), 2u);
    const ScoreResult none = Score({.candidates = {Path("c.exr").string()},
                                    .reference = Path("t.exr").string(),
                                    .maps = false});
    EXPECT_EQ(doc::ToCsv(none.document), doc::ToCsv(result.document));
}

// A truth with noise of 0.05 and standard errors that say so; the candidate is off by 0.02. The
// plain MSE would be 0.0004 + 0.0025.
TEST_F(Scores, TakeOffTheNoiseOfATruth) {
    const Image<float> noise = Times(CorrelatedNoise(64, 48, 1, 3, 0), 0.05F);
    const Image<float> truth = Plus(Smooth(), 0, noise), s(64, 48, 0.05F);
    const ScoreResult result = Score({.candidates = {Exr("c.exr", Plus(Smooth(), 0.02))},
                                      .reference = Exr("t.exr", truth, s),
                                      .channel = "V"});
    const auto& mse = std::get<Measured>(doc::TableOf(result.document, "errors").At(0, "mse"));
    EXPECT_NEAR(mse.value, 0.0004, 5 * mse.noise_error);
    EXPECT_LT(mse.value, 0.001);
    EXPECT_GT(mse.noise_error, 0);
    EXPECT_NEAR(doc::NumberOf(doc::FactOf(result.document, "reference_rms_error")), 0.05, 1e-6);
}

// b and c differ in their noise alone, and tie; a is better than both, by far more than that.
TEST_F(Scores, RankAndNameTies) {
    const auto noisy = [&](double size, std::uint64_t seed) {
        return Plus(Smooth(), 0, Times(CorrelatedNoise(64, 48, 1, seed, 0), float(size)));
    };
    const ScoreResult result =
        Score({.candidates = {Exr("b.exr", noisy(0.05, 1)), Exr("a.exr", noisy(0.01, 2)),
                              Exr("c.exr", noisy(0.05, 3))},
               .reference = Exr("t.exr", Smooth())});
    EXPECT_EQ(TextAt(result, "scores", 0, "candidate"), "a.exr");
    EXPECT_EQ(At(result, "scores", 0, "rank"), 1);
    EXPECT_EQ(At(result, "scores", 1, "rank"), 2);
    EXPECT_EQ(At(result, "scores", 2, "rank"), 2);
    EXPECT_EQ(TextAt(result, "scores", 0, "ties_with"), "");
    EXPECT_EQ(TextAt(result, "scores", 1, "ties_with"),
              TextAt(result, "scores", 2, "candidate"));
    EXPECT_EQ(TextAt(result, "pairs", 0, "verdict"), "first is closer");
    EXPECT_EQ(TextAt(result, "pairs", 2, "verdict"), "tie");
    EXPECT_THAT(result.document.sections[0].sentences[0],
                HasSubstr("of which the paired test is sure"));
}

TEST_F(Scores, EqualPicturesTie) {
    const Image<float> c = Plus(Smooth(), 0.1);
    const ScoreResult result = Score({.candidates = {Exr("b.exr", c), Exr("c.exr", c)},
                                      .reference = Exr("t.exr", Smooth())});
    EXPECT_EQ(At(result, "scores", 1, "rank"), 1);
    EXPECT_EQ(TextAt(result, "scores", 1, "ties_with"), "b.exr");
}

TEST_F(Scores, LimitsFailWhatBreaksThem) {
    const ScoreResult result =
        Score({.candidates = {Exr("b.exr", Plus(Smooth(), 0.1)), Exr("c.exr", Smooth())},
               .reference = Exr("t.exr", Smooth()),
               .fail_under = {"psnr=40", "ssim=0.1"},
               .fail_over = {"flip=0.05"}});
    ASSERT_EQ(result.failures.size(), 2u);
    EXPECT_THAT(result.failures[0], HasSubstr("b.exr: psnr = 20"));
    EXPECT_THAT(result.failures[0], HasSubstr("must be >= 40"));
    EXPECT_THAT(result.failures[1], HasSubstr("b.exr: flip = "));
    // An infinite PSNR keeps every limit; a figure that there is not keeps none.
    EXPECT_EQ(TextAt(result, "limits", 3, "verdict"), "passed");
    const ScoreResult one = Score({.candidates = {Exr("o.exr", Image<float>(1, 1, 0.5F))},
                                   .reference = Path("o.exr").string(),
                                   .fail_under = {"ssim=0"}});
    EXPECT_THAT(one.failures, ElementsAre(HasSubstr("ssim = nan, must be >= 0")));
}

TEST_F(Scores, OnePixelHasItsFiguresAndNoInterval) {
    const ScoreResult result = Score({.candidates = {Exr("c.exr", Image<float>(1, 1, 0.5F))},
                                      .reference = Exr("t.exr", Image<float>(1, 1, 0.25F))});
    EXPECT_EQ(At(result, "errors", 0, "bias"), 0.25);
    EXPECT_GT(At(result, "scores", 0, "flip"), 0);
    EXPECT_TRUE(std::isnan(At(result, "scores", 0, "ssim")));
    const auto& bias =
        std::get<Measured>(doc::TableOf(result.document, "errors").At(0, "bias"));
    EXPECT_TRUE(std::isinf(bias.interval.high));
}

// Seen through FLIP's tone curves, which a black picture has none of.
TEST_F(Scores, ABlackReferenceHasNoHdrFlip) {
    const Image<float> black(16, 16, 0.0F), grey(16, 16, 0.5F);
    WriteExr(Path("t.exr"), {{"R", black}, {"G", black}, {"B", black}});
    WriteExr(Path("c.exr"), {{"R", grey}, {"G", grey}, {"B", grey}});
    const ScoreResult result =
        Score({.candidates = {Path("c.exr").string()}, .reference = Path("t.exr").string()});
    EXPECT_EQ(At(result, "scores", 0, "rmse"), 0.5);
    EXPECT_TRUE(std::isnan(At(result, "scores", 0, "flip")));
    EXPECT_THAT(doc::ToTerminal(result.document), HasSubstr("the reference is black"));
    const ScoreResult ldr = Score({.candidates = {Path("c.exr").string()},
                                   .reference = Path("t.exr").string(),
                                   .figures = {.flip = FlipMode::kLdr}});
    EXPECT_GT(At(ldr, "scores", 0, "flip"), 0.5);
}

// FLIP of PNG files, the known answer of its own program: mean 0.369264.
TEST_F(Scores, FlipOfPngFilesIsThePublishedOne) {
    WritePreview(Path("t.png"), Weave());
    WritePreview(Path("c.png"), ShiftedRight(Weave()));
    const ScoreResult result = Score({.candidates = {Path("c.png").string()},
                                      .reference = Path("t.png").string(),
                                      .like = {"flip", "falcor", "pbrt", "oiio-flip"}});
    EXPECT_NEAR(At(result, "scores", 0, "flip"), 0.369264, 5e-6);
    EXPECT_NEAR(At(result, "like_flip", 0, "value"), 0.369264, 5e-6);
    EXPECT_NEAR(At(result, "like_pbrt", 3, "value"), 0.369264, 5e-6);
    EXPECT_NEAR(At(result, "like_falcor", 0, "value"), At(result, "errors", 0, "mse"), 1e-9);
    EXPECT_GT(At(result, "like_oiio_flip", 0, "value"), 0);
}

// And of floats: high dynamic range, mean 0.081336.
TEST_F(Scores, FlipOfFloatsIsThePublishedOne) {
    const auto write = [&](const char* name, const Image<Rgb>& picture) {
        std::vector<NamedChannel> channels;
        for (std::size_t c = 0; c < 3; ++c) {
            channels.push_back(
                {std::string(1, "RGB"[c]),
                 MadeImage<float>(picture.Width(), picture.Height(),
                                  [&](int i, int j) { return picture(i, j)[c]; })});
        }
        WriteExr(Path(name), channels);
        return Path(name).string();
    };
    const ScoreResult result = Score({.candidates = {write("c.exr", ShiftedRight(Stops()))},
                                      .reference = write("t.exr", Stops()),
                                      .like = {"flip"}});
    EXPECT_NEAR(At(result, "scores", 0, "flip"), 0.081336, 5e-6);
    EXPECT_NEAR(At(result, "like_flip", 0, "value"), 0.081336, 5e-6);
    EXPECT_THAT(doc::ToTerminal(result.document), HasSubstr("3 from -1.98"));
}

TEST_F(Scores, FilesOfOneNameAreToldApart) {
    for (const char* folder : {"old", "new"}) {
        std::filesystem::create_directories(Path(folder));
        Exr(std::string(folder) + "/f.exr", Plus(Smooth(), 0.1));
    }
    const ScoreResult result =
        Score({.candidates = {Path("old/f.exr").string(), Path("new/f.exr").string(),
                              Path("new/f.exr").string()},
               .reference = Exr("t.exr", Smooth())});
    EXPECT_EQ(TextAt(result, "errors", 0, "candidate"), "old/f.exr");
    EXPECT_EQ(TextAt(result, "errors", 1, "candidate"), "new/f.exr (2)");
    EXPECT_EQ(TextAt(result, "errors", 2, "candidate"), "new/f.exr (3)");
}

TEST_F(Scores, RefuseWhatIsNoLimitAndNoProgram) {
    const std::string t = Exr("t.exr", Smooth());
    const auto score = [&](ScoreJob job) {
        job.candidates = {t};
        job.reference = t;
        return [=, this] { Score(job); };
    };
    EXPECT_THAT(score({.fail_under = {"pnsr=40"}}),
                ThrowsMessage<Error>(HasSubstr("did you mean psnr?")));
    for (const char* bad : {"psnr", "psnr=", "psnr=x", "psnr=40x", "psnr=inf", "psnr=nan"}) {
        EXPECT_THAT(score({.fail_over = {bad}}),
                    ThrowsMessage<Error>(HasSubstr(std::string("--fail-over ") + bad +
                                                   ", must be FIGURE=NUMBER")));
    }
    EXPECT_THAT(score({.like = {"idif"}}),
                ThrowsMessage<Error>(HasSubstr("did you mean idiff?")));
    EXPECT_THAT(score({.figures = {.peak = 0}}), ThrowsMessage<Error>(HasSubstr("--peak = 0")));
    EXPECT_EQ(FileCount(), 1);
}

}  // namespace
}  // namespace plumb
