// What can be judged, as text.
#pragma once

#include <string>

namespace plumb {

enum class TechniquesForm { kText, kJson, kMarkdown };

/// All techniques, or that of the name. Throws Error, with the names, if there is none.
std::string TechniquesText(const std::string& name, TechniquesForm form);

}  // namespace plumb
