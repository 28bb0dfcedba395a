#include "jobs/score/limits.h"

#include <charconv>
#include <cmath>
#include <sstream>

#include "core/error.h"
#include "core/names.h"

namespace plumb {
namespace {

std::string Text(double value) {
    std::ostringstream text;
    text << value;
    return text.str();
}

}  // namespace

Limit ParseLimit(const std::string& text, const std::string& flag, bool is_least) {
    const std::size_t equals = text.find('=');
    const std::string key = text.substr(0, equals);
    const std::string number = equals == std::string::npos ? "" : text.substr(equals + 1);
    PlaceOf(key, FigureKeys(), flag + " " + text + ": figure = " + key);
    Limit limit{.key = key, .value = 0, .is_least = is_least};
    const auto [end, error] =
        std::from_chars(number.data(), number.data() + number.size(), limit.value);
    if (error != std::errc() || end != number.data() + number.size() ||
        !std::isfinite(limit.value)) {
        throw Error(flag + " " + text + ", must be FIGURE=NUMBER, such as psnr=40");
    }
    return limit;
}

bool Keeps(const Limit& limit, double figure) {
    return limit.is_least ? figure >= limit.value : figure <= limit.value;
}

doc::Table LimitTable(const std::vector<Limit>& limits,
                      const std::vector<CandidateScore>& scores,
                      std::vector<std::string>& failures) {
    doc::Table table{
        .key = "limits",
        .columns = {{.key = "candidate", .title = "Candidate", .role = doc::Role::kName},
                    {.key = "figure", .title = "Figure", .role = doc::Role::kName},
                    {.key = "value", .title = "Value", .digits = 6},
                    {.key = "rule", .title = "Must be", .role = doc::Role::kName},
                    {.key = "verdict", .title = "Verdict"}}};
    for (const CandidateScore& score : scores) {
        for (const Limit& limit : limits) {
            const double value = FigureOf(score, limit.key);
            const std::string rule = (limit.is_least ? ">= " : "<= ") + Text(limit.value);
            const bool keeps = Keeps(limit, value);
            table.Add(
                {score.name, limit.key, value, rule, std::string(keeps ? "passed" : "failed")});
            if (keeps) continue;
            failures.push_back(score.name + ": " + limit.key + " = " + Text(value) +
                               ", must be " + rule);
        }
    }
    return table;
}

}  // namespace plumb
