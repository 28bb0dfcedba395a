#include "fit/least_squares.h"

#include <ceres/ceres.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/error.h"
#include "core/sobol.h"

namespace plumb {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A parameter this near to a bound, relative to the bound or to 1, is held by it.
constexpr double kBoundTolerance = 1e-9;

/// Residuals sqrt(w_i) (f_i - y_i) and their Jacobian, not finite where the prediction is not.
struct Linearization {
    Eigen::VectorXd residuals;
    Matrix J;
};

Linearization LinearizeAt(const double* p, const LeastSquaresProblem& problem) {
    const auto rows = Eigen::Index(problem.y.size());
    Linearization at{Eigen::VectorXd(rows), Matrix(rows, problem.parameters.size())};
    problem.predict(p, at.residuals.data(), at.J.data());
    for (Eigen::Index i = 0; i < rows; ++i) {
        const double root_w = std::sqrt(problem.weights[i]);
        at.residuals[i] = root_w * (at.residuals[i] - problem.y[i]);
        at.J.row(i) *= root_w;
    }
    return at;
}

/// All residuals as one block; every parameter is a block of its own, so that it can be held.
class WeightedResiduals final : public ceres::CostFunction {
  public:
    explicit WeightedResiduals(const LeastSquaresProblem& problem) : problem_(problem) {
        set_num_residuals(int(problem.y.size()));
        mutable_parameter_block_sizes()->assign(problem.parameters.size(), 1);
    }

    /// False, a step that the solver takes back, where a prediction is not finite.
    bool Evaluate(double const* const* blocks, double* residuals,
                  double** jacobians) const override {
        const std::size_t n = problem_.parameters.size();
        std::vector<double> p(n);
        for (std::size_t j = 0; j < n; ++j) p[j] = *blocks[j];
        if (!jacobians) {
            problem_.predict(p.data(), residuals, nullptr);
            for (std::size_t i = 0; i < problem_.y.size(); ++i)
                residuals[i] = std::sqrt(problem_.weights[i]) * (residuals[i] - problem_.y[i]);
            return Eigen::Map<const Eigen::VectorXd>(residuals, num_residuals()).allFinite();
        }
        const Linearization at = LinearizeAt(p.data(), problem_);
        Eigen::Map<Eigen::VectorXd>(residuals, num_residuals()) = at.residuals;
        for (std::size_t j = 0; j < n; ++j)
            if (jacobians[j])
                Eigen::Map<Eigen::VectorXd>(jacobians[j], num_residuals()) = at.J.col(int(j));
        return at.residuals.allFinite() && at.J.allFinite();
    }

