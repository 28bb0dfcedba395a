// SAO as it was published and as it was shipped: three generations of constants.
//
//                        paper            supplement2012     g3d10
//       s, tau           9, 7             11, 7              19, 7 (table)
//       full turn        2 pi             6.28               6.28
//       hash             C precedence     code               code
//       phi              exact            float32            float32
//       rounding         trunc(h u + x)   x + trunc(h u)     x + trunc(h u)
//       pyramid          rotated, ^1      rotated, ^1        rotated, no ^1
//       falloff          eq. 1            B                  high quality
//       r, beta, eps     1, 0.001 z, 0.01 1, 0.01, 0.01      0.75, 0.023, 0.001
//       normals          depth            depth              given
//       min radius       -                -                  3 px, taps 0.75 px
//       2 x 2 quads      yes              yes                no
//       z_min            -200             -300               -1000
//       blur             R 3, stride 3    R 4, stride 2      R 4, stride 2, normals, planes
//       edge sharpness   2048             2000               2000
//       lift, tiny       0, 0             0.3, 1e-4          0.3, 1e-4
//       packing          RGB8             RGB8               none
//
// Source   paper: the text of [McGuire12]; what it leaves open (sigma, k, beta, eps, the quads'
//          threshold, the blur's array) is ours: sigma and eps as in the supplement, beta =
//          0.001, 1 cm at 10 m, the array of the supplement's 7-tap copy. supplement2012: its
//          shaders. g3d10: its shaders and AmbientOcclusionSettings.
// Beware   G3D 10 keeps key and z in 16-bit floats; here they are 32-bit.
#pragma once

#include <string>
#include <vector>

#include "screen_space/sao/sao_passes.h"

namespace plumb {

SaoOptions SaoPaper();
SaoOptions SaoSupplement2012();
SaoOptions SaoG3d10();

struct SaoPreset {
    std::string name;  ///< paper, supplement2012, g3d10, alchemy
    SaoOptions options;
};

/// All of them, AlchemyAO (alchemy_ao.h) at the end.
std::vector<SaoPreset> SaoPresets();

/// Throws Error, with the names there are, for any other name.
SaoOptions SaoPresetNamed(const std::string& name);

}  // namespace plumb
