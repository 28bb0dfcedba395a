#include "tests/reports/json_schema.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <stdexcept>

namespace plumb {
namespace {

using nlohmann::json;

bool IsOf(const json& value, const std::string& type) {
    if (type == "null") return value.is_null();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    throw std::logic_error("schema: type " + type);
}

class Check {
  public:
    explicit Check(const json& root) : root_(root) {}

    std::vector<std::string> errors;

    void Value(const json& schema, const json& value, const std::string& at) {
        static const std::set<std::string> known{
            "$schema", "$defs",    "$ref",       "title", "type",       "const",
            "enum",    "required", "items",      "anyOf", "properties", "additionalProperties",
            "pattern", "minimum",  "description"};
        for (const auto& [keyword, rule] : schema.items()) {
            if (!known.contains(keyword)) throw std::logic_error("schema: " + keyword);
        }
        if (schema.contains("$ref")) Value(Definition(schema["$ref"]), value, at);
        if (schema.contains("type")) Type(schema["type"], value, at);
        if (schema.contains("const") && value != schema["const"]) {
            errors.push_back(at + ": must be " + schema["const"].dump());
        }
        if (schema.contains("enum") && std::find(schema["enum"].begin(), schema["enum"].end(),
                                                 value) == schema["enum"].end()) {
            errors.push_back(at + ": must be one of " + schema["enum"].dump());
        }
        if (schema.contains("anyOf")) AnyOf(schema["anyOf"], value, at);
        if (value.is_string() && schema.contains("pattern") &&
            !std::regex_search(value.get<std::string>(),
                               std::regex(schema["pattern"].get<std::string>()))) {
            errors.push_back(at + ": must match " + schema["pattern"].dump());
        }
        if (value.is_number() && schema.contains("minimum") && value < schema["minimum"]) {
            errors.push_back(at + ": must be >= " + schema["minimum"].dump());
        }
        if (value.is_object()) Members(schema, value, at);
        if (value.is_array() && schema.contains("items")) {
            for (std::size_t i = 0; i < value.size(); ++i) {
                Value(schema["items"], value[i], at + "/" + std::to_string(i));
            }
        }
    }

  private:
    const json& Definition(const std::string& reference) const {
        if (!reference.starts_with("#/$defs/")) throw std::logic_error("schema: " + reference);
        return root_.at("$defs").at(reference.substr(8));
    }

    void Type(const json& type, const json& value, const std::string& at) {
        const json types = type.is_array() ? type : json::array({type});
        for (const json& one : types) {
            if (IsOf(value, one)) return;
        }
        errors.push_back(at + ": must be " + type.dump());
    }

    void AnyOf(const json& schemas, const json& value, const std::string& at) {
        for (const json& one : schemas) {
            Check check(root_);
            check.Value(one, value, at);
            if (check.errors.empty()) return;
        }
        errors.push_back(at + ": must be as one of anyOf");
    }

    void Members(const json& schema, const json& value, const std::string& at) {
        for (const json& name : schema.value("required", json::array())) {
            if (!value.contains(name.get<std::string>())) {
                errors.push_back(at + ": must have " + name.dump());
            }
        }
        const json properties = schema.value("properties", json::object());
        const json others = schema.value("additionalProperties", json(true));
        for (const auto& [name, member] : value.items()) {
            if (properties.contains(name)) {
                Value(properties[name], member, at + "/" + name);
            } else if (others.is_object()) {
                Value(others, member, at + "/" + name);
            } else if (!others.get<bool>()) {
                errors.push_back(at + ": must not have " + name);
            }
        }
    }

    const json& root_;
};

}  // namespace

std::vector<std::string> SchemaErrors(const json& schema, const json& value) {
    Check check(schema);
    check.Value(schema, value, "");
    return check.errors;
}

json PublishedSchema(const std::string& file) {
    std::ifstream in(PLUMB_SOURCE_DIR "/docs/schema/" + file);
    if (!in) throw std::logic_error("docs/schema/" + file + " cannot be read");
    return json::parse(in);
}

}  // namespace plumb
