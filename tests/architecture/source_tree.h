// The source files of the project, as text.
#pragma once

#include <string>
#include <vector>

namespace plumb {

struct SourceFile {
    std::string path;  ///< From the root of the project: "fit/model.h".
    std::string text;
};

/// The folders that make up the program, from the bottom to the top.
const std::vector<std::string>& Rooms();

/// Every .h and .cpp file below a folder, in the order of the paths; empty if there is no such
/// folder yet.
std::vector<SourceFile> SourcesOf(const std::string& folder);

/// Of all rooms.
std::vector<SourceFile> RoomSources();

/// A file by its path from the root of the project; empty if there is none.
std::string TextOf(const std::string& path);

}  // namespace plumb
