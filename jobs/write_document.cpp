#include "jobs/write_document.h"

#include "io/whole_file.h"

namespace plumb {

std::filesystem::path WriteDocument(const std::filesystem::path& folder,
                                    const doc::Document& document) {
    const std::filesystem::path page = folder / "report.html";
    WriteWholeFile(page, doc::ToHtml(document));
    WriteWholeFile(folder / "report.json", doc::ToJsonText(document));
    WriteWholeFile(folder / "report.csv", doc::ToCsv(document));
    return page;
}

}  // namespace plumb
