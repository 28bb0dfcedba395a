#include "jobs/score/picture_file.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "core/error.h"
#include "core/names.h"
#include "io/image_io.h"
#include "io/picture_file.h"
#include "io/regular_file.h"
#include "io/stored_image.h"

namespace plumb {
namespace {

using ByName = std::map<std::string, const Image<float>*>;

struct Raw {
    std::vector<NamedChannel> channels = {};
    bool is_float = false;
    int bits = 0;
};

std::string Ending(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::ranges::transform(ending, ending.begin(),
                           [](unsigned char c) { return char(std::tolower(c)); });
    return ending;
}

Raw ReadRadiance(const std::filesystem::path& path) {
    const Picture picture = ReadPictureFile(path);
    Raw raw{.is_float = true, .bits = 32};
    for (std::size_t c = 0; c < 3; ++c) {
        Image<float> channel(picture.linear.Width(), picture.linear.Height());
        std::ranges::transform(picture.linear.Pixels(), channel.Pixels().begin(),
                               [&](const Rgb& pixel) { return pixel[c]; });
        raw.channels.push_back({std::string(1, "RGB"[c]), std::move(channel)});
    }
    return raw;
}

Raw Read(const std::filesystem::path& path) {
    if (Ending(path) == ".hdr") return ReadRadiance(path);
    const StoredImage image = ReadStoredImage(path);
    Raw raw{.is_float = image.is_float, .bits = image.bits};
    for (const auto& [name, stored] : image.channels) {
        Image<float> channel(stored.Width(), stored.Height());
        std::ranges::transform(stored.Pixels(), channel.Pixels().begin(),
                               [&](double number) { return float(number / image.full_scale); });
        raw.channels.push_back({name, std::move(channel)});
    }
    return raw;
}

bool IsAlpha(const std::string& name) {
    return name == "A" || name == "a" || name == "alpha" || name == "Alpha";
}

std::vector<std::string> Layer(const std::string& name) {
    return {name + ".R", name + ".G", name + ".B"};
}

bool HasAll(const ByName& channels, const std::vector<std::string>& names) {
    return std::ranges::all_of(
        names, [&](const std::string& name) { return channels.contains(name); });
}

/// The names to choose from: channels, and layers of colours by their common name.
std::vector<std::string> Choices(const std::vector<NamedChannel>& all, const ByName& by_name) {
    std::vector<std::string> names;
    for (const NamedChannel& channel : all) {
        const std::string& name = channel.name;
        const std::string layer = name.size() > 2 ? name.substr(0, name.size() - 2) : "";
        const bool of_layer = !layer.empty() && HasAll(by_name, Layer(layer));
        if (!of_layer) names.push_back(name);
        if (of_layer && name.ends_with(".R")) names.push_back(layer);
    }
    return names;
}

std::vector<std::string> Chosen(const PictureName& name, const std::vector<NamedChannel>& all,
                                const ByName& by_name) {
    if (!name.channel.empty()) {
        if (HasAll(by_name, Layer(name.channel))) return Layer(name.channel);
        const std::vector<std::string> choices = Choices(all, by_name);
        if (!by_name.contains(name.channel)) {
            throw Error(name.path.string() + ": channel = " + name.channel + ", " +
                        MustBeOneOf(name.channel, choices));
        }
        return {name.channel};
    }
    for (const auto& colour : {std::vector<std::string>{"R", "G", "B"}, {"r", "g", "b"}}) {
        if (HasAll(by_name, colour)) return colour;
    }
    std::vector<std::string> scalars;
    for (const NamedChannel& channel : all) {
        if (!IsAlpha(channel.name) || all.size() == 1) scalars.push_back(channel.name);
    }
    if (scalars.size() == 1) return scalars;
    throw Error(name.path.string() +
                ": has no R, G and B and more channels than one; choose by " +
                name.path.filename().string() +
                ":NAME or --channel NAME: " + Joined(Choices(all, by_name)));
}

/// "V" to "V.error", "irradiance.R" to "irradiance.error.R".
std::string ErrorNameOf(const std::string& channel, bool of_layer) {
    if (!of_layer || channel.size() < 3) return channel + ".error";
    return channel.substr(0, channel.size() - 2) + ".error" +
           channel.substr(channel.size() - 2);
}

}  // namespace

std::string PictureName::Text() const {
    return path.filename().string() + (channel.empty() ? "" : ":" + channel);
}

PictureName ParsePictureName(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    const bool has_channel =
        colon != std::string::npos && colon > 0 && text.find('/', colon) == std::string::npos;
    if (!has_channel || IsThere(text)) return {text, ""};
    if (colon + 1 == text.size()) throw Error(text + ": names no channel after the colon");
    return {text.substr(0, colon), text.substr(colon + 1)};
}

PictureFile ReadPictureToScore(const PictureName& name) {
    const Raw raw = Read(name.path);
    ByName by_name;
    for (const NamedChannel& channel : raw.channels) by_name[channel.name] = &channel.pixels;
    PictureFile file{
        .name = name, .label = name.Text(), .is_float = raw.is_float, .bits = raw.bits};
    file.channel_names = Chosen(name, raw.channels, by_name);
    Channels errors;
    for (const std::string& channel : file.channel_names) {
        file.channels.push_back(*by_name.at(channel));
        const auto error = by_name.find(ErrorNameOf(channel, file.channel_names.size() == 3));
        if (error != by_name.end()) errors.push_back(*error->second);
    }
    if (errors.size() == file.channels.size()) file.standard_error = std::move(errors);
    if (name.channel.empty()) {
        for (const NamedChannel& channel : raw.channels) file.all.push_back(channel.pixels);
    } else {
        file.all = file.channels;
    }
    if (by_name.contains("depth_m")) file.depth_m = *by_name.at("depth_m");
    const std::vector<std::string> normal{"normal.x", "normal.y", "normal.z"};
    if (HasAll(by_name, normal)) {
        file.normal = Image<Vec3f>(file.Width(), file.Height(), Vec3f::Zero());
        for (int c = 0; c < 3; ++c) {
            const std::vector<float>& numbers = by_name.at(normal[std::size_t(c)])->Pixels();
            for (std::size_t p = 0; p < numbers.size(); ++p)
                file.normal.Pixels()[p][c] = numbers[p];
        }
    }
    return file;
}

Mask ReadMask(const PictureName& name) {
    const PictureFile file = ReadPictureToScore(name);
    Mask mask(file.Width(), file.Height(), 0);
    for (const Image<float>& channel : file.channels) {
        for (std::size_t p = 0; p < mask.Pixels().size(); ++p) {
            if (channel.Pixels()[p] != 0) mask.Pixels()[p] = 255;
        }
    }
    return mask;
}

}  // namespace plumb
