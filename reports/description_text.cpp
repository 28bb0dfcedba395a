#include "reports/description_text.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "reports/json_text.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

std::string Padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size() + 2, width), ' ');
    return text;
}

std::string PaperOf(const Description& technique) {
    return technique.paper.empty() ? "" : " [" + technique.paper + "]";
}

// "beta [m]": the paper's symbol and the unit.
std::string SymbolAndUnit(const Knob& knob) {
    std::string text = knob.symbol;
    if (!knob.unit.empty()) text += (text.empty() ? "[" : " [") + knob.unit + "]";
    return text;
}

Json KnobJson(const Knob& knob) {
    Json json{{"name", knob.name}, {"meaning", knob.meaning}};
    if (knob.IsSwitch()) {
        json["published"] = knob.published != 0;
        return json;
    }
    json["symbol"] = knob.symbol;
    json["unit"] = knob.unit;
    if (knob.kind == Knob::Kind::kChoice) {
        json["kind"] = "choice";
        json["choices"] = knob.choices;
        json["published"] = TextOf(knob, knob.published);
        return json;
    }
    json["kind"] = knob.kind == Knob::Kind::kWhole ? "whole" : "number";
    json["low"] = knob.low;
    json["low_included"] = !knob.low_is_out;
    json["high"] = std::isinf(knob.high) ? Json(nullptr) : Json(knob.high);  // null: unbounded
    json["high_included"] = !knob.high_is_out;
    json["published"] = knob.published;
    return json;
}

std::vector<std::vector<Description>> ByFamily(std::span<const Description> techniques) {
    std::vector<std::vector<Description>> families;
    for (const Description& one : techniques) {
        if (families.empty() || families.back().front().family != one.family) {
            families.emplace_back();
        }
        families.back().push_back(one);
    }
    return families;
}

std::string FamilyMarkdown(const std::vector<Description>& members) {
    std::string page = "\n## `" + members.front().family + "`\n\n";
    for (const Description& one : members) {
        page += "- `" + one.name + "`: " + one.what + PaperOf(one) + "\n";
    }
    page += "\n| knob | symbol | domain | meaning |";
    std::string line = "| --- | --- | --- | --- |";
    for (const Description& one : members) {
        page += " `" + one.name + "` |";
        line += " --- |";
    }
    page += "\n" + line + "\n";
    for (const Knob& knob : members.front().knobs) {
        page += "| `" + knob.name + "` | " + SymbolAndUnit(knob) + " | " + RuleOf(knob) +
                " | " + knob.meaning + " |";
        for (const Description& one : members) {
            page += " " + TextOf(knob, ValueOf(one, {}, knob.name)) + " |";
        }
        page += "\n";
    }
    return page;
}

}  // namespace

std::string ListText(std::span<const Description> techniques) {
    std::string text;
    for (const Description& one : techniques) {
        text += Padded(one.name, 20) + one.what + PaperOf(one) + "\n";
    }
    return text;
}

std::string DescriptionText(const Description& technique) {
    std::string text = technique.name + ": " + technique.what + PaperOf(technique) + "\n";
    for (const Knob& knob : technique.knobs) {
        text += "  " + Padded(knob.name + " = " + TextOf(knob, knob.published), 34) +
                knob.meaning + "; " + RuleOf(knob) +
                (knob.unit.empty() ? "" : " [" + knob.unit + "]") + "\n";
    }
    return text;
}

std::string DescriptionsJson(std::span<const Description> techniques) {
    Json list = Json::array();
    for (const Description& one : techniques) {
        Json knobs = Json::array(), switches = Json::array();
        for (const Knob& knob : one.knobs) {
            (knob.IsSwitch() ? switches : knobs).push_back(KnobJson(knob));
        }
        list.push_back({{"name", one.name},
                        {"family", one.family},
                        {"paper", one.paper},
                        {"what", one.what},
                        {"knobs", knobs},
                        {"switches", switches}});
    }
    return JsonText({{"format", "plumb techniques 1"}, {"techniques", list}});
}

std::string DescriptionsMarkdown(std::span<const Description> techniques) {
    std::string page =
        "# Techniques\n\n"
        "All that can be judged, as `plumb techniques --markdown` prints it. A knob is set "
        "with\n"
        "`--set NAME.KNOB=VALUE`, or in the entry of a technique of a scene file "
        "(docs/scenes.md).\n"
        "The command line wins over the file, the file over the value below; `radius_m` is "
        "1.5\n"
        "for every technique where neither names one.\n";
    for (const std::vector<Description>& members : ByFamily(techniques)) {
        page += FamilyMarkdown(members);
    }
    return page;
}

}  // namespace plumb
