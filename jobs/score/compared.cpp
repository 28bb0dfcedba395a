#include "jobs/score/compared.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/names.h"
#include "core/srgb.h"
#include "score/regions.h"

namespace plumb {
namespace {

void CheckKinds(const PictureFile& candidate, const PictureFile& reference, Encoding encoding) {
    const std::string c = candidate.label, r = reference.label;
    if (candidate.Width() != reference.Width() || candidate.Height() != reference.Height()) {
        throw Error(c + ": is " + std::to_string(candidate.Width()) + " x " +
                    std::to_string(candidate.Height()) + " pixels, must be " +
                    std::to_string(reference.Width()) + " x " +
                    std::to_string(reference.Height()) + " as " + r);
    }
    if (candidate.channels.size() != reference.channels.size()) {
        throw Error(c + ": has " + std::to_string(candidate.channels.size()) + " channels (" +
                    Joined(candidate.channel_names) + "), must have " +
                    std::to_string(reference.channels.size()) + " (" +
                    Joined(reference.channel_names) + ") as " + r);
    }
    if (candidate.is_float != reference.is_float && encoding == Encoding::kUnsaid) {
        const std::string& integers = candidate.is_float ? r : c;
        throw Error(integers + ": holds integers and " + (candidate.is_float ? c : r) +
                    " floats; --encoding must say whether the integers are srgb or linear");
    }
}

template <class T>
Image<T> Cut(const Image<T>& image, const Rectangle& crop) {
    if (image.Empty()) return image;
    Image<T> cut(crop.width, crop.height);
    for (int j = 0; j < crop.height; ++j)
        for (int i = 0; i < crop.width; ++i) cut(i, j) = image(crop.x + i, crop.y + j);
    return cut;
}

Rectangle CropOf(const PictureFile& reference, const CompareOptions& options) {
    const Rectangle whole{0, 0, reference.Width(), reference.Height()};
    if (!options.crop) return whole;
    const Rectangle& crop = *options.crop;
    if (crop.x < 0 || crop.y < 0 || crop.width < 1 || crop.height < 1 ||
        crop.x > whole.width - crop.width || crop.y > whole.height - crop.height) {
        throw Error("--crop = " + std::to_string(crop.x) + " " + std::to_string(crop.y) + " " +
                    std::to_string(crop.width) + " " + std::to_string(crop.height) +
                    ", must be X Y WIDTH HEIGHT within " + std::to_string(whole.width) + " x " +
                    std::to_string(whole.height) + " pixels");
    }
    return crop;
}

Mask RegionOf(const PictureFile& reference, const std::string& name) {
    const std::size_t place = PlaceOf(name, kRegionNames, "--region = " + name);
    if (reference.depth_m.Empty()) {
        throw Error("--region: " + reference.label +
                    " has no channel depth_m, as a truth of plumb truth has");
    }
    const Regions regions = FindRegions(reference.depth_m, reference.normal);
    const Mask* masks[] = {&regions.seen, &regions.edges, &regions.interiors, &regions.border,
                           &regions.centre};
    return *masks[place];
}

Mask MaskOf(const PictureFile& reference, const CompareOptions& options) {
    Mask mask;
    if (!options.mask.empty()) {
        mask = ReadMask(ParsePictureName(options.mask));
        if (mask.Width() != reference.Width() || mask.Height() != reference.Height()) {
            throw Error("--mask " + options.mask + ": is " + std::to_string(mask.Width()) +
                        " x " + std::to_string(mask.Height()) + " pixels, must be " +
                        std::to_string(reference.Width()) + " x " +
                        std::to_string(reference.Height()));
        }
    }
    if (!options.region.empty()) mask = Both(mask, RegionOf(reference, options.region));
    return mask;
}

bool Counts(const Mask& mask, std::size_t p) {
    return mask.Empty() || mask.Pixels()[p] != 0;
}

/// Takes pixels that are not finite in any picture out of the mask, or refuses them.
void MindBadPixels(const std::vector<const Channels*>& pictures,
                   const std::vector<std::string>& names, BadPixels rule, int width, int height,
                   Mask& mask, std::int64_t& skipped) {
    for (std::size_t k = 0; k < pictures.size(); ++k) {
        std::int64_t bad = 0;
        std::size_t first = 0;
        for (std::size_t p = 0; p < std::size_t(width) * height; ++p) {
            if (!Counts(mask, p)) continue;
            const bool finite = std::ranges::all_of(*pictures[k], [&](const Image<float>& c) {
                return std::isfinite(c.Pixels()[p]);
            });
            if (finite) continue;
            if (bad++ == 0) first = p;
            if (rule == BadPixels::kSkip) {
                if (mask.Empty()) mask = Mask(width, height, 255);
                mask.Pixels()[p] = 0;
                ++skipped;
            }
        }
        if (bad > 0 && rule == BadPixels::kRefuse) {
            throw Error(names[k] + ": " + std::to_string(bad) +
                        " pixels are not finite, the first at (" +
                        std::to_string(first % width) + ", " + std::to_string(first / width) +
                        "); --bad-pixels skip leaves them out");
        }
    }
}

enum class Change { kNone, kDecode, kEncode };

Channels Changed(Channels channels, Change change) {
    if (change == Change::kNone) return channels;
    for (Image<float>& channel : channels) {
        for (float& value : channel.Pixels()) {
            value = float(change == Change::kDecode
                              ? DecodeSrgb(value)
                              : EncodeSrgb(std::clamp(double(value), 0.0, 1.0)));
        }
    }
    return channels;
}

Image<Rgb> LinearOf(const Channels& values, bool encoded) {
    Image<Rgb> linear(values[0].Width(), values[0].Height());
    const Channels light = Changed(values, encoded ? Change::kDecode : Change::kNone);
    for (std::size_t p = 0; p < linear.Pixels().size(); ++p) {
        for (std::size_t c = 0; c < 3; ++c) {
            const float value = light[light.size() == 3 ? c : 0].Pixels()[p];
            linear.Pixels()[p][c] = std::isfinite(value) ? value : 0;
        }
    }
    return linear;
}

std::string Words(const PictureFile& reference, bool mixed, Encoding encoding, bool linear) {
    const std::string integers = std::to_string(reference.bits) + "-bit integers";
    if (!mixed && reference.is_float)
        return "All pictures are floats and compared as they are, linear.";
    if (!mixed && encoding == Encoding::kLinear)
        return "All pictures are " + integers + ", linear as `--encoding` says.";
    if (!mixed) {
        return "All pictures are " + integers +
               ", compared as stored; FLIP decodes them as sRGB" +
               (encoding == Encoding::kSrgb ? ", as `--encoding` says."
                                            : ", which is assumed: `--encoding linear` if they "
                                              "are data.");
    }
    if (encoding == Encoding::kLinear)
        return "Integers and floats are compared as numbers, linear as `--encoding` says.";
    return linear
               ? "Integers are decoded from sRGB, as `--encoding` says, and compared with the "
                 "floats in linear light."
               : "Floats are clamped to [0, 1] and encoded as sRGB, as `--encoding` says, to "
                 "be "
                 "compared with the integers as stored.";
}

}  // namespace

Compared Compare(const std::vector<PictureFile>& candidates, const PictureFile& reference,
                 const CompareOptions& options) {
    bool mixed = false;
    for (const PictureFile& candidate : candidates) {
        CheckKinds(candidate, reference, options.encoding);
        mixed = mixed || candidate.is_float != reference.is_float;
    }
    const Rectangle crop = CropOf(reference, options);
    Compared compared{.mask = Cut(MaskOf(reference, options), crop),
                      .x = crop.x,
                      .y = crop.y,
                      .channel_names = reference.channel_names};
    const bool integers_encoded = options.encoding != Encoding::kLinear;
    compared.is_linear = reference.is_float || !integers_encoded;
    compared.encoding = Words(reference, mixed, options.encoding, compared.is_linear);

    const auto values_of = [&](const PictureFile& file) {
        Channels values;
        for (const Image<float>& channel : file.channels) values.push_back(Cut(channel, crop));
        const bool encoded = !file.is_float && integers_encoded;
        if (encoded && compared.is_linear) return Changed(std::move(values), Change::kDecode);
        if (!encoded && !compared.is_linear) return Changed(std::move(values), Change::kEncode);
        return values;
    };
    compared.reference = {.name = reference.label, .values = values_of(reference)};
    for (const Image<float>& s : reference.standard_error)
        compared.standard_error.push_back(Cut(s, crop));
    std::vector<const Channels*> pictures{&compared.reference.values};
    std::vector<std::string> names{compared.reference.name};
    if (!compared.standard_error.empty()) {
        pictures.push_back(&compared.standard_error);
        names.push_back(compared.reference.name + ".error");
    }
    for (const PictureFile& file : candidates)
        compared.candidates.push_back({.name = file.label, .values = values_of(file)});
    for (const ComparedPicture& candidate : compared.candidates) {
        pictures.push_back(&candidate.values);
        names.push_back(candidate.name);
    }
    MindBadPixels(pictures, names, options.bad, crop.width, crop.height, compared.mask,
                  compared.skipped);
    const std::size_t pixels = std::size_t(crop.width) * crop.height;
    compared.counted = compared.mask.Empty() ? std::int64_t(pixels) : CountOf(compared.mask);
    if (compared.counted == 0) throw Error("no pixel is left to score");

    compared.in_unit = true;
    compared.reference.linear = LinearOf(compared.reference.values, !compared.is_linear);
    const auto look_at = [&](ComparedPicture& picture) {
        for (const Image<float>& channel : picture.values) {
            for (std::size_t p = 0; p < pixels; ++p) {
                if (!Counts(compared.mask, p)) continue;
                const float value = channel.Pixels()[p];
                picture.negative += value < 0;
                compared.in_unit = compared.in_unit && 0 <= value && value <= 1;
            }
        }
    };
    look_at(compared.reference);
    for (ComparedPicture& candidate : compared.candidates) {
        look_at(candidate);
        candidate.linear = LinearOf(candidate.values, !compared.is_linear);
        for (std::size_t p = 0; p < pixels; ++p) {
            if (!Counts(compared.mask, p))
                candidate.linear.Pixels()[p] = compared.reference.linear.Pixels()[p];
        }
    }
    return compared;
}

}  // namespace plumb
