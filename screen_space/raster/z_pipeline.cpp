#include "screen_space/raster/z_pipeline.h"

namespace plumb {

std::string NameOf(const ZPipeline& p) {
    std::string name = p.host == HostPrecision::kDouble ? "double" : "float";
    name += p.concatenated ? " concatenated" : " separate";
    name += p.order == ProductOrder::kRows ? " rows" : " columns";
    name += p.clip == ClipRange::kMinusOneToOne ? " GL " : " D3D ";
    name += NameOf(p.format);
    name += p.far_is_infinite ? " infinite" : " finite";
    return name;
}

std::vector<ZPipeline> AllZPipelines() {
    std::vector<ZPipeline> all;
    for (const DepthFormat format : {DepthFormat::kD16, DepthFormat::kD24, DepthFormat::kD32F,
                                     DepthFormat::kD32FReversed}) {
        for (const ClipRange clip : {ClipRange::kMinusOneToOne, ClipRange::kZeroToOne}) {
            if (format == DepthFormat::kD32FReversed && clip == ClipRange::kMinusOneToOne) {
                continue;
            }
            for (const bool infinite : {true, false}) {
                for (const HostPrecision host :
                     {HostPrecision::kDouble, HostPrecision::kFloat}) {
                    for (const bool concatenated : {true, false}) {
                        for (const ProductOrder order :
                             {ProductOrder::kRows, ProductOrder::kColumns}) {
                            all.push_back({host, concatenated, order, clip, format, infinite});
                        }
                    }
                }
            }
        }
    }
    return all;
}

}  // namespace plumb
