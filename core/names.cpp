#include "core/names.h"

#include <algorithm>

#include "core/error.h"

namespace plumb {

std::string Joined(std::span<const std::string> words, std::string_view between) {
    std::string joined;
    for (const std::string& word : words) {
        if (&word != words.data()) joined += between;
        joined += word;
    }
    return joined;
}

int EditDistance(std::string_view a, std::string_view b) {
    // rows[i % 3][j] is the distance of the first i letters of a from the first j of b.
    std::vector<std::vector<int>> rows(3, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        std::vector<int>& row = rows[i % 3];
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                row[j] = int(i + j);
                continue;
            }
            const std::vector<int>& above = rows[(i + 2) % 3];
            const bool same = a[i - 1] == b[j - 1];
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = std::min(row[j], rows[(i + 1) % 3][j - 2] + 1);
            }
        }
    }
    return rows[a.size() % 3][b.size()];
}

std::string MustBeOneOf(std::string_view given, std::span<const std::string> names,
                        std::string_view between) {
    std::string rule = "must be one of " + Joined(names, between);
    if (names.empty() || given.size() > 64) return rule;
    const auto distance = [&](const std::string& name) { return EditDistance(given, name); };
    const std::string& nearest = *std::min_element(
        names.begin(), names.end(),
        [&](const std::string& a, const std::string& b) { return distance(a) < distance(b); });
    const bool near = 3 * distance(nearest) <= int(std::max(given.size(), nearest.size()));
    return near ? rule + "; did you mean " + nearest + "?" : rule;
}

std::size_t PlaceOf(std::string_view given, std::span<const std::string> names,
                    const std::string& thing) {
    const auto found = std::find(names.begin(), names.end(), given);
    if (found == names.end()) throw Error(thing + ", " + MustBeOneOf(given, names));
    return std::size_t(found - names.begin());
}

}  // namespace plumb
