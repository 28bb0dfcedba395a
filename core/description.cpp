#include "core/description.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.h"
#include "core/names.h"

namespace plumb {
namespace {

// The shortest digits that read back to the same bits: "1e7", where the library has "1e+07".
std::string Digits(double value) {
    std::array<char, 32> digits;
    std::string text(digits.data(),
                     std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    const bool negative = text[e + 1] == '-';
    const std::size_t first = text.find_first_not_of("+-0", e + 1);
    return text.substr(0, e + 1) + (negative ? "-" : "") + text.substr(first);
}

std::optional<double> NumberOf(const std::string& text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    if (read.ec != std::errc() || read.ptr != end || std::isnan(value)) return std::nullopt;
    return value;
}

bool HasChoices(const Knob& knob) {
    return knob.kind == Knob::Kind::kChoice || knob.kind == Knob::Kind::kSwitch;
}

}  // namespace

std::string RuleOf(const Knob& knob) {
    if (HasChoices(knob)) return "one of " + Joined(knob.choices);
    const std::string domain = std::string(knob.low_is_out ? "(" : "[") + Digits(knob.low) +
                               ", " + (std::isinf(knob.high) ? "infinity" : Digits(knob.high)) +
                               (knob.high_is_out ? ")" : "]");
    return (knob.kind == Knob::Kind::kWhole ? "a whole number in " : "in ") + domain;
}

bool Allows(const Knob& knob, double value) {
    if (HasChoices(knob)) {
        return value >= 0 && value < double(knob.choices.size()) && value == std::floor(value);
    }
    if (knob.kind == Knob::Kind::kWhole && value != std::floor(value)) return false;
    return (knob.low_is_out ? value > knob.low : value >= knob.low) &&
           (knob.high_is_out ? value < knob.high : value <= knob.high);
}

std::string TextOf(const Knob& knob, double value) {
    return HasChoices(knob) ? knob.choices.at(std::size_t(value)) : Digits(value);
}

double ValueOfText(const Knob& knob, const std::string& text, const std::string& where) {
    const std::string thing = where + " = " + text;
    if (HasChoices(knob)) return double(PlaceOf(text, knob.choices, thing));
    const std::optional<double> value = NumberOf(text);
    if (!value || !Allows(knob, *value)) throw Error(thing + ", must be " + RuleOf(knob));
    return *value;
}

const Knob& KnobNamed(const Description& description, const std::string& name,
                      const std::string& where) {
    return FindNamed(
        description.knobs, [](const Knob& knob) { return knob.name; }, name,
        where + ": " + description.name + " has no " + name);
}

double ValueOf(const Description& description, const KnobValues& values,
               const std::string& name) {
    const auto given = values.find(name);
    return given != values.end() ? given->second
                                 : KnobNamed(description, name, "values").published;
}

KnobValues Merged(const Description& description, KnobValues under, const KnobValues& over) {
    for (const auto& [name, value] : over) {
        for (const std::string& covered : KnobNamed(description, name, "values").covers) {
            under.erase(covered);
        }
    }
    for (const auto& [name, value] : over) under[name] = value;
    return under;
}

KnobValues ValuesOfTexts(const Description& description,
                         const std::map<std::string, std::string>& texts,
                         const std::string& where) {
    KnobValues values;
    for (const auto& [name, text] : texts) {
        values[name] =
            ValueOfText(KnobNamed(description, name, where), text, where + "." + name);
    }
    return values;
}

}  // namespace plumb
