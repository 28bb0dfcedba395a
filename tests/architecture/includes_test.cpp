#include "tests/architecture/includes.h"

#include <gmock/gmock.h>

#include <sstream>

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Includes, EveryRoomSeesOnlyWhatItMay) {
    int files = 0;
    for (const SourceFile& file : RoomSources()) {
        EXPECT_THAT(ForbiddenIncludes(file), IsEmpty());
        ++files;
    }
    EXPECT_GT(files, 50);  // or the search looked in the wrong place
}

std::vector<std::string> In(const char* path, const char* text) {
    return ForbiddenIncludes({path, text});
}

TEST(Includes, ARoomSeesItselfAndThoseItMay) {
    EXPECT_THAT(
        In("formfactor/links.h", "#include \"formfactor/a.h\"\n#include \"heightfield/b.h\"\n"),
        IsEmpty());
    EXPECT_THAT(In("truth/a.cpp", "\n#include \"heightfield/b.h\""),
                ElementsAre("truth/a.cpp:2: includes \"heightfield/b.h\": truth may not see "
                            "heightfield"));
    EXPECT_THAT(In("core/a.h", "  #include \"io/b.h\" // why"),
                ElementsAre("core/a.h:1: includes \"io/b.h\": core may not see io"));
    EXPECT_THAT(In("fit/a.h", "#include \"model.h\""),
                ElementsAre("fit/a.h:1: includes \"model.h\": a path that does not start with "
                            "a room"));
}

TEST(Includes, ALibraryStaysInItsRoom) {
    EXPECT_THAT(In("fit/a.cpp", "#include <ceres/ceres.h>\n#include <vector>\n"), IsEmpty());
    EXPECT_THAT(In("fit/a.h", "#include <Eigen/Core>\n"), IsEmpty());
    EXPECT_THAT(In("io/a.h", "#include <nlohmann/json_fwd.hpp>\n"), IsEmpty());
    EXPECT_THAT(In("jobs/a.cpp", "#include <ceres/ceres.h>"),
                ElementsAre("jobs/a.cpp:1: includes <ceres/ceres.h>: a library of another "
                            "room"));
    EXPECT_THAT(In("io/a.h", "#include <nlohmann/json.hpp>"),
                ElementsAre("io/a.h:1: includes <nlohmann/json.hpp>: a library that must stay "
                            "in .cpp files"));
    EXPECT_THAT(In("io/a.cpp", "#include <boost/any.hpp>"),
                ElementsAre("io/a.cpp:1: includes <boost/any.hpp>: a library that no room is "
                            "named for"));
}

// Rooms of a cell such as "heightfield, core".
std::set<std::string> RoomsIn(const std::string& cell) {
    std::set<std::string> rooms;
    std::istringstream words(cell);
    for (std::string word; words >> word;) {
        rooms.insert(word.substr(0, word.find(',')));
    }
    return rooms;
}

TEST(Includes, TheTableOfRoomsInTheDocsIsTheRule) {
    std::map<std::string, std::set<std::string>> told;
    std::istringstream page(TextOf("docs/building.md"));
    for (std::string line; std::getline(page, line);) {
        if (!line.starts_with("| `")) continue;
        std::vector<std::string> cells;  // "", room, what is in it, may include, library
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
        if (cells.size() != 5) continue;  // the table of presets
        told[cells[1].substr(2, cells[1].size() - 4)] = RoomsIn(cells[3]);
    }
    EXPECT_EQ(told, MayInclude());
}

}  // namespace
}  // namespace plumb
