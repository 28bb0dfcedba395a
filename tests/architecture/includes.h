// Which file may include what: rooms go one way, a library stays in its room.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace plumb {

/// Who may include whom, besides itself: room -> rooms.
const std::map<std::string, std::set<std::string>>& MayInclude();

/// What a file includes against the rules, as "fit/model.h:7: includes ..."; empty if all is
/// well.
std::vector<std::string> ForbiddenIncludes(const SourceFile& file);

}  // namespace plumb
