// A name looked up in a list of names: the one form of "must be one of".
//
//       technique = gtoa, must be one of hbao, gtao, bitmask; did you mean gtao?
//
// Symbols  The distance of two words is the least number of letters put in, taken out or replaced
//          that makes one of the other, two neighbours swapped counting as one.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// "a, b, c".
std::string Joined(std::span<const std::string> words, std::string_view between = ", ");

int EditDistance(std::string_view a, std::string_view b);

/// "must be one of a, b, c", and "; did you mean b?" where the nearest name is no farther from
/// `given` than a third of its letters.
std::string MustBeOneOf(std::string_view given, std::span<const std::string> names,
                        std::string_view between = ", ");

/// The place of `given` in `names`. Throws Error "THING, must be one of ..." if it is not there;
/// `thing` says what was given and where: "technique = gtoa".
std::size_t PlaceOf(std::string_view given, std::span<const std::string> names,
                    const std::string& thing);

/// The one of `range` whose name is `given`. Throws Error as PlaceOf does.
template <class Range, class NameOf>
const auto& FindNamed(const Range& range, const NameOf& name_of, std::string_view given,
                      const std::string& thing) {
    std::vector<std::string> names;
    for (const auto& one : range) names.emplace_back(name_of(one));
    return *(std::begin(range) + std::ptrdiff_t(PlaceOf(given, names, thing)));
}

}  // namespace plumb
