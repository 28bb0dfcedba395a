#include "scenes/catalogue.h"

#include <array>
#include <string>

#include "core/names.h"
#include "scenes/atrium.h"
#include "scenes/dense.h"
#include "scenes/simple.h"

namespace plumb {
namespace {

constexpr std::array<SceneKind, 9> kKinds{{
    {"atrium", "Two storeys of arches around a court, 250 000 triangles",
     [] { return Atrium(); }},
    {"box_on_plane", "A cube on a plane", BoxOnPlane},
    {"ball_over_plane", "A ball over a plane: V is known exactly", BallOverPlane},
    {"cornell_box", "A coloured room with two blocks", CornellBox},
    {"wedge", "Floor and wall: V = 1/2", Wedge},
    {"trench", "A trench in level ground", TrenchScene},
    {"fence", "Bars thinner than a pixel", [] { return Fence(); }},
    {"slivers", "A plate of a million slivers", [] { return Slivers(); }},
    {"forest", "A million small triangles", [] { return Forest(); }},
}};

}  // namespace

std::span<const SceneKind> SceneKinds() {
    return kKinds;
}

const SceneKind& SceneKindNamed(std::string_view name) {
    return FindNamed(
        kKinds, [](const SceneKind& kind) { return kind.name; }, name,
        "scene \"" + std::string(name) + "\"");
}

}  // namespace plumb
