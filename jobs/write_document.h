// A document as the files that a job leaves in its folder.
#pragma once

#include <filesystem>
#include <string>

#include "reports/render.h"

namespace plumb {

/// NAME.html, NAME.json and NAME.csv, each whole or not at all. Returns the page's path.
std::filesystem::path WriteDocument(const std::filesystem::path& folder,
                                    const doc::Document& document,
                                    const std::string& name = "report");

}  // namespace plumb
