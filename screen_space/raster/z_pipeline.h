// The ways from a vertex to a stored depth that [McGuire12] section 2.1 compares.
//
// The paper recommends (1) to multiply the matrices in double, (2) an infinite far plane, (3) to
// multiply vectors on the left of column-major matrices, which "saves about half a bit". It does
// not say what differs there; on a processor that multiplies rows by dot products and columns
// by successive additions it is the order of the four sums, which is what ProductOrder names.
#pragma once

#include <string>
#include <vector>

#include "screen_space/raster/depth_format.h"

namespace plumb {

enum class HostPrecision { kFloat, kDouble };  ///< Of sines, cosines and matrix products.

/// How four products are summed.
enum class ProductOrder {
    kColumns,  ///< ((a + b) + c) + d: columns scaled and added, M v of column-major matrices.
    kRows,     ///< (a + b) + (c + d): a dot product, v^T M of column-major matrices.
};

/// What clip_z / clip_w of the near and the far plane is.
enum class ClipRange {
    kMinusOneToOne,  ///< OpenGL: d = (clip_z / clip_w + 1) / 2. Not for reversed depth.
    kZeroToOne,      ///< Direct3D, Vulkan.
};

struct ZPipeline {
    HostPrecision host = HostPrecision::kDouble;
    bool concatenated = true;  ///< One matrix for a vertex; else three, one after the other.
    ProductOrder order = ProductOrder::kRows;
    ClipRange clip = ClipRange::kMinusOneToOne;
    DepthFormat format = DepthFormat::kD24;
    bool far_is_infinite = true;

    friend bool operator==(const ZPipeline&, const ZPipeline&) = default;
};

/// "double concatenated rows GL D24 infinite".
std::string NameOf(const ZPipeline& pipeline);

/// Every combination that exists: 112.
std::vector<ZPipeline> AllZPipelines();

}  // namespace plumb
