#include "tests/architecture/citations.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace plumb {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::string kPage = "docs/equations.md", kBib = "docs/references.bib";

/// Which files of the rooms cite an equation.
std::map<std::string, std::set<std::string>> FilesByEquation() {
    std::map<std::string, std::set<std::string>> files;
    for (const SourceFile& source : RoomSources()) {
        for (const std::string& equation : EquationsIn(source.text)) {
            files[equation].insert(source.path);
        }
    }
    return files;
}

std::set<std::string> AllTests() {
    std::set<std::string> tests;
    for (const SourceFile& source : SourcesOf("tests")) {
        tests.merge(TestsIn(source.text));
    }
    return tests;
}

TEST(Equations, EveryOneInTheCodeHasItsRow) {
    std::set<std::string> rows;
    for (const EquationRow& row : EquationRowsIn(TextOf(kPage))) {
        EXPECT_TRUE(rows.insert(row.equation).second) << row.equation << " has two rows";
    }
    const auto files = FilesByEquation();
    ASSERT_FALSE(files.empty());
    for (const auto& [equation, paths] : files) {
        EXPECT_TRUE(rows.contains(equation))
            << equation << ", cited in " << *paths.begin() << ", has no row in " << kPage;
    }
}

TEST(Equations, EveryRowNamesCodeThatCitesIt) {
    const auto files = FilesByEquation();
    for (const EquationRow& row : EquationRowsIn(TextOf(kPage))) {
        EXPECT_FALSE(row.files.empty()) << row.equation << ": the cell \"code\" names no file";
        for (const std::string& path : row.files) {
            const auto found = files.find(row.equation);
            EXPECT_TRUE(found != files.end() && found->second.contains(path))
                << row.equation << ": " << path << " does not cite it";
        }
    }
}

TEST(Equations, EveryRowNamesATestThatExists) {
    const std::set<std::string> tests = AllTests();
    ASSERT_GT(tests.size(), 50u);
    for (const EquationRow& row : EquationRowsIn(TextOf(kPage))) {
        EXPECT_FALSE(row.tests.empty()) << row.equation << ": the cell \"test\" names no test";
        for (const std::string& test : row.tests) {
            EXPECT_TRUE(tests.contains(test)) << row.equation << ": no test " << test;
        }
    }
}

// Also in tables of what no paper has.
TEST(Equations, ThePageNamesFilesAndTestsThatExist) {
    const std::string page = TextOf(kPage);
    const std::set<std::string> tests = AllTests();
    std::set<std::string> files;
    for (const SourceFile& source : RoomSources()) files.insert(source.path);
    const std::regex name(
        "`([A-Z][A-Za-z0-9]+\\.[A-Z][A-Za-z0-9]+|[a-z_0-9]+/[a-z_0-9/]+\\.(?:h|cpp))`");
    int named = 0;
    for (std::sregex_iterator it(page.begin(), page.end(), name), end; it != end; ++it) {
        const std::string what = (*it)[1];
        if (what.starts_with("tests/")) continue;
        EXPECT_TRUE(tests.contains(what) || files.contains(what)) << what;
        ++named;
    }
    EXPECT_GT(named, 50);
}

TEST(Equations, AreCitedInOneForm) {
    for (const SourceFile& source : RoomSources()) {
        EXPECT_THAT(MisshapenEquationsIn(source.text), IsEmpty()) << source.path;
    }
}

TEST(References, EveryPaperCitedHasAnEntry) {
    const std::set<std::string> entries = BibKeysIn(TextOf(kBib));
    std::vector<SourceFile> files = RoomSources();
    for (const SourceFile& test : SourcesOf("tests")) {
        if (!test.path.starts_with("tests/architecture/")) files.push_back(test);
    }
    for (const SourceFile& source : files) {
        for (const std::string& key : PapersIn(source.text)) {
            EXPECT_TRUE(entries.contains(key))
                << key << ", cited in " << source.path << ", is not in " << kBib;
        }
    }
}

TEST(EquationsIn, FindsWhatRunsOnInTheNextLine) {
    EXPECT_THAT(EquationsIn("a [Made18 eq. 7] and [Made18\n    /// eq. 12], not [Made18] 3"),
                ElementsAre("Made18 eq. 12", "Made18 eq. 7"));
}

TEST(EquationsIn, OtherFormsAreMisshapen) {
    EXPECT_THAT(MisshapenEquationsIn("[Made18 eq. 7] [Made18, eq. 7] [Made18 eqs. 7, 8] "
                                     "[Made18 eq 7] [Made18 fig. 3]"),
                ElementsAre("[Made18, eq. 7]", "[Made18 eqs. 7, 8]", "[Made18 eq 7]"));
}

TEST(PapersIn, FindsKeysWithAndWithoutAnEquation) {
    EXPECT_THAT(PapersIn("[Made18 eq. 7] [Other03b]\n// [Third99 table 2] x[i] [a12] [E05]"),
                ElementsAre("Made18", "Other03b", "Third99"));
}

TEST(BibKeysIn, FindsTheEntries) {
    EXPECT_THAT(BibKeysIn("@misc{Made18,\n title = {x}}\n@article{Other03b,\n}"),
                ElementsAre("Made18", "Other03b"));
}

TEST(EquationRowsIn, ReadsTheCells) {
    const std::vector<EquationRow> rows = EquationRowsIn(
        "| paper | eq. | says | code | test |\n| --- | --- | --- | --- | --- |\n"
        "| Made18 | 7 | `F0` | `fit/a.h`, `fit/b_c.cpp` | `Suite.Name`, `Other.Case` |\n");
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_EQ(rows[0].equation, "Made18 eq. 7");
    EXPECT_THAT(rows[0].files, ElementsAre("fit/a.h", "fit/b_c.cpp"));
    EXPECT_THAT(rows[0].tests, ElementsAre("Suite.Name", "Other.Case"));
}

TEST(TestsIn, FindsEveryKind) {
    EXPECT_THAT(TestsIn("TEST(A, B) {\nTEST_F(C,\n       D) {\nTEST_P(E, F)\nATEST(G, H)"),
                ElementsAre("A.B", "C.D", "E.F"));
}

}  // namespace
}  // namespace plumb
