// The distributions behind our intervals and tests: normal, Student's t, chi-square, beta.
//
//       I_x(a, b) = 1/B(a, b) Int_0^x t^(a-1) (1-t)^(b-1) dt       the distribution of beta
//       Q(a, x)   = 1/Gamma(a) Int_x^inf t^(a-1) e^-t dt           chi-square: Q(k/2, x/2)
//       P(T > t)  = 1/2 I_{nu/(nu+t^2)}(nu/2, 1/2)                 Student, t > 0
//
// Source   [DLMF] NIST Digital Library of Mathematical Functions, 8.9.2 (continued fraction of
//          Q); that of I_x: [DiDonato92] A. DiDonato, A. Morris, Algorithm 708, ACM TOMS 18(3),
//          1992; their common factor by saddle point, which does not cancel for large counts:
//          [Loader00] C. Loader, Fast and Accurate Computation of Binomial Probabilities, 2000.
// Domain   Relative error below 1e-12 for parameters up to 1e6, 1e-9 up to 1e9 (tested).
// Beware   A quantile is of a probability in (0, 1); 0 and 1 give the ends of the support.
#pragma once

namespace plumb {

double NormalCdf(double z);
double NormalQuantile(double probability);

/// I_x(a, b): P(X <= x) of a beta distribution. a, b > 0.
double BetaCdf(double x, double a, double b);
double BetaQuantile(double probability, double a, double b);

/// P(T <= t), `dof` > 0 degrees of freedom.
double StudentCdf(double t, double dof);
double StudentQuantile(double probability, double dof);

/// P(X > chi2): small if the observed chi2 is too large to be chance. `dof` > 0.
double ChiSquareSurvival(double chi2, double dof);

}  // namespace plumb
