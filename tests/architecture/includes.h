// Which file may include what: rooms go one way, a library stays in its room.
#pragma once

#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace plumb {

/// What a file includes against the rules, as "fit/model.h:7: includes ..."; empty if all is
/// well.
std::vector<std::string> ForbiddenIncludes(const SourceFile& file);

}  // namespace plumb
