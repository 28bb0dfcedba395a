#include "jobs/score/like_tool.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "core/names.h"
#include "core/srgb.h"
#include "io/stored_image.h"
#include "score/flip_hdr.h"
#include "score/other_tools.h"
#include "score/quantiles.h"

namespace plumb {
namespace {

struct ToolFigure {
    std::string name;
    double value;
    std::string definition;
};
using ToolFigures = std::vector<ToolFigure>;

Channels Decoded(Channels channels, bool is_float) {
    if (is_float) return channels;
    for (Image<float>& channel : channels)
        for (float& value : channel.Pixels()) value = float(DecodeSrgb(value));
    return channels;
}

Image<Rgb> ColourOf(const Channels& channels) {
    Image<Rgb> colour(channels[0].Width(), channels[0].Height());
    for (std::size_t p = 0; p < colour.Pixels().size(); ++p) {
        for (std::size_t c = 0; c < 3; ++c)
            colour.Pixels()[p][c] = channels[channels.size() == 3 ? c : 0].Pixels()[p];
    }
    return colour;
}

/// All channels as OpenImageIO reads them: colours of a PNG come times alpha, rounded down to its
/// integers. A picture with fewer channels than the other gets channels of 0.
Channels AllChannels(const PictureFile& file, std::size_t count) {
    Channels all = file.all;
    const bool is_png = !file.is_float && file.name.path.extension() == ".png";
    if (is_png && (all.size() == 2 || all.size() == 4)) {
        const double full = GreatestInteger(file.bits, false);
        const Image<float> alpha = all.back();
        for (std::size_t c = 0; c + 1 < all.size(); ++c) {
            for (std::size_t p = 0; p < alpha.Pixels().size(); ++p) {
                float& value = all[c].Pixels()[p];
                const double product =
                    std::round(full * value) * std::round(full * alpha.Pixels()[p]);
                value = float(std::floor(product / full) / full);
            }
        }
    }
    while (all.size() < count) all.emplace_back(file.Width(), file.Height(), 0.0F);
    return all;
}

ToolFigures Idiff(const PictureFile& c, const PictureFile& t) {
    const std::size_t count = std::max(c.all.size(), t.all.size());
    const IdiffFigures f = FiguresOfIdiff(AllChannels(c, count), AllChannels(t, count));
    return {{"Mean error", f.mean, "mean |c - t| over all channels, alpha too"},
            {"RMS error", f.rms, "sqrt mean (c - t)^2 over all channels, alpha too"},
            {"Peak SNR", f.psnr_db, "20 log10(max(1, greatest |value| of both) / RMS) dB"},
            {"Max error", f.max, "greatest |c - t|"}};
}

ToolFigures FlipRow(const Image<float>& map) {
    std::vector<double> q = BinnedWeightedQuantiles(map, std::array{0.25, 0.5, 0.75});
    const auto [least, greatest] = std::ranges::minmax_element(map.Pixels());
    return {{"Mean", MeanOverTiles(map).value, "mean over pixels"},
            {"Weighted median", q[1], "of 100 bins, each weighted by its value"},
            {"1st weighted quartile", q[0], "likewise"},
            {"3rd weighted quartile", q[2], "likewise"},
            {"Min", *least, ""},
            {"Max", *greatest, ""}};
}

Image<float> FlipOf(const PictureFile& c, const PictureFile& t,
                    const std::optional<ToneExposures>& assumed) {
    const Image<Rgb> candidate = ColourOf(Decoded(c.channels, c.is_float));
    const Image<Rgb> reference = ColourOf(Decoded(t.channels, t.is_float));
    if (!assumed && !t.is_float) return FlipMap(candidate, reference);
    return HdrFlipMap(candidate, reference, {}, {.exposures = assumed}).map;
}

ToolFigures Pbrt(const PictureFile& c, const PictureFile& t) {
    const Channels candidate = Decoded(c.channels, c.is_float);
    const Channels reference = Decoded(t.channels, t.is_float);
    const PbrtFigures f = FiguresOfPbrt(candidate, reference);
    const auto zero_infinities = [](Channels channels) {
        for (Image<float>& channel : channels) {
            for (float& value : channel.Pixels()) value = std::isinf(value) ? 0 : value;
        }
        return ColourOf(channels);
    };
    const Image<float> flip = FlipMap(zero_infinities(candidate), zero_infinities(reference));
    return {{"MAE", f.mae, "mean |c - t|"},
            {"MSE", f.mse, "mean (c - t)^2"},
            {"MRSE", f.mrse, "mean (c - t)^2 / (t + 0.01)^2"},
            {"FLIP", MeanOverTiles(flip).value, "mean, of values clamped to [0, 1]"}};
}

ToolFigures Falcor(const PictureFile& c, const PictureFile& t) {
    const FalcorFigures f = FiguresOfFalcor(c.channels, t.channels);
    return {{"mse", f.mse, "mean (c - t)^2"},
            {"rmse", f.rmse, "mean (c - t)^2 / (c^2 + 0.001): relative, and no root"},
            {"mae", f.mae, "mean |(c - t)^2|: the same as mse"},
            {"mape", f.mape, "100 mean |(c - t) / (c + 0.001)|"}};
}

ToolFigures FiguresOf(const std::string& tool, const PictureFile& c, const PictureFile& t) {
    switch (PlaceOf(tool, kLikeNames, "--like " + tool)) {
        case 0:
            return Idiff(c, t);
        case 1:
            return Pbrt(c, t);
        case 2:
            return Falcor(c, t);
        case 3:
            return FlipRow(FlipOf(c, t, std::nullopt));
        default:
            return FlipRow(FlipOf(c, t, ExposuresBetween(ToneCurve::kAces, 0.18, 2)));
    }
}

}  // namespace

doc::Table LikeTable(const std::string& tool, const std::vector<PictureFile>& candidates,
                     const PictureFile& reference) {
    PlaceOf(tool, kLikeNames, "--like " + tool);
    std::string key = "like_" + tool;
    std::ranges::replace(key, '-', '_');
    doc::Table table{
        .key = key,
        .title = "As " + tool + " has it",
        .caption = "Of whole pictures, no noise taken off; defined as that program defines it.",
        .columns = {{.key = "candidate", .title = "Candidate", .role = doc::Role::kName},
                    {.key = "figure", .title = "Its name", .role = doc::Role::kName},
                    {.key = "value", .title = "Value", .digits = 6},
                    {.key = "definition", .title = "What it computes"}}};
    for (const PictureFile& candidate : candidates) {
        for (const ToolFigure& figure : FiguresOf(tool, candidate, reference)) {
            table.Add({candidate.label, figure.name, figure.value, figure.definition});
        }
    }
    return table;
}

}  // namespace plumb
