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

/// sqrt(w_i) (f_i(p) - y_i), all samples as one block.
class WeightedResiduals final : public ceres::CostFunction {
  public:
    explicit WeightedResiduals(const LeastSquaresProblem& problem) : problem_(problem) {
        set_num_residuals(int(problem.y.size()));
        mutable_parameter_block_sizes()->push_back(int(problem.parameters.size()));
    }

    bool Evaluate(double const* const* p, double* residuals,
                  double** jacobians) const override {
        double* jacobian = jacobians ? jacobians[0] : nullptr;
        problem_.predict(p[0], residuals, jacobian);
        const std::size_t n = problem_.parameters.size();
        bool finite = true;
        for (std::size_t i = 0; i < problem_.y.size(); ++i) {
            const double root_w = std::sqrt(problem_.weights[i]);
            residuals[i] = root_w * (residuals[i] - problem_.y[i]);
            finite = finite && std::isfinite(residuals[i]);
            for (std::size_t j = 0; jacobian && j < n; ++j) {
                jacobian[i * n + j] *= root_w;
                finite = finite && std::isfinite(jacobian[i * n + j]);
            }
        }
        return finite;
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

struct Descent {
    std::vector<double> p;
    double chi2 = std::numeric_limits<double>::infinity();
    bool converged = false;
    int iterations = 0;
    std::string termination;
};

Descent DescendFrom(std::vector<double> start, const LeastSquaresProblem& problem,
                    const LeastSquaresOptions& options) {
    Descent descent;
    descent.p = std::move(start);
    ceres::Problem ceres_problem;
    ceres_problem.AddResidualBlock(new WeightedResiduals(problem), nullptr, descent.p.data());
    for (std::size_t j = 0; j < problem.parameters.size(); ++j) {
        ceres_problem.SetParameterLowerBound(descent.p.data(), int(j),
                                             problem.parameters[j].low);
        ceres_problem.SetParameterUpperBound(descent.p.data(), int(j),
                                             problem.parameters[j].high);
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
    if (summary.IsSolutionUsable()) descent.chi2 = 2 * summary.final_cost;
    descent.converged = summary.termination_type == ceres::CONVERGENCE;
    descent.iterations = int(summary.iterations.size());
    descent.termination = summary.message;
    return descent;
}

bool HeldByBound(double p, const Parameter& parameter) {
    const auto near = [&](double bound) {
        return std::abs(p - bound) <= kBoundTolerance * std::max(1.0, std::abs(bound));
    };
    return near(parameter.low) || near(parameter.high);
}

/// Prediction and Jacobian at p, both with sqrt(w): NaN where the prediction has no value.
struct Linearization {
    Eigen::VectorXd residuals;
    Matrix J;
};

Linearization LinearizeAt(const std::vector<double>& p, const LeastSquaresProblem& problem) {
    Linearization at{Eigen::VectorXd(problem.y.size()),
                     Matrix(problem.y.size(), problem.parameters.size())};
    const double* block = p.data();
    double* jacobian = at.J.data();
    WeightedResiduals(problem).Evaluate(&block, at.residuals.data(), &jacobian);
    return at;
}

/// Throws if some parameter moves no prediction at any start.
void RequireEffect(const LeastSquaresProblem& problem, const LeastSquaresOptions& options,
                   double sum_w) {
    const std::size_t n = problem.parameters.size();
    std::vector<double> effect(n, 0);
    for (int start = 0; start < options.starts; ++start) {
        const Matrix J = LinearizeAt(StartingPoint(problem.parameters, start), problem).J;
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
        const Parameter& parameter = problem.parameters[j];
        const bool held = HeldByBound(best.p[j], parameter);
        fit.parameters.push_back({.name = std::string(parameter.name),
                                  .value = best.p[j],
                                  .standard_error = {},
                                  .at_bound = held});
        if (!held) free.push_back(int(j));
    }

    const Linearization at = LinearizeAt(best.p, problem);
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
