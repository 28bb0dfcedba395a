#include "jobs/light/fit_surfaces.h"

#include <filesystem>
#include <map>
#include <set>

#include "jobs/write_results.h"

namespace plumb {
namespace {

/// The folder that an image lies in, without those above it; empty for a surface made.
std::string FolderOf(const Surface& surface, const std::string& name) {
    if (surface.source.file.empty()) return {};
    const std::filesystem::path folder = std::filesystem::path(name).parent_path();
    return folder.filename().string();
}

}  // namespace

std::vector<Surface> LoadSurfaces(std::span<const std::string> names,
                                  const SurfaceOptions& options) {
    std::vector<Surface> surfaces;
    std::map<std::string, int> shared;
    for (const std::string& name : names) {
        surfaces.push_back(LoadSurface(name, options));
        ++shared[FileNamePart(surfaces.back().source.name)];
    }
    std::set<std::string> taken;
    for (std::size_t m = 0; m < surfaces.size(); ++m) {
        std::string& name = surfaces[m].source.name;
        const std::string folder = FolderOf(surfaces[m], names[m]);
        if (shared[FileNamePart(name)] > 1 && !folder.empty()) name.insert(0, folder + "/");
        const std::string base = name;
        for (int number = 2; !taken.insert(FileNamePart(name)).second; ++number) {
            name = base + " " + std::to_string(number);
        }
    }
    return surfaces;
}

}  // namespace plumb
