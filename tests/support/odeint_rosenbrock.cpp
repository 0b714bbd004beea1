#include "odeint_rosenbrock.hpp"

#include <utility>

#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>

namespace support {

void odeint_rosenbrock_step(std::size_t n, const std::function<void(const double*, double*)>& slope,
                            const double* jacobian, const double* x, double h, double* out) {
  using vector = boost::numeric::ublas::vector<double>;
  using matrix = boost::numeric::ublas::matrix<double>;
  const auto system = [&](const vector& y, vector& dy, double) { slope(&y[0], &dy[0]); };
  const auto jacobi = [&](const vector&, matrix& J, double, vector& in_time) {
    for (std::size_t i = 0; i < n; ++i) {
      in_time[i] = 0;
      for (std::size_t j = 0; j < n; ++j)
        J(i, j) = jacobian[i * n + j];
    }
  };
  vector from(n), to(n);
  for (std::size_t i = 0; i < n; ++i)
    from[i] = x[i];
  boost::numeric::odeint::rosenbrock4<double> stepper;
  stepper.do_step(std::make_pair(system, jacobi), from, 0.0, to, h);
  for (std::size_t i = 0; i < n; ++i)
    out[i] = to[i];
}

} // namespace support
