// The anti-aliasing methods as they see a white strip on black: what the edge table compares.
//
//       1 sample     the pixel's centre
//       grid m       the mean of m x m centres
//       fxaa, smaa   1 sample, filtered
//       adaptive m   adaptive supersampling: the strip is a surface before the sky, lit evenly
//       shading m    the same by its shading metric alone
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/image.h"
#include "screen_space/antialiasing/sample_count.h"
#include "screen_space/antialiasing/strip_coverage.h"

namespace plumb {

/// What a method makes of a strip.
struct CoveragePicture {
    Image<float> value;    ///< 0 black, 1 white.
    Image<float> samples;  ///< Of each pixel.
};

struct CoverageMethod {
    std::string name;
    int margin_px = 0;  ///< Around a pixel, what it may depend on.
    std::function<CoveragePicture(const Strip& strip, int size_px)> draw;
};

CoverageMethod OneSampleCoverage();
CoverageMethod GridCoverage(int m);
CoverageMethod AdaptiveCoverage(const std::string& name, int m, const SampleMetrics& metrics);

/// All of them: 1 sample, every FXAA and SMAA preset, grid 2 to 8, adaptive and shading 2 to 4 with
/// c = m^2.
std::vector<CoverageMethod> CoverageMethods();

}  // namespace plumb
