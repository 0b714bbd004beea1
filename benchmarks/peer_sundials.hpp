// Collisions as a competent user of SUNDIALS computes them: CVODE or ARKODE with its own root finding for the end;
// memory is allocated once and used for all collisions.
#pragma once
#include "peer_equations.hpp"

#include <algorithm>
#include <stdexcept>

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

namespace peer {

/// What both solvers of SUNDIALS are given: the equations, and the event as a function with a falling root.
template <class System>
class sundials {
protected:
  using state = typename System::state;
  static constexpr long size = std::tuple_size_v<state>;

  sundials() {
    if (SUNContext_Create(nullptr, &context_) != 0)
      throw std::runtime_error("SUNDIALS gives no context");
    x_ = N_VNew_Serial(size, context_);
  }
  ~sundials() {
    N_VDestroy(x_);
    SUNContext_Free(&context_);
  }
  sundials(const sundials&) = delete;

  static state state_of(N_Vector x) {
    state result;
    std::copy_n(N_VGetArrayPointer(x), size, result.begin());
    return result;
  }
  static int slope(double t, N_Vector x, N_Vector dx, void* self) {
    state result;
    (*static_cast<sundials*>(self)->system_)(state_of(x), result, t);
    std::copy_n(result.begin(), size, N_VGetArrayPointer(dx));
    return std::isfinite(result[1]) ? 0 : 1;
  }
  static int root(double, N_Vector x, double* value, void* self) {
    *value = static_cast<sundials*>(self)->system_->event(state_of(x));
    return 0;
  }

  /// `advance(longest)` returns at a root, or for good; `has_root` says which.
  template <class Advance>
  double to_the_end(double speed, double longest, int has_root, const Advance& advance) {
    for (int roots = 0; roots < 100; ++roots) {
      if (advance(longest) != has_root)
        return 0;
      if (const state x = state_of(x_); system_->may_end(x))
        return -x[1] / speed;
    }
    return 0;
  }
  void begin(const System& system, double speed) {
    system_ = &system;
    const state x = system.start(speed);
    std::copy_n(x.begin(), size, N_VGetArrayPointer(x_));
  }

  SUNContext context_ = nullptr;
  N_Vector x_ = nullptr;
  const System* system_ = nullptr;
  int falling_ = -1;
};

/// CVODE: Adams with fixed-point iteration, or BDF with Newton's and a dense matrix by differences.
template <class System>
class cvode : sundials<System> {
  using base = sundials<System>;

public:
  explicit cvode(int method) : memory_(CVodeCreate(method, base::context_)) {
    CVodeInit(memory_, &base::slope, 0, base::x_);
    CVodeSetUserData(memory_, static_cast<base*>(this));
    CVodeSetErrFile(memory_, nullptr);
    CVodeSetMaxNumSteps(memory_, 1'000'000);
    if (method == CV_ADAMS) {
      iteration_ = SUNNonlinSol_FixedPoint(base::x_, 0, base::context_);
      CVodeSetNonlinearSolver(memory_, iteration_);
    } else {
      matrix_ = SUNDenseMatrix(base::size, base::size, base::context_);
      linear_ = SUNLinSol_Dense(base::x_, matrix_, base::context_);
      CVodeSetLinearSolver(memory_, linear_, matrix_);
    }
    CVodeRootInit(memory_, 1, &base::root);
    CVodeSetRootDirection(memory_, &(base::falling_));
    CVodeSetNoInactiveRootWarn(memory_);
  }
  ~cvode() {
    CVodeFree(&memory_);
    if (iteration_)
      SUNNonlinSolFree(iteration_);
    if (linear_)
      SUNLinSolFree(linear_);
    if (matrix_)
      SUNMatDestroy(matrix_);
  }

  double operator()(const System& system, double speed, double tolerance, double longest) {
    base::begin(system, speed);
    CVodeSStolerances(memory_, tolerance, tolerance);
    CVodeReInit(memory_, 0, base::x_);
    return base::to_the_end(speed, longest, CV_ROOT_RETURN, [&](double until) {
      double t;
      return CVode(memory_, until, base::x_, &t, CV_NORMAL);
    });
  }

private:
  void* memory_;
  SUNNonlinearSolver iteration_ = nullptr;
  SUNMatrix matrix_ = nullptr;
  SUNLinearSolver linear_ = nullptr;
};

/// ARKODE with an explicit table. Its roots are sought in a polynomial of degree five at most, so that Fehlberg 8(7),
/// the table of highest order, gains nothing.
template <class System>
class arkode : sundials<System> {
  using base = sundials<System>;

public:
  explicit arkode(ARKODE_ERKTableID table) : table_(table) {}
  ~arkode() {
    if (memory_)
      ERKStepFree(&memory_);
  }

  double operator()(const System& system, double speed, double tolerance, double longest) {
    base::begin(system, speed);
    if (!memory_)
      create();
    ERKStepSStolerances(memory_, tolerance, tolerance);
    ERKStepReInit(memory_, &base::slope, 0, base::x_);
    return base::to_the_end(speed, longest, ARK_ROOT_RETURN, [&](double until) {
      double t;
      return ERKStepEvolve(memory_, until, base::x_, &t, ARK_NORMAL);
    });
  }

private:
  void create() {
    memory_ = ERKStepCreate(&base::slope, 0, base::x_, base::context_);
    ERKStepSetUserData(memory_, static_cast<base*>(this));
    ERKStepSetErrFile(memory_, nullptr);
    ERKStepSetMaxNumSteps(memory_, 1'000'000);
    ERKStepSetTableNum(memory_, table_);
    ERKStepSetInterpolantDegree(memory_, 5); // the highest
    ERKStepRootInit(memory_, 1, &base::root);
    ERKStepSetRootDirection(memory_, &(base::falling_));
    ERKStepSetNoInactiveRootWarn(memory_);
  }

  ARKODE_ERKTableID table_;
  void* memory_ = nullptr;
};

} // namespace peer