  private:
    const LeastSquaresProblem& problem_;
};

bool IsLogarithmic(const Parameter& parameter) {
    return 0 < parameter.low && parameter.low <= parameter.high / 100;
}

/// Start 0 is the initial values; the others are scrambled Sobol points within the bounds.
std::vector<double> StartingPoint(std::span<const Parameter> parameters, int start) {
    constexpr std::uint64_t kSeed = 0;
    std::vector<double> p;
    for (std::size_t j = 0; j < parameters.size(); ++j) {
        const auto& [name, initial, low, high] = parameters[j];
        if (start == 0) {
            p.push_back(std::clamp(initial, low, high));
            continue;
        }
        const double u = SobolOwen(std::uint32_t(start - 1), std::uint32_t(j), kSeed);
        p.push_back(IsLogarithmic(parameters[j])
                        ? std::clamp(low * std::pow(high / low, u), low, high)
                        : std::lerp(low, high, u));
    }
    return p;
}

/// At a bound, and chi2 would fall beyond it. `slope` is d chi2 / dp.
bool HeldByBound(double p, double slope, const Parameter& parameter) {
    const auto near = [&](double bound) {
        return std::abs(p - bound) <= kBoundTolerance * std::max(1.0, std::abs(bound));
    };
    return (near(parameter.low) && slope >= 0) || (near(parameter.high) && slope <= 0);
}

struct Descent {
    std::vector<double> p;
    std::vector<bool> held;  ///< By its bound.
    double chi2 = std::numeric_limits<double>::infinity();
    bool converged = false;
    int iterations = 0;
    std::string termination;
};

/// One run of the solver from descent.p, with the parameters that are held kept where they are.
void Solve(const LeastSquaresProblem& problem, const LeastSquaresOptions& options,
           Descent& descent) {
    ceres::Problem ceres_problem;
    std::vector<double*> blocks;
    for (double& p : descent.p) blocks.push_back(&p);
    ceres_problem.AddResidualBlock(new WeightedResiduals(problem), nullptr, blocks);
    for (std::size_t j = 0; j < blocks.size(); ++j) {
        ceres_problem.SetParameterLowerBound(blocks[j], 0, problem.parameters[j].low);
        ceres_problem.SetParameterUpperBound(blocks[j], 0, problem.parameters[j].high);
        if (descent.held[j]) ceres_problem.SetParameterBlockConstant(blocks[j]);
    }
    ceres::Solver::Options solver;
    solver.linear_solver_type = ceres::DENSE_QR;
    solver.max_num_iterations = options.max_iterations;
    solver.num_threads = 1;
    solver.logging_type = ceres::SILENT;
    // Near the rounding of a double: what is left over then is far below any standard error.
    solver.function_tolerance = 1e-15;
    solver.gradient_tolerance = 1e-14;
    solver.parameter_tolerance = 1e-12;
    // A trial step into a pole is refused; it takes several to shrink the region away from it.
    solver.max_num_consecutive_invalid_steps = 30;

    ceres::Solver::Summary summary;
    ceres::Solve(solver, &ceres_problem, &summary);
    descent.chi2 = summary.IsSolutionUsable() ? 2 * summary.final_cost
                                              : std::numeric_limits<double>::infinity();
    descent.converged = summary.termination_type == ceres::CONVERGENCE;
    descent.iterations += int(summary.iterations.size());
    descent.termination = summary.message;
}

/// The solver projects its steps onto the bounds and can stall beside the minimum on a bound.
/// So what a bound holds is taken out and the rest solved again, until the same ones are held.
Descent DescendFrom(std::vector<double> start, const LeastSquaresProblem& problem,
                    const LeastSquaresOptions& options) {
    const std::size_t n = problem.parameters.size();
    Descent descent;
    descent.p = std::move(start);
    descent.held.assign(n, false);
    for (std::size_t round = 0; round <= n; ++round) {
        Solve(problem, options, descent);
        const Linearization at = LinearizeAt(descent.p.data(), problem);
        const Eigen::VectorXd slope = 2 * at.J.transpose() * at.residuals;
        std::vector<bool> held(n);
        for (std::size_t j = 0; j < n; ++j)
            held[j] = HeldByBound(descent.p[j], slope[int(j)], problem.parameters[j]);
        if (held == descent.held) break;
        descent.held = held;
    }
    return descent;
}

/// Throws if some parameter moves no prediction at any start.
void RequireEffect(const LeastSquaresProblem& problem, const LeastSquaresOptions& options,
                   double sum_w) {
    const std::size_t n = problem.parameters.size();
    std::vector<double> effect(n, 0);
    for (int start = 0; start < options.starts; ++start) {
        const Matrix J =
            LinearizeAt(StartingPoint(problem.parameters, start).data(), problem).J;
        for (std::size_t j = 0; j < n; ++j) {
            const double range = problem.parameters[j].high - problem.parameters[j].low;
            const double moved = range * J.col(int(j)).norm() / std::sqrt(sum_w);
            if (std::isfinite(moved)) effect[j] = std::max(effect[j], moved);
        }
    }
    for (std::size_t j = 0; j < n; ++j)
        if (effect[j] < options.least_effect)
            throw Error(problem.name + ": nothing to fit, the data do not depend on " +
                        std::string(problem.parameters[j].name) + " (" +
                        MustBe("its effect", effect[j], ">= least_effect") + ")");
}

/// Largest over smallest singular value; infinite if the matrix has no full rank.
double Condition(const Eigen::VectorXd& singular_values, Eigen::Index rows) {
    const double largest = singular_values.maxCoeff(), least = singular_values.minCoeff();
    const double rank_tolerance =
        largest * double(rows) * std::numeric_limits<double>::epsilon();
    return least > rank_tolerance ? largest / least : std::numeric_limits<double>::infinity();
}

/// Standard errors, correlations and condition numbers from J at the minimum.
void Diagnose(const Matrix& J, double s2, const std::vector<int>& free, LeastSquaresFit& fit) {
    const auto n = Eigen::Index(free.size());
    fit.correlation = Eigen::MatrixXd::Identity(J.cols(), J.cols());
    if (n == 0) {
        fit.condition = fit.condition_unscaled = 1;
        return;
    }
    // R of J = QR has J's singular values and is as small as the parameters are few.
    Eigen::MatrixXd J_free(J.rows(), n);
    for (Eigen::Index j = 0; j < n; ++j) J_free.col(j) = J.col(free[j]);
    const Eigen::MatrixXd R = J_free.householderQr()
                                  .matrixQR()
                                  .topRows(n)
                                  .triangularView<Eigen::Upper>()
                                  .toDenseMatrix();
    Eigen::VectorXd length = R.colwise().norm();
    length = (length.array() > 0).select(length, 1.0);
    const Eigen::JacobiSVD<Eigen::MatrixXd> scaled(R * length.cwiseInverse().asDiagonal(),
                                                   Eigen::ComputeFullV);
    fit.condition = Condition(scaled.singularValues(), J.rows());
    fit.condition_unscaled =
        Condition(Eigen::JacobiSVD<Eigen::MatrixXd>(R).singularValues(), J.rows());
    if (!std::isfinite(fit.condition)) return;

    // (J^T J)^-1 of the scaled columns = V S^-2 V^T; the scaling cancels in the correlations.
    const Eigen::MatrixXd VS =
        scaled.matrixV() * scaled.singularValues().cwiseInverse().asDiagonal();
    const Eigen::MatrixXd C = VS * VS.transpose();
    for (Eigen::Index j = 0; j < n; ++j) {
        fit.parameters[free[j]].standard_error = std::sqrt(s2 * C(j, j)) / length[j];
        for (Eigen::Index k = 0; k < n; ++k)
            if (k != j)
                fit.correlation(free[j], free[k]) = C(j, k) / std::sqrt(C(j, j) * C(k, k));
    }
}

/// Sum of the weights, once all there is to fit to has been checked.
double CheckedSumOfWeights(const LeastSquaresProblem& problem) {
    assert(problem.y.size() == problem.weights.size());
    double sum_w = 0;
    for (std::size_t i = 0; i < problem.y.size(); ++i) {
        const std::string number = std::to_string(i);
        if (!std::isfinite(problem.y[i]))
            throw Error(MustBe(problem.name + ": y[" + number + "]", problem.y[i], "finite"));
        if (!std::isfinite(problem.weights[i]) || problem.weights[i] <= 0)
            throw Error(MustBe(problem.name + ": weights[" + number + "]", problem.weights[i],
                               "finite and > 0"));
        sum_w += problem.weights[i];
    }
    if (problem.y.size() <= problem.parameters.size())
        throw Error(MustBe(problem.name + ": samples", double(problem.y.size()),
                           "more than the parameters, of which there are " +
                               std::to_string(problem.parameters.size())));
    return sum_w;
}

}  // namespace

