// JSON files, read strictly: what is misspelt, of the wrong type or out of range is named.
//
//       walls.json:3:17: unexpected '}'                             no JSON
//       walls.json: spacing_m = -1, must be > 0                     out of range
//       walls.json: bins[4].hihg = 0.1: unknown field, must be one of low, high
//
// Beware   A field given twice is an error too: JSON leaves open which one counts.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// `name` is what errors call the text.
nlohmann::ordered_json ParseJson(std::string_view text, const std::string& name);
nlohmann::ordered_json ReadJsonFile(const std::filesystem::path& path);

/// Indented by two, fields in their order, numbers with the digits that read back, what is no
/// UTF-8 replaced, a newline at the end; whole or not at all.
void WriteJsonFile(const std::filesystem::path& path, const nlohmann::ordered_json& json);

/// What a number must be besides finite.
struct NumberRule {
    const char* text;
    bool (*holds)(double);
};
inline constexpr NumberRule kFinite{"finite", [](double) { return true; }};
inline constexpr NumberRule kPositive{"> 0", [](double x) { return x > 0; }};
inline constexpr NumberRule kNotNegative{">= 0", [](double x) { return x >= 0; }};
inline constexpr NumberRule kShare{"in [0, 1]", [](double x) { return 0 <= x && x <= 1; }};

/// The fields of one object; each read takes note of its field's name, and Finish() refuses all
/// others. The object must outlive it.
class JsonFields {
  public:
    /// `file` and `at` name the object in errors: "walls.json" and "", or "bins[4]".
    JsonFields(const nlohmann::ordered_json& object, std::string file, std::string at = "");

    std::optional<double> Number(const char* field, const NumberRule& rule);
    std::optional<bool> Flag(const char* field);
    std::optional<std::string> Text(const char* field);
    std::optional<std::string> OneOf(const char* field,
                                     const std::vector<std::string>& choices);
    std::optional<std::vector<double>> Numbers(const char* field, const NumberRule& rule);
    bool IsList(const char* field) const;

    double NeedNumber(const char* field, const NumberRule& rule);
    std::int64_t NeedCount(const char* field);  ///< A whole number >= 0.
    std::string NeedText(const char* field);
    std::string NeedOneOf(const char* field, const std::vector<std::string>& choices);
    std::vector<double> NeedNumbers(const char* field, const NumberRule& rule);
    const nlohmann::ordered_json& NeedList(const char* field);  ///< To be read on.

    /// All fields that nobody has asked for yet, as text: numbers by digits that read back, true and
    /// false as on and off. Throws Error where one is a list, an object or null.
    std::map<std::string, std::string> OtherScalars();

    /// "walls.json: bins[4].low", the name of a field in errors.
    std::string NameOf(const std::string& field) const;

    /// Throws Error if the object has a field that nobody asked for.
    void Finish() const;

  private:
    const nlohmann::ordered_json* Find(const char* field);
    const nlohmann::ordered_json* List(const char* field);
    template <class T>
    T Need(const char* field, std::optional<T> value) const;

    const nlohmann::ordered_json& object_;
    std::string file_, at_;
    std::vector<std::string> asked_;
};

}  // namespace plumb
