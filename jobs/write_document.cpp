#include "jobs/write_document.h"

#include "io/whole_file.h"

namespace plumb {

std::filesystem::path WriteDocument(const std::filesystem::path& folder,
                                    const doc::Document& document, const std::string& name) {
    const std::filesystem::path page = folder / (name + ".html");
    WriteWholeFile(page, doc::ToHtml(document));
    WriteWholeFile(folder / (name + ".json"), doc::ToJsonText(document));
    WriteWholeFile(folder / (name + ".csv"), doc::ToCsv(document));
    return page;
}

}  // namespace plumb
