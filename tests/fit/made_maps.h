// Histograms whose light obeys a known formula, so that a fit has a right answer.
#pragma once

#include <string>
#include <vector>

#include "core/bounce_histogram.h"
#include "fit/models/escape_probability.h"

namespace plumb {

/// The constants of a made surface: V = F0(alpha), g = a V^b.
struct MadeSurface {
    DirectFactor<> F0{.a = 0.6, .p = 1.2};
    EscapeProbability<> g{.a = 0.95, .b = 0.5};
};

/// A histogram over alpha: bin i of n at its centre, with 10 (i + 1) facets, so that weights
/// matter. E_k = (1 - V) g (1 - g)^(k - 1), which sums to the escape family's total.
inline BounceHistogram MakeMap(const std::string& name, const MadeSurface& surface = {},
                               int n = 40, int bounces = 6) {
    BounceHistogram map;
    map.surface = name;
    map.albedos = {0.1, 0.3, 0.5, 0.7, 0.9};
    for (int i = 0; i < n; ++i) {
        BounceBin bin;
        bin.low = double(i) / n;
        bin.high = double(i + 1) / n;
        bin.count = 10 * (i + 1);
        bin.alpha = (i + 0.5) / n;
        bin.V = Evaluate(surface.F0, UniformVisibility(bin.alpha));
        const double g = Evaluate(surface.g, bin.V);
        double E_k = bin.V;
        for (int k = 0; k <= bounces; ++k) {
            bin.bounce.push_back({.mean = E_k, .variance = 1e-4});
            E_k = k == 0 ? (1 - bin.V) * g : E_k * (1 - g);
        }
        for (double rho : map.albedos)
            bin.total.push_back({.mean = EscapeTotal(bin.V, g, Albedo(rho)), .variance = 1e-4});
        map.bins.push_back(bin);
    }
    return map;
}

}  // namespace plumb
