#include "core/error.h"

#include <array>
#include <charconv>
#include <cmath>

namespace plumb {

std::string MustBe(const std::string& thing, double value, const std::string& rule) {
    // The shortest digits that read back to the same double: at most 24 characters.
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    const std::string text = std::isnan(value) ? "nan" : std::string(digits.data(), end);
    return thing + " = " + text + ", must be " + rule;
}

}  // namespace plumb
