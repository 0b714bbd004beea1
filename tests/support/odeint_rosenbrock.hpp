// One step of odeint's own rosenbrock4, which Boost 1.74 can compile as C++17 only: in a translation unit of its own.
#pragma once
#include <cstddef>
#include <functional>

namespace support {

/// out = x + one step of size h of n unknowns; `slope(x, dxdt)`; the Jacobian by rows.
void odeint_rosenbrock_step(std::size_t n, const std::function<void(const double*, double*)>& slope,
                            const double* jacobian, const double* x, double h, double* out);

} // namespace support
