// The generated scenes by name, for the command line and scene files.
#pragma once

#include <span>
#include <string_view>

#include "core/scene.h"

namespace plumb {

struct SceneKind {
    std::string_view name;         ///< "atrium": lower case, no blanks.
    std::string_view description;  ///< One line, no full stop.
    Scene (*make)();               ///< With everything at its default.
};

/// Every kind, in a fixed order.
std::span<const SceneKind> SceneKinds();

/// The kind of that name. Throws Error, listing the names, if there is none.
const SceneKind& SceneKindNamed(std::string_view name);

}  // namespace plumb
