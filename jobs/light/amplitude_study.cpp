#include "jobs/light/amplitude_study.h"

#include <algorithm>
#include <cmath>

#include "fit/scores.h"
#include "jobs/light/histograms.h"

namespace plumb {

std::string NameOfMiddle(const std::string& name, const HeightField& field, int n) {
    if (field.Width() <= n && field.Height() <= n) return name;
    return name + ", its middle " + std::to_string(std::min(n, field.Width())) + " x " +
           std::to_string(std::min(n, field.Height())) + " texels";
}

std::vector<double> SweptAmplitudes() {
    std::vector<double> shares;
    for (int k = -9; k <= 3; ++k) shares.push_back(std::pow(10.0, k / 3.0));
    return shares;
}

AmplitudeSweep StudyAmplitude(const std::string& name, const HeightField& field,
                              std::span<const double> shares_of_width,
                              const SimulateSettings& settings, const Formula* recommended,
                              const Formula* published, Monitor& monitor) {
    AmplitudeSweep sweep;
    sweep.map = name;
    for (const double share : shares_of_width) {
        const HeightField stretched = WithAmplitude(field, share * field.WidthM());
        SurfaceLight light = SimulateSurface(name, stretched, settings, monitor);
        AmplitudePoint point;
        point.amplitude_m = share * field.WidthM();
        point.amplitude_of_width = share;
        point.figures = light.figures;
        if (recommended) {
            point.recommended_rms =
                ScoreOf(*recommended, HistogramFor(*recommended, light)).rms;
        }
        if (published) {
            point.published_rms = ScoreOf(*published, HistogramFor(*published, light)).rms;
        }
        point.over_alpha = std::move(light.over_alpha);
        sweep.points.push_back(std::move(point));
        monitor.Progress("amplitudes",
                         double(sweep.points.size()) / double(shares_of_width.size()));
    }
    return sweep;
}

}  // namespace plumb
