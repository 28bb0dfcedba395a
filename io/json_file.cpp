#include "io/json_file.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/error.h"
#include "core/names.h"
#include "io/whole_file.h"

namespace plumb {
namespace {

using Json = nlohmann::ordered_json;

/// "line:column" of the byte that a parser stumbled on, counted from 1.
std::string Position(std::string_view text, std::size_t byte) {
    const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
    const auto line = std::count(before.begin(), before.end(), '\n') + 1;
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    return std::to_string(line) + ":" + std::to_string(before.size() - line_start + 1);
}

/// A value as errors quote it, cut if long.
std::string Quote(const Json& value) {
    const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.size() <= 60 ? text : text.substr(0, 57) + "...";
}

[[noreturn]] void Refuse(const std::string& name, const Json& value, const std::string& rule) {
    throw Error(name + " = " + Quote(value) + ", must be " + rule);
}

double CheckedNumber(const Json& value, const std::string& name, const NumberRule& rule) {
    if (!value.is_number()) Refuse(name, value, std::string("a number, ") + rule.text);
    const double number = value.get<double>();
    if (!std::isfinite(number) || !rule.holds(number)) Refuse(name, value, rule.text);
    return number;
}

}  // namespace

Json ParseJson(std::string_view text, const std::string& name) {
    std::vector<std::set<std::string>> fields;  // of the objects that are open, by depth
    const auto note = [&](int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::object_start) fields.emplace_back();
        if (event == Json::parse_event_t::object_end) fields.pop_back();
        if (event == Json::parse_event_t::key &&
            !fields.back().insert(parsed.get<std::string>()).second) {
            throw Error(name + ": field " + parsed.dump() + " is given twice");
        }
        return true;
    };
    try {
        return Json::parse(text, note);
    } catch (const Json::parse_error& error) {
        // "[json.exception.parse_error.101] parse error at line 1, column 5: what"
        const std::string what = error.what();
        const std::size_t colon = what.find(": ");
        throw Error(name + ":" + Position(text, error.byte) + ": no JSON: " +
                    (colon == std::string::npos ? what : what.substr(colon + 2)));
    } catch (const Json::out_of_range& error) {
        throw Error(name + ": a number is too large for a double");
    }
}

Json ReadJsonFile(const std::filesystem::path& path) {
    return ParseJson(ReadWholeFile(path), path.string());
}

void WriteJsonFile(const std::filesystem::path& path, const Json& json) {
    // File names may be any bytes; what is no UTF-8 is replaced rather than thrown at.
    WriteWholeFile(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

JsonFields::JsonFields(const Json& object, std::string file, std::string at)
    : object_(object), file_(std::move(file)), at_(std::move(at)) {
    if (!object.is_object()) {
        Refuse(file_ + (at_.empty() ? "" : ": " + at_), object, "an object { ... }");
    }
}

std::string JsonFields::NameOf(const std::string& field) const {
    return file_ + ": " + (at_.empty() ? "" : at_ + ".") + field;
}

bool JsonFields::IsList(const char* field) const {
    const auto found = object_.find(field);
    return found != object_.end() && found->is_array();
}

const Json* JsonFields::Find(const char* field) {
    if (std::find(asked_.begin(), asked_.end(), field) == asked_.end()) {
        asked_.emplace_back(field);
    }
    const auto found = object_.find(field);
    return found == object_.end() ? nullptr : &*found;
}

std::optional<double> JsonFields::Number(const char* field, const NumberRule& rule) {
    const Json* value = Find(field);
    if (value == nullptr) return std::nullopt;
    return CheckedNumber(*value, NameOf(field), rule);
}

std::optional<bool> JsonFields::Flag(const char* field) {
    const Json* value = Find(field);
    if (value == nullptr) return std::nullopt;
    if (!value->is_boolean()) Refuse(NameOf(field), *value, "true or false");
    return value->get<bool>();
}

std::optional<std::string> JsonFields::Text(const char* field) {
    const Json* value = Find(field);
    if (value == nullptr) return std::nullopt;
    if (!value->is_string()) Refuse(NameOf(field), *value, "a text \"...\"");
    return value->get<std::string>();
}

std::optional<std::string> JsonFields::OneOf(const char* field,
                                             const std::vector<std::string>& choices) {
    const Json* value = Find(field);
    if (value == nullptr) return std::nullopt;
    if (!value->is_string() ||
        std::find(choices.begin(), choices.end(), value->get<std::string>()) == choices.end()) {
        throw Error(NameOf(field) + " = " + Quote(*value) + ", " +
                    MustBeOneOf(value->is_string() ? value->get<std::string>() : "", choices));
    }
    return value->get<std::string>();
}

std::optional<std::vector<double>> JsonFields::Numbers(const char* field,
                                                       const NumberRule& rule) {
    const Json* list = List(field);
    if (list == nullptr) return std::nullopt;
    std::vector<double> numbers;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const std::string name = NameOf(field) + "[" + std::to_string(i) + "]";
        numbers.push_back(CheckedNumber((*list)[i], name, rule));
    }
    return numbers;
}

const Json* JsonFields::List(const char* field) {
    const Json* value = Find(field);
    if (value != nullptr && !value->is_array()) Refuse(NameOf(field), *value, "a list [ ... ]");
    return value;
}

template <class T>
T JsonFields::Need(const char* field, std::optional<T> value) const {
    if (!value) throw Error(NameOf(field) + " is missing");
    return *std::move(value);
}

double JsonFields::NeedNumber(const char* field, const NumberRule& rule) {
    return Need(field, Number(field, rule));
}

std::int64_t JsonFields::NeedCount(const char* field) {
    NeedNumber(field, kNotNegative);
    const Json& value = *Find(field);
    if (!value.is_number_integer()) Refuse(NameOf(field), value, "a whole number");
    return value.get<std::int64_t>();
}

std::string JsonFields::NeedText(const char* field) {
    return Need(field, Text(field));
}

std::string JsonFields::NeedOneOf(const char* field, const std::vector<std::string>& choices) {
    return Need(field, OneOf(field, choices));
}

std::vector<double> JsonFields::NeedNumbers(const char* field, const NumberRule& rule) {
    return Need(field, Numbers(field, rule));
}

const Json& JsonFields::NeedList(const char* field) {
    const Json* list = List(field);
    if (list == nullptr) throw Error(NameOf(field) + " is missing");
    return *list;
}

std::map<std::string, std::string> JsonFields::OtherScalars() {
    std::map<std::string, std::string> scalars;
    for (const auto& [field, value] : object_.items()) {
        if (std::find(asked_.begin(), asked_.end(), field) != asked_.end()) continue;
        asked_.push_back(field);
        if (value.is_boolean()) {
            scalars[field] = value.get<bool>() ? "on" : "off";
        } else if (value.is_string()) {
            scalars[field] = value.get<std::string>();
        } else if (value.is_number()) {
            scalars[field] = value.dump();
        } else {
            Refuse(NameOf(field), value, "a number, a text, true or false");
        }
    }
    return scalars;
}

void JsonFields::Finish() const {
    for (const auto& [field, value] : object_.items()) {
        if (std::find(asked_.begin(), asked_.end(), field) == asked_.end()) {
            throw Error(NameOf(field) + " = " + Quote(value) + ": unknown field, " +
                        MustBeOneOf(field, asked_));
        }
    }
}

}  // namespace plumb
