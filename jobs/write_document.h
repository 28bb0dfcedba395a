// A document as the files that a job leaves in its folder.
#pragma once

#include <filesystem>

#include "reports/render.h"

namespace plumb {

/// report.html, report.json and report.csv, each whole or not at all. Returns the page's path.
std::filesystem::path WriteDocument(const std::filesystem::path& folder,
                                    const doc::Document& document);

}  // namespace plumb
