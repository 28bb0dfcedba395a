// Files that are compiled into the program, so that every page is one file that opens offline.
#pragma once

#include <string_view>

namespace plumb {

std::string_view ChartJs();  ///< Chart.js whole, with its licence, as installed at build time.
std::string_view PageJs();   ///< reports/page.js
std::string_view PageCss();  ///< reports/page.css

}  // namespace plumb
