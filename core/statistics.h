// Means that know how sure they are, summed so that the order is ours and not the scheduler's.
//
//       mean   m_n = m_{n-1} + (x_n - m_{n-1}) / n
//       M2_n       = M2_{n-1} + (x_n - m_{n-1}) (x_n - m_n),      variance = M2_n / (n - 1)
//
// Source   [Welford62] B. P. Welford, Note on a Method for Calculating Corrected Sums of
//          Squares and Products, Technometrics 4(3), 1962; the merge of two of them: [Chan83]
//          T. Chan, G. Golub, R. LeVeque, Algorithms for Computing the Sample Variance, 1983.
// Beware   Merging rounds differently in another order: merge chunks in chunk order.
#pragma once

#include <cstdint>
#include <vector>

namespace plumb {

/// Running mean and variance.
class Moments {
  public:
    void Add(double x) {
        ++n_;
        const double from_old_mean = x - mean_;
        mean_ += from_old_mean / double(n_);
        m2_ += from_old_mean * (x - mean_);
    }
    void Merge(const Moments& later);

    std::int64_t Count() const { return n_; }
    double Mean() const { return mean_; }

    /// Of a sample about the mean, with n - 1: unbiased. 0 for n < 2.
    double Variance() const { return n_ < 2 ? 0 : m2_ / double(n_ - 1); }

    /// Of the mean of independent samples: s / sqrt(n). Infinite for n < 2.
    double StandardError() const;

    /// Half the width of the two-sided interval that covers the true mean with probability
    /// `confidence` if samples are normal: Student's t with n - 1 degrees of freedom times the
    /// standard error. Infinite for n < 2.
    double HalfWidth(double confidence) const;

  private:
    std::int64_t n_ = 0;
    double mean_ = 0, m2_ = 0;
};

/// The value below which `share` of the values lie, interpolated between the two neighbours in
/// order: position share (n - 1), counted from 0 (definition 7 of [Hyndman96] R. Hyndman,
/// Y. Fan, Sample Quantiles in Statistical Packages, 1996). Needs a value and share in [0, 1].
double Percentile(std::vector<double> values, double share);

}  // namespace plumb
