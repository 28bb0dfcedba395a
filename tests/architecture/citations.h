// What the code cites: equations as "[Mayaux18 eq. 7]", papers as "[Jimenez16]"; and the pages
// that list them, docs/equations.md and docs/references.bib.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/architecture/source_tree.h"

namespace plumb {

/// Equations that `text` cites, as "Mayaux18 eq. 7"; a citation may run on in the next line of
/// a comment.
std::set<std::string> EquationsIn(const std::string& text);

/// Citations of equations in another form, which the page could not be held against.
std::vector<std::string> MisshapenEquationsIn(const std::string& text);

/// Keys of papers that `text` cites, with or without an equation.
std::set<std::string> PapersIn(const std::string& text);

/// Keys of the entries of a .bib file.
std::set<std::string> BibKeysIn(const std::string& bib);

/// A row of docs/equations.md: | paper | eq. | says | code | test |
struct EquationRow {
    std::string equation;            ///< "Mayaux18 eq. 7".
    std::vector<std::string> files;  ///< Paths in the cell "code".
    std::vector<std::string> tests;  ///< "Suite.Name" in the cell "test".
};
std::vector<EquationRow> EquationRowsIn(const std::string& page);

/// "Suite.Name" of every test case that `text` defines.
std::set<std::string> TestsIn(const std::string& text);

}  // namespace plumb
