#include "core/total_name.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace plumb {

std::string TotalName(Albedo rho) {
    // The shortest digits that read back to the same double: at most 24 characters.
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), rho.value).ptr;
    std::string name = "E_rho" + std::string(digits.data(), end);
    std::ranges::replace(name, '.', 'p');
    std::ranges::replace(name, '-', 'm');
    return name;
}

}  // namespace plumb
