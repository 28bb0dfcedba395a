#include "jobs/write_results.h"

#include <cctype>
#include <sstream>
#include <utility>

#include "core/total_name.h"
#include "heightfield/facet.h"
#include "io/data_uri.h"
#include "io/histogram_io.h"
#include "io/image_io.h"
#include "io/whole_file.h"
#include "jobs/light/fit_constants.h"
#include "jobs/pictures.h"
#include "reports/shader_header.h"

namespace plumb {
namespace {

template <class Write>
void WriteText(const std::filesystem::path& path, Write&& write) {
    std::ostringstream text;
    write(text);
    WriteWholeFile(path, text.str());
}

/// Mean height of every facet: what stands in the middle of its three corners.
std::vector<double> FacetHeightsM(const HeightField& field) {
    std::vector<double> heights_m(std::size_t(field.Facets()));
    for (std::int64_t i = 0; i < field.Facets(); ++i) {
        heights_m[std::size_t(i)] = FacetOf(field, i).CentroidM().z();
    }
    return heights_m;
}

}  // namespace

std::string FileNamePart(const std::string& name) {
    std::string part;
    for (const char c : name) {
        part += std::isalnum(static_cast<unsigned char>(c))
                    ? char(std::tolower(static_cast<unsigned char>(c)))
                    : '_';
    }
    return part;
}

void WritePictures(const std::filesystem::path& folder, const HeightField& field,
                   std::span<const double> V, SurfaceReport& report) {
    const std::string part = FileNamePart(report.name);
    const std::filesystem::path relief = folder / (part + "_relief.png");
    const std::filesystem::path visibility = folder / (part + "_v.png");
    WritePreview(relief, ShadedRelief(field));
    WritePreview(visibility, CellImage(field, V));
    report.heights_picture = PngDataUri(relief);
    report.visibility_picture = PngDataUri(visibility);
}

std::filesystem::path WriteFitResults(const std::filesystem::path& folder,
                                      const FitReport& report) {
    const std::filesystem::path page = folder / "report.html";
    WriteWholeFile(page, ToHtml(report));
    WriteWholeFile(folder / "report.json", ToJsonText(report));
    WriteText(folder / "scores.csv", [&](std::ostream& out) { WriteScoresCsv(out, report); });
    WriteText(folder / "constants.csv",
              [&](std::ostream& out) { WriteConstantsCsv(out, report); });
    if (report.choice)
        WriteText(folder / "choice.csv",
                  [&](std::ostream& out) { WriteChoiceCsv(out, report); });
    const ShaderHeader header = ShaderHeaderOf(report);
    for (const ShaderLanguage language :
         {ShaderLanguage::kGlsl, ShaderLanguage::kHlsl, ShaderLanguage::kCpp}) {
        WriteWholeFile(folder / ("plumb_light." + Extension(language)),
                       WriteShaderHeader(header, language));
    }
    return page;
}

void WriteCurveResults(const std::filesystem::path& folder, const FitReport& report) {
    WriteWholeFile(folder / "curves.json", ToJsonText(report));
    WriteText(folder / "constants.csv",
              [&](std::ostream& out) { WriteConstantsCsv(out, report); });
}

std::filesystem::path WriteSimulateResults(const std::filesystem::path& folder,
                                           const SimulateReport& report) {
    const std::filesystem::path page = folder / "report.html";
    WriteWholeFile(page, ToHtml(report));
    WriteWholeFile(folder / "report.json", ToJsonText(report));
    const SurfaceReport& surface = report.surface;
    for (const auto& [name, histogram] : {std::pair{"histogram_alpha", &surface.over_alpha},
                                          std::pair{"histogram_v", &surface.over_V}}) {
        WriteHistogramJson(folder / (std::string(name) + ".json"), *histogram);
        WriteHistogramCsv(folder / (std::string(name) + ".csv"), *histogram);
    }
    return page;
}

void WriteLightMaps(const std::filesystem::path& folder, const Surface& surface,
                    const SurfaceLight& light, const std::vector<std::vector<float>>& bounces) {
    const HeightField& field = surface.field;
    std::vector<NamedChannel> channels;
    channels.push_back({"height_m", CellImage(field, FacetHeightsM(field))});
    channels.push_back({"alpha", CellImage(field, light.alpha)});
    channels.push_back({"V", CellImage(field, light.V)});
    const auto add = [&](const std::string& name, const std::vector<float>& values) {
        const std::vector<double> wide(values.begin(), values.end());
        channels.push_back({name, CellImage(field, wide)});
    };
    for (std::size_t k = 0; k < bounces.size(); ++k) add("E_" + std::to_string(k), bounces[k]);
    for (std::size_t r = 0; r < light.total.size(); ++r) {
        add(TotalName(Albedo(light.albedos[r])), light.total[r]);
    }
    WriteExr(folder / "light.exr", channels,
             {{"map", surface.source.name},
              {"sha256", surface.source.sha256},
              {"pixel", "mean of the two facets of a cell, centre at ((i + 1) s, (j + 1) s)"}});
}

}  // namespace plumb
