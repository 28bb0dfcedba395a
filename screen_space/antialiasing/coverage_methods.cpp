#include "screen_space/antialiasing/coverage_methods.h"

#include <cmath>
#include <numeric>

#include "screen_space/antialiasing/adaptive_shading.h"
#include "screen_space/antialiasing/fxaa.h"
#include "screen_space/antialiasing/smaa.h"
#include "screen_space/antialiasing/windows.h"

namespace plumb {
namespace {

Vec2 SamplePoint(int X, int Y, int m) {
    return {(X + 0.5) / m, (Y + 0.5) / m};
}

Image<Rgb> OneSample(const Strip& strip, int size_px) {
    Image<Rgb> picture(size_px, size_px);
    for (int y = 0; y < size_px; ++y) {
        for (int x = 0; x < size_px; ++x) {
            const float value = strip.Covers(SamplePoint(x, y, 1)) ? 1.f : 0.f;
            picture(x, y) = {value, value, value};
        }
    }
    return picture;
}

CoveragePicture Pictured(const Image<Rgb>& picture, const Image<float>& samples) {
    Image<float> value(picture.Width(), picture.Height());
    for (std::size_t i = 0; i < value.Pixels().size(); ++i) {
        value.Pixels()[i] = picture.Pixels()[i][1];
    }
    return {value, samples};
}

/// A filter of the picture with one sample a pixel.
template <class Filter>
CoverageMethod Filtered(const std::string& name, int margin_px, const Filter& filter) {
    return {name, margin_px, [filter](const Strip& strip, int size_px) {
                return Pictured(filter(OneSample(strip, size_px)),
                                Image<float>(size_px, size_px, 1.f));
            }};
}

/// The samples of an enlarged picture: the strip at 1 m, facing the viewer, before the sky.
struct StripSamples {
    Image<float> z_m;
    Image<Vec3f> normals;

    StripSamples(const Strip& strip, int size_px, int m)
        : z_m(size_px * m, size_px * m, -std::numeric_limits<float>::infinity()),
          normals(size_px * m, size_px * m, Vec3f(0, 0, 0)) {
        for (int Y = 0; Y < size_px * m; ++Y) {
            for (int X = 0; X < size_px * m; ++X) {
                if (!strip.Covers(SamplePoint(X, Y, m))) continue;
                z_m(X, Y) = -1;
                normals(X, Y) = {0, 0, 1};
            }
        }
    }
};

SampleMetrics OneConstant(double c) {
    SampleMetrics metrics;
    metrics.constants = MetricConstants::kShared;
    metrics.shared_c = c;
    return metrics;
}

}  // namespace

CoverageMethod OneSampleCoverage() {
    return Filtered("1 sample", 0, [](const Image<Rgb>& picture) { return picture; });
}

CoverageMethod GridCoverage(int m) {
    CheckEnlargement(m);
    return {"grid " + std::to_string(m), 0, [m](const Strip& strip, int size_px) {
                CoveragePicture out{Image<float>(size_px, size_px),
                                    Image<float>(size_px, size_px, float(m * m))};
                for (int y = 0; y < size_px; ++y) {
                    for (int x = 0; x < size_px; ++x) {
                        int inside = 0;
                        for (int k = 0; k < m * m; ++k) {
                            inside +=
                                strip.Covers(SamplePoint(x * m + k % m, y * m + k / m, m));
                        }
                        out.value(x, y) = float(double(inside) / (m * m));
                    }
                }
                return out;
            }};
}

CoverageMethod AdaptiveCoverage(const std::string& name, int m, const SampleMetrics& metrics) {
    CheckEnlargement(m);
    Validate(metrics);
    return {name, 1, [m, metrics](const Strip& strip, int size_px) {
                const StripSamples samples(strip, size_px, m);
                const SampleShader shader = [&](std::span<const SampleToShade> some,
                                                std::span<Rgb> colours) {
                    for (std::size_t i = 0; i < some.size(); ++i) {
                        const float value = samples.z_m(some[i].X, some[i].Y) == -1 ? 1.f : 0.f;
                        colours[i] = {value, value, value};
                    }
                };
                const Image<Rgb> first = ShadeFirst(size_px, size_px, m, shader);
                const Image<std::uint8_t> counts =
                    SampleCounts({samples.z_m, samples.normals, first}, m, metrics);
                Image<float> used(size_px, size_px);
                for (std::size_t i = 0; i < used.Pixels().size(); ++i) {
                    used.Pixels()[i] = counts.Pixels()[i];
                }
                return Pictured(ShadeRest(first, counts, m, shader), used);
            }};
}

std::vector<CoverageMethod> CoverageMethods() {
    std::vector<CoverageMethod> methods{OneSampleCoverage()};
    for (const FxaaPreset& preset : FxaaPresets()) {
        const std::vector<double>& steps = preset.options.steps_px;
        const int reach = int(std::ceil(std::accumulate(steps.begin(), steps.end(), 0.0)));
        methods.push_back(Filtered("fxaa " + preset.name, reach + 1,
                                   [options = preset.options](const Image<Rgb>& picture) {
                                       return FxaaFiltered(picture, options);
                                   }));
    }
    for (const SmaaPreset& preset : SmaaPresets()) {
        methods.push_back(Filtered("smaa " + preset.name, 2 * preset.options.search_steps + 3,
                                   [options = preset.options](const Image<Rgb>& picture) {
                                       return SmaaFiltered(picture, options);
                                   }));
    }
    for (int m = 2; m <= kMaxEnlargement; ++m) methods.push_back(GridCoverage(m));
    for (int m = 2; m <= 4; ++m) {
        const SampleMetrics all = OneConstant(m * m);
        SampleMetrics shading = all;
        shading.use_depth = shading.use_normals = false;
        const std::string size = std::to_string(m);
        methods.push_back(AdaptiveCoverage("adaptive " + size, m, all));
        methods.push_back(AdaptiveCoverage("shading " + size, m, shading));
    }
    return methods;
}

}  // namespace plumb
