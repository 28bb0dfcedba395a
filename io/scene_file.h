// scene.json: a scene described by its meshes or a generator, light and cameras.
//
// docs/scenes.md explains every field. Reading is strict: a field that does not exist, is of the
// wrong type or out of its range is an error that names it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/scene.h"

namespace plumb {

/// A height map as a surface: x, y from texel (0, 0), +z up.
struct HeightsEntry {
    std::string name;                   ///< Path of the map, or "make:KIND[:SIZE[:SEED]]".
    std::string asked_by;               ///< The field that names it, for errors.
    Rgb albedo{0.8f, 0.8f, 0.8f};       ///< [0, 1]
    std::optional<double> amplitude_m;  ///< Over what the map's own files say. >= 0
    int tiles = 1;  ///< A map that repeats is repeated so often to each side. [0, 16]
};

/// What the file says of one technique: its knobs, as text. Which techniques and knobs there are is
/// not asked here.
struct TechniqueEntry {
    std::string name;
    std::string where;  ///< "hall.json: techniques[0]".
    std::map<std::string, std::string>
        values;  ///< "0.75", "spiral"; true and false: "on", "off".
};

/// What the file says. If it names a generator, `scene` has no surfaces yet, and what is unset
/// is left to the generator.
struct SceneFile {
    Scene scene;
    std::string generator;  ///< Of scenes/catalogue.h; empty if there are mesh files.
    std::vector<HeightsEntry> heights;  ///< To be added to the scene's surfaces by the caller.
    /// Everything in `scene` is relative to it: not 0 if the first mesh lies far from 0.
    Vec3 origin_m = Vec3::Zero();
    bool has_light = false;
    bool has_cameras = false;
    std::vector<std::filesystem::path> files;  ///< That it was read from, itself first.
    std::vector<TechniqueEntry> techniques;
    std::vector<std::string> notes;  ///< What was left out of them.
};

/// Paths in the file are relative to its folder. Throws Error naming file, field, value, rule.
SceneFile ReadSceneFile(const std::filesystem::path& path);

}  // namespace plumb
