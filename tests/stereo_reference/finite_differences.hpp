// Derivatives by central differences, to hold analytic ones against.
#pragma once

#include <Eigen/Core>

namespace finback::stereo_reference {

// Of `function`, a vector of a vector, at `at`; one column a component of `at`.
template <class Function>
[[nodiscard]] Eigen::MatrixXd differences(const Function& function, const Eigen::VectorXd& at,
                                          double step = 1e-6) {
  Eigen::MatrixXd result(Eigen::VectorXd(function(at)).size(), at.size());
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    Eigen::VectorXd before = at;
    Eigen::VectorXd after = at;
    before[i] -= step;
    after[i] += step;
    result.col(i) =
        (Eigen::VectorXd(function(after)) - Eigen::VectorXd(function(before))) / (2 * step);
  }
  return result;
}

}  // namespace finback::stereo_reference
