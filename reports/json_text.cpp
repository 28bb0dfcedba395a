#include "reports/json_text.h"

#include <nlohmann/json.hpp>

namespace plumb {

std::string JsonText(const nlohmann::ordered_json& json) {
    return json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace)
        .append("\n");
}

}  // namespace plumb
