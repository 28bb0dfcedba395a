#include "rays/triangle.h"

#include <cmath>
#include <string>

#include "core/error.h"

namespace plumb {

void Validate(const Mesh& mesh, const std::string& name) {
    const std::size_t vertices = mesh.vertices_m.size();
    for (std::size_t i = 0; i < vertices; ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const float x = mesh.vertices_m[i][axis];
            if (!(std::abs(x) <= 1e15f)) {
                throw Error(
                    MustBe(name + ": vertices_m[" + std::to_string(i) + "]." + "xyz"[axis], x,
                           "finite and at most 1e15 from 0"));
            }
        }
    }
    for (std::size_t f = 0; f < mesh.quads.size(); ++f) {
        for (std::size_t k = 0; k < 4; ++k) {
            if (mesh.quads[f][k] >= vertices) {
                throw Error(MustBe(
                    name + ": quads[" + std::to_string(f) + "][" + std::to_string(k) + "]",
                    mesh.quads[f][k], "< " + std::to_string(vertices) + ", the vertices"));
            }
        }
    }
    if (mesh.quads.size() >= (std::size_t{1} << 31) - 1) {
        throw Error(MustBe(name + ": faces", double(mesh.quads.size()), "< 2^31 - 1"));
    }
}

}  // namespace plumb
