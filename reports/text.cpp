#include "reports/text.h"

#include <charconv>
#include <cmath>

namespace plumb {
namespace {

constexpr std::string_view kDash = "–";

std::string Format(double x, std::chars_format format, int precision) {
    char buffer[400];
    const auto [end, error] =
        std::to_chars(buffer, buffer + sizeof buffer, x, format, precision);
    return {buffer, end};
}

/// The place of the first significant digit of x != 0 once rounded: 0 for 1 ... 9, -2 for 0.01.
int Exponent(double x, int significant) {
    const std::string text = Format(x, std::chars_format::scientific, significant - 1);
    return std::stoi(text.substr(text.find('e') + 1));
}

std::string Padding(std::string_view text, int columns) {
    const int missing = columns - Characters(text);
    return std::string(missing > 0 ? std::size_t(missing) : 0, ' ');
}

}  // namespace

std::string Exact(double x) {
    if (!std::isfinite(x)) return {};
    char buffer[40];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, x);
    return {buffer, end};
}

std::string Digits(double x, int significant) {
    if (!std::isfinite(x)) return std::string(kDash);
    if (x == 0) return "0";
    const int exponent = Exponent(x, significant);
    if (exponent < -4 || exponent > 6)
        return Format(x, std::chars_format::scientific, significant - 1);
    return Format(x, std::chars_format::fixed, std::max(significant - 1 - exponent, 0));
}

std::string WithError(double value, double standard_error) {
    if (!std::isfinite(value)) return std::string(kDash);
    if (!(standard_error > 0) || !std::isfinite(standard_error)) return Digits(value, 5);
    const int last_place = Exponent(standard_error, 2) - 1;
    if (last_place < -8) return Digits(value, 9) + " ± " + Digits(standard_error, 2);
    const int decimals = std::max(-last_place, 0);
    return Format(value, std::chars_format::fixed, decimals) + " ± " +
           Format(standard_error, std::chars_format::fixed, decimals);
}

std::string Count(long long n) {
    std::string digits = std::to_string(n < 0 ? -n : n);
    for (int i = int(digits.size()) - 3; i > 0; i -= 3) digits.insert(std::size_t(i), 1, ',');
    return n < 0 ? std::string("-").append(digits) : digits;
}

double Rounded(double x, int significant) {
    if (!std::isfinite(x)) return x;
    const std::string text = Format(x, std::chars_format::scientific, significant - 1);
    double rounded = 0;
    std::from_chars(text.data(), text.data() + text.size(), rounded);
    return rounded;
}

std::string Html(std::string_view text) {
    std::string safe;
    for (const char c : text) {
        switch (c) {
            case '&':
                safe += "&amp;";
                break;
            case '<':
                safe += "&lt;";
                break;
            case '>':
                safe += "&gt;";
                break;
            case '"':
                safe += "&quot;";
                break;
            case '\'':
                safe += "&#39;";
                break;
            default:
                safe += c;
        }
    }
    return safe;
}

std::string Csv(std::string_view text) {
    std::string field(text);
    if (!field.empty() && std::string_view("=+-@\t\r").find(field[0]) != std::string_view::npos)
        field.insert(std::size_t(0), 1, '\'');
    if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
    std::string quoted(1, '"');
    for (const char c : field) quoted.append(c == '"' ? 2 : 1, c);
    return quoted.append(1, '"');
}

int Characters(std::string_view text) {
    int n = 0;
    for (const char c : text) n += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    return n;
}

std::string Left(std::string_view text, int columns) {
    return std::string(text) + Padding(text, columns);
}

std::string Right(std::string_view text, int columns) {
    return Padding(text, columns) + std::string(text);
}

std::string Wrapped(std::string_view text, int columns, const std::string& indent) {
    std::string lines(text.substr(0, text.find(' ')));
    int used = Characters(lines);
    for (std::size_t at = text.find(' '); at != std::string_view::npos;) {
        const std::size_t end = text.find(' ', at + 1);
        const std::string_view word = text.substr(at + 1, end - at - 1);
        const int width = Characters(word);
        if (used + 1 + width > columns) {
            lines += "\n" + indent;
            used = Characters(indent) + width;
        } else {
            lines += ' ';
            used += 1 + width;
        }
        lines += word;
        at = end;
    }
    return lines;
}

std::string Listed(const std::vector<std::string>& items) {
    std::string list;
    for (std::size_t i = 0; i < items.size(); ++i)
        list += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
    return list;
}

}  // namespace plumb
