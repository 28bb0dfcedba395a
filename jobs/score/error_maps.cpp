#include "jobs/score/error_maps.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/srgb.h"
#include "io/data_uri.h"
#include "io/image_io.h"
#include "jobs/screen_space/signed_picture.h"

namespace plumb {
namespace {

// Five of the 256 colours of the map, evenly spaced, sRGB-encoded; between them it is nearly
// straight.
constexpr std::array<std::array<double, 3>, 5> kMagma{{{0.001462, 0.000466, 0.013866},
                                                       {0.316654, 0.071690, 0.485380},
                                                       {0.716387, 0.214982, 0.475290},
                                                       {0.986700, 0.535582, 0.382210},
                                                       {0.987053, 0.991438, 0.749504}}};

constexpr Rgb kGrey{0.2F, 0.2F, 0.2F};

Rgb Magma(double value) {
    const double place = std::clamp(value, 0.0, 1.0) * (kMagma.size() - 1);
    const std::size_t k = std::min(std::size_t(place), kMagma.size() - 2);
    Rgb colour;
    for (std::size_t c = 0; c < 3; ++c) {
        const double share = place - double(k);
        colour[c] = float(DecodeSrgb(kMagma[k][c] + share * (kMagma[k + 1][c] - kMagma[k][c])));
    }
    return colour;
}

/// What does not count may be no number.
Image<float> Counted(Image<float> image, const Mask& mask) {
    for (std::size_t p = 0; p < image.Pixels().size(); ++p) {
        if (!mask.Empty() && mask.Pixels()[p] == 0) image.Pixels()[p] = 0;
    }
    return image;
}

}  // namespace

Image<Rgb> FlipPicture(const Image<float>& map, const Mask& mask) {
    Image<Rgb> picture(map.Width(), map.Height(), kGrey);
    for (std::size_t p = 0; p < map.Pixels().size(); ++p) {
        if (mask.Empty() || mask.Pixels()[p] != 0) picture.Pixels()[p] = Magma(map.Pixels()[p]);
    }
    return picture;
}

Image<float> MeanOfChannels(const Channels& channels) {
    Image<float> mean = channels[0];
    for (std::size_t p = 0; p < mean.Pixels().size(); ++p) {
        double sum = 0;
        for (const Image<float>& channel : channels) sum += channel.Pixels()[p];
        mean.Pixels()[p] = float(sum / double(channels.size()));
    }
    return mean;
}

std::vector<doc::Picture> WriteErrorMaps(const std::filesystem::path& folder,
                                         const std::string& name, const Compared& compared,
                                         std::size_t k, const CandidateScore& score) {
    const Channels &c = compared.candidates[k].values, &t = compared.reference.values;
    const Mask all(c[0].Width(), c[0].Height(), 255);
    const Mask& mask = compared.mask.Empty() ? all : compared.mask;
    std::vector<doc::Picture> pictures;
    const auto write = [&](const std::string& kind, const Image<Rgb>& picture,
                           const std::string& caption) {
        const std::filesystem::path path = folder / (name + "_" + kind + ".png");
        WritePreview(path, picture);
        pictures.push_back({.data_uri = PngDataUri(path),
                            .alternative = kind + " error of " + score.name,
                            .caption = caption});
    };
    write("signed", SignedPicture(MeanOfChannels(c), MeanOfChannels(t), mask),
          doc::Verbatim(score.name) +
              ": signed error; blue too dark, red too bright, full colour at 0.25.");
    if (!score.flip_map.Empty()) {
        write("flip", FlipPicture(score.flip_map, mask),
              doc::Verbatim(score.name) + ": FLIP; black 0, pale yellow 1.");
    }
    std::vector<NamedChannel> channels;
    for (std::size_t i = 0; i < c.size(); ++i) {
        Image<float> error = c[i];
        for (std::size_t p = 0; p < error.Pixels().size(); ++p)
            error.Pixels()[p] -= t[i].Pixels()[p];
        channels.push_back({c.size() == 1 ? "error" : std::string("error.") + "RGB"[i],
                            Counted(std::move(error), mask)});
    }
    if (!score.flip_map.Empty()) channels.push_back({"flip", Counted(score.flip_map, mask)});
    WriteExr(folder / (name + ".exr"), channels);
    return pictures;
}

}  // namespace plumb
