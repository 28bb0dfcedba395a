#include "jobs/write_results.h"

#include <cctype>
#include <utility>

#include "core/total_name.h"
#include "heightfield/facet.h"
#include "io/data_uri.h"
#include "io/histogram_io.h"
#include "io/image_io.h"
#include "io/short_name.h"
#include "io/whole_file.h"
#include "jobs/light/fit_constants.h"
#include "jobs/pictures.h"
#include "reports/render.h"
#include "reports/shader_header.h"

namespace plumb {
namespace {

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
    return ShortName(part, name);
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

void WriteFitTables(const std::filesystem::path& folder, const FitReport& report,
                    const doc::Document& document) {
    WriteWholeFile(folder / "constants.csv", ToCsv(ConstantsTable(report)));
    if (report.formulas.empty()) return;
    WriteWholeFile(folder / "scores.csv", ToCsv(doc::TableOf(document, "scores")));
    if (report.choice)
        WriteWholeFile(folder / "choice.csv", ToCsv(doc::TableOf(document, "forms")));
    const ShaderHeader header = ShaderHeaderOf(report);
    for (const ShaderLanguage language :
         {ShaderLanguage::kGlsl, ShaderLanguage::kHlsl, ShaderLanguage::kCpp}) {
        WriteWholeFile(folder / ("plumb_light." + Extension(language)),
                       WriteShaderHeader(header, language));
    }
}

void WriteHistograms(const std::filesystem::path& folder, const SurfaceReport& surface) {
    for (const auto& [name, histogram] : {std::pair{"histogram_alpha", &surface.over_alpha},
                                          std::pair{"histogram_v", &surface.over_V}}) {
        WriteHistogramJson(folder / (std::string(name) + ".json"), *histogram);
        WriteHistogramCsv(folder / (std::string(name) + ".csv"), *histogram);
    }
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
