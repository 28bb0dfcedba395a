#include "io/far_mesh.h"

#include <array>
#include <charconv>
#include <cmath>
#include <functional>
#include <string_view>

namespace plumb {
namespace {

bool IsBlank(char c) {
    return c == ' ' || c == '\t';
}

// The three numbers after "v", and what comes after them on the line.
struct VertexLine {
    Vec3 v;
    std::string_view rest;
};

std::optional<VertexLine> ParseVertex(std::string_view line) {
    VertexLine parsed;
    const char* at = line.data() + 1;
    const char* const end = line.data() + line.size();
    for (int axis = 0; axis < 3; ++axis) {
        while (at < end && IsBlank(*at)) ++at;
        if (at < end && *at == '+') ++at;
        const auto read = std::from_chars(at, end, parsed.v[axis]);
        if (read.ec != std::errc{} || !std::isfinite(parsed.v[axis])) return std::nullopt;
        at = read.ptr;
    }
    parsed.rest = std::string_view(at, std::size_t(end - at));
    return parsed;
}

// Calls of_vertex for lines of vertices and of_other for the rest, all with their ends. False
// if a line of a vertex cannot be read.
bool ForLines(std::string_view text, const std::function<void(const VertexLine&)>& of_vertex,
              const std::function<void(std::string_view)>& of_other) {
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line =
            text.substr(0, end == std::string_view::npos ? text.size() : end + 1);
        text.remove_prefix(line.size());
        std::string_view word = line;
        while (!word.empty() && IsBlank(word.front())) word.remove_prefix(1);
        if (word.size() < 2 || word[0] != 'v' || !IsBlank(word[1])) {
            of_other(line);
            continue;
        }
        const auto vertex = ParseVertex(word);
        if (!vertex) return false;
        of_vertex(*vertex);
    }
    return true;
}

}  // namespace

Vec3 OriginFor(const Vec3& low, const Vec3& high) {
    constexpr double kFar = 16;
    const Vec3 middle = (low + high) / 2;
    const double extent = (high - low).maxCoeff();
    if (!(extent > 0 && middle.cwiseAbs().maxCoeff() > kFar * extent)) return Vec3::Zero();
    const double step = std::exp2(std::ceil(std::log2(extent)));
    return (middle / step).array().round() * step;
}

std::optional<NearObj> BringNear(const std::string& obj) {
    Eigen::AlignedBox3d box;
    const auto extend = [&](const VertexLine& line) { box.extend(line.v); };
    if (!ForLines(obj, extend, [](std::string_view) {}) || box.isEmpty()) return std::nullopt;
    const Vec3 origin = OriginFor(box.min(), box.max());
    if (origin.isZero(0)) return std::nullopt;
    NearObj near{.text = {}, .origin = origin};
    near.text.reserve(obj.size());
    const auto append_moved = [&](const VertexLine& line) {
        near.text += 'v';
        for (int axis = 0; axis < 3; ++axis) {
            std::array<char, 32> digits;
            const auto end = std::to_chars(digits.data(), digits.data() + digits.size(),
                                           line.v[axis] - origin[axis])
                                 .ptr;
            near.text += ' ';
            near.text.append(digits.data(), end);
        }
        near.text += line.rest;
    };
    ForLines(obj, append_moved, [&](std::string_view line) { near.text += line; });
    return near;
}

}  // namespace plumb