void Validate(const LeastSquaresOptions& options) {
    if (options.starts < 1)
        throw Error(MustBe("LeastSquaresOptions::starts", options.starts, ">= 1"));
    if (options.max_iterations < 1)
        throw Error(
            MustBe("LeastSquaresOptions::max_iterations", options.max_iterations, ">= 1"));
    if (!(options.least_effect > 0))
        throw Error(MustBe("LeastSquaresOptions::least_effect", options.least_effect, "> 0"));
}

std::vector<double> LeastSquaresFit::Values() const {
    std::vector<double> values;
    for (const FittedParameter& parameter : parameters) values.push_back(parameter.value);
    return values;
}

LeastSquaresFit Minimize(const LeastSquaresProblem& problem,
                         const LeastSquaresOptions& options) {
    Validate(options);
    const double sum_w = CheckedSumOfWeights(problem);
    RequireEffect(problem, options, sum_w);

    std::vector<Descent> descents;
    for (int start = 0; start < options.starts; ++start)
        descents.push_back(
            DescendFrom(StartingPoint(problem.parameters, start), problem, options));
    const Descent& best =
        *std::min_element(descents.begin(), descents.end(),
                          [](const Descent& a, const Descent& b) { return a.chi2 < b.chi2; });

    LeastSquaresFit fit;
    fit.converged = best.converged;
    fit.iterations = best.iterations;
    fit.termination = best.termination;
    fit.starts = options.starts;
    fit.samples = int(problem.y.size());

    std::vector<int> free;
    for (std::size_t j = 0; j < problem.parameters.size(); ++j) {
        fit.parameters.push_back({.name = std::string(problem.parameters[j].name),
                                  .value = best.p[j],
                                  .standard_error = {},
                                  .at_bound = best.held[j]});
        if (!best.held[j]) free.push_back(int(j));
    }

    const Linearization at = LinearizeAt(best.p.data(), problem);
    const double chi2 = at.residuals.squaredNorm();
    fit.rmse = std::sqrt(chi2 / sum_w);
    for (Eigen::Index i = 0; i < at.residuals.size(); ++i)
        fit.max_abs =
            std::max(fit.max_abs, std::abs(at.residuals[i]) / std::sqrt(problem.weights[i]));
    fit.chi2_per_dof = chi2 / double(int(problem.y.size()) - int(free.size()));
    for (const Descent& descent : descents)
        fit.starts_agreeing += std::sqrt(descent.chi2 / sum_w) <= fit.rmse * (1 + 1e-6) + 1e-9;
    const double s2 = options.error_scale == ErrorScale::kFromWeights ? 1 : fit.chi2_per_dof;
    Diagnose(at.J, s2, free, fit);
    return fit;
}

}  // namespace plumb
