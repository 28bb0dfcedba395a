#include <cmath>

#include "reports/render.h"
#include "reports/text.h"

namespace plumb::doc {
namespace {

std::string TextOf(const Measured& m, int digits, bool interval) {
    if (!interval && std::isfinite(m.value) && m.standard_error > 0 &&
        std::isfinite(m.standard_error)) {
        return WithError(m.value, m.standard_error);
    }
    const std::string value = Digits(m.value, digits);
    if (!std::isfinite(m.value) || !std::isfinite(m.interval.low) ||
        !std::isfinite(m.interval.high)) {
        return value;
    }
    return value + " (" + Digits(m.interval.low, digits) + " to " +
           Digits(m.interval.high, digits) + ")";
}

}  // namespace

std::string CellText(const Column& column, const Cell& cell) {
    struct Visitor {
        int digits;
        bool interval;
        std::string operator()(std::monostate) const { return Digits(NAN); }
        std::string operator()(const std::string& text) const { return text; }
        std::string operator()(std::int64_t n) const { return Count(n); }
        std::string operator()(double x) const { return Digits(x, digits); }
        std::string operator()(const Measured& m) const { return TextOf(m, digits, interval); }
    };
    return std::visit(Visitor{column.digits, column.interval}, cell);
}

}  // namespace plumb::doc
