#include "tests/architecture/includes.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace plumb {
namespace {

using Words = std::set<std::string>;

struct Library {
    std::string prefix;  ///< Of its headers.
    Words rooms;         ///< Where its headers may appear.
    Words header_rooms;  ///< Where they may appear in a header too.
};

const std::vector<Library> kLibraries{
    {"Eigen/", {Rooms().begin(), Rooms().end()}, {Rooms().begin(), Rooms().end()}},
    {"nlohmann/json_fwd.hpp", {"io", "reports"}, {"io", "reports"}},  // declarations only
    {"nlohmann/", {"io", "reports"}, {}},
    {"OpenImageIO/", {"io"}, {}},
    {"assimp/", {"io"}, {}},
    {"openssl/", {"io"}, {}},
    {"tiffio.h", {"io"}, {}},
    {"embree3/", {"rays"}, {}},
    {"ceres/", {"fit"}, {}},
    {"hwy/", {"heightfield", "formfactor", "rays", "screen_space"}, {}},
    {"oneapi/tbb/", {"core"}, {}},
    {"CLI/", {"app"}, {"app"}},  // nobody includes app/, so it goes no further
    // Of the system: files, terminals and signals. Kernels know none of them.
    {"dlfcn.h", {"io"}, {}},  // whose code a sanitizer complains of
    {"unwind.h", {"io"}, {}},
    {"fcntl.h", {"io", "app"}, {}},
    {"poll.h", {"io"}, {}},
    {"sys/", {"io", "app"}, {}},
    {"unistd.h", {"io", "app"}, {}},
    {"xmmintrin.h", {"rays"}, {}},  // Embree's users are to flush denormals to zero
};

std::string RoomOf(const std::string& path) {
    return path.substr(0, path.find('/'));
}

bool IsStandard(const std::string& header) {
    return header.find_first_of("/.") == std::string::npos;
}

/// Why `file` may not include <header>; empty if it may.
std::string WhyNot(const SourceFile& file, const std::string& header) {
    if (IsStandard(header)) return {};
    const auto library = std::find_if(
        kLibraries.begin(), kLibraries.end(),
        [&](const Library& candidate) { return header.starts_with(candidate.prefix); });
    const std::string room = RoomOf(file.path);
    if (library == kLibraries.end()) return "a library that no room is named for";
    if (!library->rooms.contains(room)) return "a library of another room";
    if (file.path.ends_with(".h") && !library->header_rooms.contains(room)) {
        return "a library that must stay in .cpp files";
    }
    return {};
}

/// Why `file` may not include "header"; empty if it may.
std::string WhyNotOurs(const SourceFile& file, const std::string& header) {
    const std::string from = RoomOf(file.path), to = RoomOf(header);
    if (header.find('/') == std::string::npos || !MayInclude().contains(to)) {
        return "a path that does not start with a room";
    }
    if (to != from && !MayInclude().at(from).contains(to)) return from + " may not see " + to;
    return {};
}

}  // namespace

// Who may include whom, besides itself. The judge (truth) shares nothing with the judged
// (screen_space, formfactor, heightfield) but core and rays: a slip in a shared kernel would cancel.
const std::map<std::string, Words>& MayInclude() {
    static const std::map<std::string, Words> may{
        {"core", {}},
        {"io", {"core"}},
        {"scenes", {"core"}},
        {"heightfield", {"core"}},
        {"formfactor", {"core", "heightfield"}},
        {"rays", {"core"}},
        {"screen_space", {"core"}},
        {"techniques", {"core", "rays", "screen_space"}},
        {"truth", {"core", "rays"}},
        {"fit", {"core"}},
        {"score", {"core"}},
        {"reports", {"core", "fit", "score"}},
        {"jobs",
         {"core", "io", "scenes", "heightfield", "formfactor", "rays", "screen_space",
          "techniques", "truth", "fit", "score", "reports"}},
        {"app", {"core", "jobs"}},  // core: errors and the monitor, which every job speaks
    };
    return may;
}

std::vector<std::string> ForbiddenIncludes(const SourceFile& file) {
    std::vector<std::string> forbidden;
    std::istringstream lines(file.text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        std::istringstream words(line);
        std::string directive, header;
        words >> directive >> header;
        if (directive != "#include" || header.size() < 3) continue;
        const std::string name = header.substr(1, header.size() - 2);
        const std::string why =
            header.front() == '<' ? WhyNot(file, name) : WhyNotOurs(file, name);
        if (!why.empty()) {
            forbidden.push_back(file.path + ":" + std::to_string(number) + ": includes " +
                                header + ": " + why);
        }
    }
    return forbidden;
}

}  // namespace plumb
