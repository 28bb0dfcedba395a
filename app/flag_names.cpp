#include "app/flag_names.h"

#include <map>
#include <regex>

namespace plumb::app {
namespace {

const CLI::App& Called(const CLI::App& program) {
    const auto called = program.get_subcommands();
    return called.empty() ? program : Called(*called.front());
}

// "radius_m" is --radius, "max_spp" --spp, "target_error" --target-error.
std::string FlagOf(const std::string& field, const CLI::App& command) {
    static const std::map<std::string, std::string> kOthers = {
        {"max_spp", "spp"},
        {"max_seconds", "seconds"},
        {"albedos", "albedo"},
        {"replicates", "bootstrap"},
        {"bootstrap_replicates", "bootstrap"},
        {"extent_texels", "cut-texels"},
    };
    std::vector<std::string> names = {field};
    if (const auto other = kOthers.find(field); other != kOthers.end()) {
        names.push_back(other->second);
    }
    names.push_back(std::regex_replace(field, std::regex("_(m|px|texels|rad)$"), ""));
    for (std::string name : names) {
        for (char& c : name) {
            if (c == '_') c = '-';
        }
        if (command.get_option_no_throw("--" + name) != nullptr) return "--" + name;
    }
    return field;
}

}  // namespace

std::string InFlags(const std::string& message, const CLI::App& program) {
    // With its struct anywhere; without one where the message begins.
    static const std::regex kField(R"(\b[A-Z]\w*::([a-z]\w*)|^([a-z]\w*)(?= = ))");
    const CLI::App& command = Called(program);
    std::string text;
    auto from = message.cbegin();
    for (std::sregex_iterator match(message.begin(), message.end(), kField), end; match != end;
         ++match) {
        text.append(from, (*match)[0].first);
        text += FlagOf((*match)[(*match)[1].matched ? 1 : 2], command);
        from = (*match)[0].second;
    }
    return text.append(from, message.cend());
}

}  // namespace plumb::app
