// Columns in one line.
#pragma once

#include <string>

#include "reports/document.h"

namespace plumb::doc {

/// Says which row it is.
inline Column Name(std::string key, std::string title) {
    return {.key = std::move(key), .title = std::move(title), .role = Role::kName};
}

inline Column Value(std::string key, std::string title, int digits = 3,
                    std::string meaning = {}) {
    return {.key = std::move(key),
            .title = std::move(title),
            .digits = digits,
            .meaning = std::move(meaning)};
}

/// The less the better.
inline Column ErrorOf(std::string key, std::string title, int digits = 3,
                      std::string meaning = {}) {
    Column column = Value(std::move(key), std::move(title), digits, std::move(meaning));
    column.better = Better::kLess;
    return column;
}

/// For machines.
inline Column Detail(std::string key, std::string title) {
    return {.key = std::move(key), .title = std::move(title), .detail = true};
}

}  // namespace plumb::doc
