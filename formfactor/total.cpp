#include "formfactor/total.h"

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>
#include <string>

#include "core/error.h"

namespace plumb {
namespace {

class Transport;

}  // namespace
}  // namespace plumb

// Eigen's solvers take any operator that says its scalar and how it multiplies a vector.
namespace Eigen::internal {
template <>
struct traits<plumb::Transport> : traits<SparseMatrix<double>> {};
}  // namespace Eigen::internal

namespace plumb {
namespace {

// I - F diag(rho), never formed.
class Transport : public Eigen::EigenBase<Transport> {
  public:
    using Scalar = double;
    using RealScalar = double;
    using StorageIndex = int;
    enum {
        ColsAtCompileTime = Eigen::Dynamic,
        MaxColsAtCompileTime = Eigen::Dynamic,
        IsRowMajor = false
    };

    Transport(const Links& links, std::span<const double> albedo, Monitor& monitor)
        : links_(links), albedo_(albedo), monitor_(monitor) {}

    Eigen::Index rows() const { return Eigen::Index(albedo_.size()); }
    Eigen::Index cols() const { return rows(); }

    template <class Rhs>
    auto operator*(const Eigen::MatrixBase<Rhs>& x) const {
        return Eigen::Product<Transport, Rhs, Eigen::AliasFreeProduct>(*this, x.derived());
    }

    Eigen::VectorXd Apply(const Eigen::VectorXd& E) const {
        const Eigen::Map<const Eigen::VectorXd> rho(albedo_.data(), rows());
        const Eigen::VectorXd lit = rho.cwiseProduct(E);
        const std::vector<double> bounced =
            Gather(links_, {lit.data(), std::size_t(lit.size())}, monitor_);
        return E - Eigen::Map<const Eigen::VectorXd>(bounced.data(), rows());
    }

  private:
    const Links& links_;
    std::span<const double> albedo_;
    Monitor& monitor_;
};

}  // namespace
}  // namespace plumb

namespace Eigen::internal {
template <class Rhs>
struct generic_product_impl<plumb::Transport, Rhs, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<plumb::Transport, Rhs,
                                generic_product_impl<plumb::Transport, Rhs>> {
    template <class Dest>
    static void scaleAndAddTo(Dest& dest, const plumb::Transport& A, const Rhs& x,
                              const double& alpha) {
        dest.noalias() += alpha * A.Apply(x);
    }
};
}  // namespace Eigen::internal

namespace plumb {

TotalLight SolveTotal(const Links& links, std::span<const double> albedo, double tolerance,
                      Monitor& monitor) {
    const std::size_t n = links.V.size();
    if (albedo.size() != n) {
        throw Error("albedo: " + std::to_string(albedo.size()) + " values for " +
                    std::to_string(n) + " facets, must be one a facet");
    }
    for (const double rho : albedo) {
        if (!(rho >= 0 && rho <= 1)) throw Error(MustBe("albedo", rho, "in [0, 1]"));
    }
    const Eigen::Map<const Eigen::VectorXd> V(links.V.data(), Eigen::Index(n));
    const Transport A(links, albedo, monitor);
    Eigen::BiCGSTAB<Transport, Eigen::IdentityPreconditioner> solver;
    solver.setTolerance(tolerance);
    solver.setMaxIterations(2000);
    solver.compute(A);
    const Eigen::VectorXd E = solver.solveWithGuess(V, V);
    TotalLight out;
    out.iterations = int(solver.iterations());
    out.residual = V.norm() > 0 ? (V - A.Apply(E)).norm() / V.norm() : 0;
    out.converged = out.residual <= 10 * tolerance;
    out.E.assign(E.data(), E.data() + n);
    return out;
}

}  // namespace plumb
