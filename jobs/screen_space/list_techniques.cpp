#include "jobs/screen_space/list_techniques.h"

#include <vector>

#include "jobs/screen_space/technique.h"
#include "reports/description_text.h"

namespace plumb {

std::string TechniquesText(const std::string& name, TechniquesForm form) {
    std::vector<Description> wanted;
    if (name.empty()) {
        for (const std::string& each : TechniqueNames()) {
            wanted.push_back(FindTechnique(each).description);
        }
    } else {
        wanted.push_back(FindTechnique(name).description);
    }
    switch (form) {
        case TechniquesForm::kJson:
            return DescriptionsJson(wanted);
        case TechniquesForm::kMarkdown:
            return DescriptionsMarkdown(wanted);
        case TechniquesForm::kText:
            break;
    }
    return name.empty() ? ListText(wanted) : DescriptionText(wanted.front());
}

}  // namespace plumb
