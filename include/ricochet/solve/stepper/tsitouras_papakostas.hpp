#pragma once
#include <ricochet/solve/stepper/explicit_pair.hpp>
#include <ricochet/solve/stepper/stepper.hpp>

namespace ricochet::stepper {

/// NEW7(5), nine stages [Tsitouras & Papakostas, SIAM J. Sci. Comput. 20 (1999) 2067]. Its fractions satisfy the
/// conditions of order to 1e-20, which suffices for long double.
struct tsitouras_papakostas75_table {
  static constexpr unsigned short order = 7, error_order = 5;
  static constexpr std::size_t stages = 9;
  using row = std::array<long double, stages>;
  static constexpr std::array<row, stages> a{{
      {},
      {1.L / 18},
      {0, 1.L / 9},
      {1.L / 24, 0, 1.L / 8},
      {2183971.L / 4000000, 0, -8340813.L / 4000000, 3968421.L / 2000000},
      {695768212.L / 7463744411, 0, -1803549175.L / 7007942496, 3474507053.L / 6790877290, 2188198899.L / 15264927763},
      {-11894934857.L / 8390623634, 0, 53094780276.L / 9800512003, -8415376229.L / 2277049503,
       -18647567697.L / 10138317907, 27551494893.L / 11905950217},
      {30828057951.L / 7654644085, 0, -4511704.L / 324729, 16217851618.L / 1651177175, 282768186839.L / 40694064384,
       -104400780537.L / 15869257619, 5409241639.L / 9600177208},
      {-133775720546.L / 36753383835, 0, 49608695511.L / 4066590848, -59896475201.L / 7901259813,
       -48035527651.L / 5727379426, 86266718551.L / 10188951048, -7751618114.L / 23575802495,
       2289274942.L / 8464405725},
  }};
  static constexpr row b{597988726.L / 12374436915,
                         0,
                         0,
                         3138312158.L / 11968408119,
                         480882843.L / 7850665645,
                         988558885.L / 3512253271,
                         5302636961.L / 26425940286,
                         1259489433.L / 12163586030,
                         1016647712.L / 23899101975};
  /// b minus the weights of order 5
  static constexpr row e{b[0] - 1421940313.L / 46193547077,
                         0,
                         0,
                         b[3] - 1943068601.L / 5911217046,
                         b[4] + 3807140880.L / 8205366359,
                         b[5] - 9377220888.L / 11577671635,
                         b[6] - 586186883.L / 5187186385,
                         b[7] - 1114095023.L / 8014791121,
                         0};
};

/// What ricochet takes where the motion is smooth: of a dozen pairs of orders 5 to 9 the one that reached errors
/// between 1e-6 and 1e-10 with the fewest evaluations. State and Real to double or long double precision.
template <class State, class Real>
using tsitouras_papakostas75_pair = explicit_pair<tsitouras_papakostas75_table, State, Real>;
struct tsitouras_papakostas75 : embedded<tsitouras_papakostas75_pair> {
  static constexpr double usual_error = 0.004; ///< its estimate is two orders below the formula that goes on
};

} // namespace ricochet::stepper
