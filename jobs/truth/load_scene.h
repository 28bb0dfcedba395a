// A scene by the name that a user gives it, ready to be measured.
#pragma once

#include <string>
#include <vector>

#include "core/scene.h"
#include "io/scene_file.h"

namespace plumb {

struct LoadedScene {
    Scene scene;
    std::vector<std::string> notes;               ///< What was left out of its files.
    std::string digest;                           ///< SHA-256 of all that its light depends on.
    std::vector<TechniqueEntry> techniques = {};  ///< Their parameters, as its file has them.
};

/// "hall.json" (docs/scenes.md), or "make:KIND" or KIND for a generated one. Throws Error.
LoadedScene LoadScene(const std::string& name);

/// SHA-256 of all of a scene that its light depends on: not of names, nor of cameras.
std::string DigestOf(const Scene& scene);

/// The camera of that name, the first if it is empty. Throws Error, listing the names.
const Camera& CameraNamed(const Scene& scene, const std::string& name);

}  // namespace plumb
