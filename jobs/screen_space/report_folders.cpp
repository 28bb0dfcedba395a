#include "jobs/screen_space/report_folders.h"

#include <algorithm>

#include "core/error.h"
#include "io/short_name.h"

namespace plumb {
namespace {

std::string NameOf(const std::string& scene, bool with_folder) {
    const std::filesystem::path path(scene);
    std::string name = path.stem().string();
    if (with_folder) {
        const std::string folder = std::filesystem::absolute(path)
                                       .lexically_normal()
                                       .parent_path()
                                       .filename()
                                       .string();
        name = folder + "-" + name;
    }
    std::replace(name.begin(), name.end(), ':', '-');
    return ShortName(name, name);
}

}  // namespace

std::vector<std::filesystem::path> ReportFolders(
    std::span<const std::string> scenes, const std::optional<std::filesystem::path>& out) {
    if (scenes.size() == 1 && out) return {*out};
    std::vector<std::filesystem::path> folders;
    for (const std::string& scene : scenes) {
        const bool is_shared = std::ranges::count_if(scenes, [&](const std::string& other) {
                                   return NameOf(other, false) == NameOf(scene, false);
                               }) > 1;
        const std::string name = NameOf(scene, is_shared);
        folders.push_back(out ? *out / name
                              : std::filesystem::path("out") / ("report-" + name));
    }
    for (std::size_t k = 0; k < folders.size(); ++k) {
        for (std::size_t other = 0; other < k; ++other) {
            if (folders[k] != folders[other]) continue;
            throw Error("scenes " + scenes[other] + " and " + scenes[k] +
                        " would both be written to " + folders[k].string() +
                        ": report them one by one, each with its own --out");
        }
    }
    return folders;
}

}  // namespace plumb
