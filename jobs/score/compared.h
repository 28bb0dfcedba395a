// Candidates and reference brought to one footing, said in words: same size, same channels, same
// encoding, finite numbers.
//
//       reference of integers   compared as stored: value / greatest integer, still encoded
//       reference of floats     compared in linear light; integers are decoded if they are sRGB
//
// as other programs do, so that a PSNR of PNG files is theirs. FLIP always sees linear light. Whether
// integers are sRGB or linear data is never guessed where it moves a figure of errors: integers
// against floats need --encoding. Between integers it moves FLIP alone; sRGB is assumed, and said.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "jobs/score/picture_file.h"
#include "score/over_tiles.h"

namespace plumb {

enum class Encoding { kUnsaid, kSrgb, kLinear };  ///< Of integers.
enum class BadPixels { kRefuse, kSkip };

/// Pixels of the whole picture.
struct Rectangle {
    int x = 0, y = 0, width = 0, height = 0;
};

struct CompareOptions {
    Encoding encoding = Encoding::kUnsaid;
    BadPixels bad = BadPixels::kRefuse;
    std::optional<Rectangle> crop = {};
    std::string mask = {};    ///< A picture's name; not 0 counts.
    std::string region = {};  ///< Of score/regions.h; needs a reference with depth_m.
};

inline const std::vector<std::string> kRegionNames{"seen", "edges", "interiors", "border",
                                                   "centre"};

struct ComparedPicture {
    std::string name;
    Channels values;            ///< As errors are taken of them.
    Image<Rgb> linear = {};     ///< As FLIP sees it; where no pixel counts the reference's.
    std::int64_t negative = 0;  ///< Numbers below 0 that count.
};

struct Compared {
    std::vector<ComparedPicture> candidates = {};
    ComparedPicture reference = {};
    Channels standard_error = {};  ///< Of the reference; may be empty.
    Mask mask;                     ///< Empty: all pixels count.
    std::int64_t counted = 0,
                 skipped = 0;  ///< Pixels; `skipped` for numbers that are not finite.
    int x = 0, y = 0;          ///< Upper left pixel of the crop.
    std::vector<std::string> channel_names;
    bool is_linear = false;     ///< `values` are linear light (or data), not encoded.
    bool in_unit = false;       ///< All that count lie in [0, 1].
    std::string encoding = {};  ///< A sentence on what was compared how.
};

/// Throws Error naming file, value and rule.
Compared Compare(const std::vector<PictureFile>& candidates, const PictureFile& reference,
                 const CompareOptions& options);

}  // namespace plumb
