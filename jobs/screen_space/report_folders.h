// Where the reports of several scenes go: a folder each, so that none overwrites another.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace plumb {

/// One folder a scene. Of one scene `out` itself; of several those below it with their names; not
/// given: out/report-NAME. Files of one name, such as a/scene.json and b/scene.json, are told apart
/// by the folders that they are in (a-scene, b-scene). Throws Error, naming both, where that is not
/// enough.
std::vector<std::filesystem::path> ReportFolders(
    std::span<const std::string> scenes, const std::optional<std::filesystem::path>& out);

}  // namespace plumb
