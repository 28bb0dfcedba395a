// The triangles of a mesh, as rays meet them.
//
//       triangle 2f of face f = (a, b, c, d) is (a, b, d), triangle 2f + 1 is (c, d, b)
//       point    P = (1 - b_1 - b_2) p_0 + b_1 p_1 + b_2 p_2
//
// A face that is a triangle (d == c) has only its first half. All is in double from the
// mesh's float corners, so a point lies in its triangle's plane to double precision.
#pragma once

#include <array>
#include <cstdint>

#include "core/mesh.h"
#include "core/vec.h"

namespace plumb {

struct Triangle {
    std::array<Vec3, 3> corners_m;

    /// Twice the area long, on the side from which the corners run counter-clockwise.
    Vec3 Cross() const {
        return (corners_m[1] - corners_m[0]).cross(corners_m[2] - corners_m[0]);
    }
    Vec3 Normal() const { return Cross().normalized(); }
    double AreaM2() const { return Cross().norm() / 2; }
    Vec3 PointM(double b_1, double b_2) const {
        return (1 - b_1 - b_2) * corners_m[0] + b_1 * corners_m[1] + b_2 * corners_m[2];
    }
};

inline Triangle TriangleOf(const Mesh& mesh, std::uint32_t triangle) {
    const std::array<std::uint32_t, 4>& face = mesh.quads[triangle / 2];
    const auto corner = [&](std::size_t k) -> Vec3 {
        return mesh.vertices_m[face[k]].cast<double>();
    };
    return triangle % 2 == 0 ? Triangle{{corner(0), corner(1), corner(3)}}
                             : Triangle{{corner(2), corner(3), corner(1)}};
}

/// The mesh as its user meant it: throws Error, naming the first vertex that is not finite or
/// beyond 1e15 m (where float squares overflow), or the first index out of range. `name` is
/// what the message calls the mesh.
void Validate(const Mesh& mesh, const std::string& name = "mesh");

}  // namespace plumb
