// Makes packed states known to Boost.Odeint's own steppers.
#pragma once
#include <ricochet/model/state.hpp>

#include <boost/numeric/odeint/algebra/algebra_dispatcher.hpp>
#include <boost/numeric/odeint/algebra/array_algebra.hpp>

template <class T, class Variables>
struct boost::numeric::odeint::algebra_dispatcher<ricochet::state<T, Variables>> {
  using algebra_type = array_algebra;
};
