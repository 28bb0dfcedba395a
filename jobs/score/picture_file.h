// A picture to be scored, as its file holds it.
//
//       a.png   a.exr   truth.exr:V   frame.exr:diffuse
//
// PNG, TIFF, OpenEXR, PFM, Radiance HDR. A file with R, G and B is a colour, one with a single channel
// (an alpha apart) a scalar; of any other the name after the last colon, or --channel, chooses: that
// of a channel, or of a layer with the channels NAME.R, NAME.G, NAME.B. Standard errors are found beside
// a quantity as `plumb truth` writes them: NAME.error, or NAME.error.R ...
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/image.h"
#include "core/vec.h"
#include "score/errors.h"

namespace plumb {

struct PictureName {
    std::filesystem::path path;
    std::string channel;  ///< Of the file; "" = the file's only picture.

    /// "truth.exr:V"
    std::string Text() const;
};

/// A file of the whole name goes before one with a channel behind it.
PictureName ParsePictureName(const std::string& text);

struct PictureFile {
    PictureName name;
    std::string label;                            ///< How reports call it.
    std::vector<std::string> channel_names = {};  ///< Of `channels`, as in the file.
    Channels channels = {};        ///< One or three; integers over their greatest.
    Channels standard_error = {};  ///< None, or as many.
    Channels all = {};  ///< What idiff compares: every channel of a picture without layers.
    bool is_float = false;
    int bits = 0;  ///< Of an integer.

    Image<float> depth_m = {};  ///< Of a truth; else empty.
    Image<Vec3f> normal = {};

    int Width() const { return channels.front().Width(); }
    int Height() const { return channels.front().Height(); }
};

/// Throws Error naming the file and what is wrong: all that its reader refuses, a channel that it
/// has not, more channels than one picture has and no choice.
PictureFile ReadPictureToScore(const PictureName& name);

/// 255 where any channel is not 0, of a picture of the same kinds.
Mask ReadMask(const PictureName& name);

}  // namespace plumb
