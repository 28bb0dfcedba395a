// The little markup of a sentence: `code`, *stressed*, _{low}, ^{high}; \ takes the next
// character as it is. A mark that is never closed stands for itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace plumb::doc {

enum class Style { kPlain, kCode, kStress, kLow, kHigh };

struct Span {
    Style style = Style::kPlain;
    std::string text;
};

std::vector<Span> SpansOf(std::string_view sentence);

/// For where there is but one kind of letter: "E_{k}" is "E_k".
std::string PlainText(std::string_view sentence);

/// Nothing but `code`: lines to be kept as they are.
bool IsCode(std::string_view sentence);

/// Everything escaped that is not of the markup.
std::string SentenceHtml(std::string_view sentence);

}  // namespace plumb::doc
