// Weighted nonlinear least squares within bounds, from many starts, with its own diagnosis.
//
//       minimize  chi2(p) = Sum_i w_i (f_i(p) - y_i)^2     subject to  low_j <= p_j <= high_j
//
// At the minimum, with J_ij = sqrt(w_i) df_i/dp_j over the parameters that no bound holds:
//
//       covariance  C = s^2 (J^T J)^-1        s^2 = chi2 / dof, or 1 if w_i = 1 / sigma_i^2
//       condition   sigma_max / sigma_min of J, and of J with its columns scaled to length 1
//
// Symbols  p parameters, y_i measured, f_i predicted, w_i weights, dof samples less columns
//          of J.
// Beware   rmse is weighted, sqrt(chi2 / Sum w): the plain one if all weights are equal.
//          Solved by Ceres (Levenberg-Marquardt, dense QR) on one thread: the same input gives
//          the same bits.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fit/model.h"

namespace plumb {

/// Where the scale s^2 of the covariance comes from.
enum class ErrorScale {
    kFromResiduals,  ///< Weights are relative: s^2 = chi2 / dof.
    kFromWeights,  ///< Weights are 1 / sigma^2: s^2 = 1, and chi2 / dof is a test of the model.
};

struct LeastSquaresOptions {
    int starts = 16;           ///< The initial values, then points of a Sobol net. [1, ...)
    int max_iterations = 300;  ///< For each start. [1, ...)
    ErrorScale error_scale = ErrorScale::kFromResiduals;

    /// A parameter that, at every start, moves the predictions by less than this (weighted root
    /// mean square, linearized, over its whole range) cannot be fitted: Error. (0, ...)
    double least_effect = 1e-6;
};

/// Throws Error, naming the first field that breaks its range above.
void Validate(const LeastSquaresOptions& options);

struct FittedParameter {
    std::string name;
    double value = 0;
    std::optional<double> standard_error;  ///< None if a bound holds it, or J has no full rank.
    bool at_bound = false;
};

/// What a fit has to say for itself. Not converging is an outcome, not an error.
struct LeastSquaresFit {
    std::vector<FittedParameter> parameters;
    Eigen::MatrixXd correlation;  ///< Identity rows where there is no standard error.
    double condition = 0;  ///< Of J with columns scaled to length 1. Infinite if singular.
    double condition_unscaled = 0;  ///< Of J as it is: depends on the units of p.

    double rmse = 0;          ///< sqrt(chi2 / Sum w), unitless as y.
    double max_abs = 0;       ///< Largest |f_i - y_i|.
    double chi2_per_dof = 0;  ///< About 1 if the model is right and w_i = 1 / sigma_i^2.
    int samples = 0;

    bool converged = false;  ///< Of the best start.
    int iterations = 0;      ///< Of the best start.
    int starts = 0;
    int starts_agreeing = 0;  ///< With rmse <= best rmse (1 + 1e-6) + 1e-9.
    std::string termination;  ///< The solver's own words on the best start.

    std::vector<double> Values() const;
};

struct LeastSquaresProblem {
    std::string name;  ///< For messages.
    std::span<const Parameter> parameters;
    std::span<const double> y;
    std::span<const double> weights;  ///< (0, ...), one for each y.

    /// Writes f_i(p) and, if `jacobian` is not null, df_i/dp_j row by row.
    std::function<void(const double* p, double* f, double* jacobian)> predict;
};

/// Throws Error if y or a weight is not finite, if a weight is not positive, if there are not
/// more samples than parameters, or if the data say nothing of a parameter
/// (LeastSquaresOptions::least_effect).
LeastSquaresFit Minimize(const LeastSquaresProblem& problem,
                         const LeastSquaresOptions& options = {});

}  // namespace plumb
