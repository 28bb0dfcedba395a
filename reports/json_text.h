// A JSON document as the text of a file.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace plumb {

/// Indented by one blank a level, with a newline at its end. What is not UTF-8 (a file name may
/// be anything) is replaced; numbers read back to the same double; NaN and infinity are null.
std::string JsonText(const nlohmann::ordered_json& json);

}  // namespace plumb
