#include "tests/architecture/source_tree.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace plumb {

namespace fs = std::filesystem;

const std::vector<std::string>& Rooms() {
    static const std::vector<std::string> rooms{
        "core",       "io",    "scenes", "heightfield", "formfactor", "rays", "screen_space",
        "techniques", "truth", "fit",    "score",       "reports",    "jobs", "app"};
    return rooms;
}

std::vector<SourceFile> SourcesOf(const std::string& folder) {
    const fs::path root = PLUMB_SOURCE_DIR;
    std::vector<SourceFile> files;
    if (!fs::exists(root / folder)) return files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder)) {
        const fs::path& path = entry.path();
        if (path.extension() != ".h" && path.extension() != ".cpp") continue;
        const std::string name = path.lexically_relative(root).generic_string();
        files.push_back({name, TextOf(name)});
    }
    std::sort(files.begin(), files.end(),
              [](const SourceFile& a, const SourceFile& b) { return a.path < b.path; });
    return files;
}

std::vector<SourceFile> RoomSources() {
    std::vector<SourceFile> files;
    for (const std::string& room : Rooms()) {
        for (SourceFile& file : SourcesOf(room)) files.push_back(std::move(file));
    }
    return files;
}

std::string TextOf(const std::string& path) {
    std::ifstream file(fs::path(PLUMB_SOURCE_DIR) / path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace plumb
