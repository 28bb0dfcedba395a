// SMAA 1x: finds the edges of a picture, takes each run of them for the line that it stands for,
// and blends the pixels along it by the areas that the line cuts off.
//
//   1. edges     |L - L_left| >= t, |L - L_top| >= t, and not far below the largest difference
//                around:  c |L - L_left| >= m                                      smaa_edges.h
//   2. weights   each run's ends and crossings -> shares of its pixels            smaa_weights.h
//   3. blending  along the axis of the larger share                                 this file
//
// Source   [Jimenez12] J. Jimenez et al., SMAA, 2012, and its shader of 2013: steps, presets.
// Symbols  L luma, t threshold, c local contrast factor, m largest difference around.
// Domain   Edges are sought in colours as displayed (encoded, [0, 1]). Blending may run on linear
//          ones.
// Beware   Not symmetric: of two equal shares along both axes the vertical neighbour is taken, and
//          a pixel has left and top edges, so the ends of diagonals differ in a mirrored picture.
//          At the picture's border nothing beyond it is blended in; a GPU repeats the border's.
#pragma once

#include <string>
#include <vector>

#include "core/image.h"

namespace plumb {

/// What edges are sought in.
enum class SmaaEdgeKind {
    kLuma,
    kColour,             ///< The largest difference of a channel.
    kColourAsPublished,  ///< The same, but |C - C_leftleft| in m where luma has |C_left - ...|.
};

/// Where the shares of a run come from.
enum class SmaaAreaSource {
    kTable,    ///< As on a GPU: bytes, bilinear between square roots of distances.
    kFormula,  ///< What the table was made from, at the exact distances.
};

struct SmaaOptions {
    double threshold = 0.1;            ///< t. [0, 0.5]
    int search_steps = 16;             ///< Of two pixels, each way. [0, 112]
    int diagonal_steps = 8;            ///< Of one pixel, each way; 0: no diagonals. [0, 19]
    double corner_rounding = 25;       ///< Per cent; 100: none. [0, 100]
    double local_contrast_factor = 2;  ///< c. >= 0
    SmaaEdgeKind edges = SmaaEdgeKind::kLuma;
    SmaaAreaSource areas = SmaaAreaSource::kTable;

    friend bool operator==(const SmaaOptions&, const SmaaOptions&) = default;
};

/// Throws Error, naming field, value and rule.
void Validate(const SmaaOptions& options);

/// The picture filtered.
Image<Rgb> SmaaFiltered(const Image<Rgb>& picture, const SmaaOptions& options = {});

/// `linear`, of the same size, blended by the edges of `encoded`.
Image<Rgb> SmaaFiltered(const Image<Rgb>& encoded, const Image<Rgb>& linear,
                        const SmaaOptions& options);

struct SmaaPreset {
    std::string name;  ///< low, medium, high, ultra
    SmaaOptions options;
};

/// As published. "high" is the default.
std::vector<SmaaPreset> SmaaPresets();

/// Throws Error, with the names there are, for any other name.
SmaaOptions SmaaPresetNamed(const std::string& name);

}  // namespace plumb
