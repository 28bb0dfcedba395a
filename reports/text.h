// Numbers and names as text: for people, for spreadsheets, for pages.
//
// Independent of any locale. What is not finite is a dash for people and empty for machines.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace plumb {

/// The shortest digits that read back to the same double. Empty if x is not finite.
std::string Exact(double x);

/// x with so many significant digits, trailing zeros kept: Digits(0.01, 3) is "0.0100". Large
/// and tiny values get an exponent. A dash if x is not finite.
std::string Digits(double x, int significant = 3);

/// "27.58 ± 0.12": the error with two digits, the value to the same place. The value alone,
/// with five digits, if the error is not finite or not positive.
std::string WithError(double value, double standard_error);

/// "12,345,678"
std::string Count(long long n);

/// x rounded to so many significant digits, as a number.
double Rounded(double x, int significant);

/// &, <, >, " and ' made harmless in text and in quoted attributes.
std::string Html(std::string_view text);

/// A field of a CSV line [RFC 4180]: quoted where it must be. A text that a spreadsheet would
/// run as a formula (it starts with =, +, - or @) gets a ' in front.
std::string Csv(std::string_view text);

/// Of UTF-8.
int Characters(std::string_view text);

/// Padded with spaces to so many columns of a terminal (UTF-8 is counted by characters).
std::string Left(std::string_view text, int columns);
std::string Right(std::string_view text, int columns);

/// Broken at spaces into lines of at most so many characters, all but the first indented.
std::string Wrapped(std::string_view text, int columns, const std::string& indent);

/// printf into a string, of at most 255 bytes.
template <class... Values>
std::string Line(const char* format, Values... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

/// "a, b and c"
std::string Listed(const std::vector<std::string>& items);

}  // namespace plumb
