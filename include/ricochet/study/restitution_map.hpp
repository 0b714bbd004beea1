// The restitution of one pair as a function of the speed, at once: for codes that ask for it millions of times.
#pragma once
#include <ricochet/batch/batch.hpp>
#include <ricochet/study/threshold.hpp>
#include <ricochet/version.hpp>

#include <Eigen/LU>

#include <bit>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

namespace ricochet {

/// e(v) of a pair between two speeds, by polynomials of degree seven between bisected speeds. Below the sticking speed
/// it is zero; outside the range it was made for it is no number.
class restitution_map {
public:
  static constexpr std::size_t terms = 8;

  /// c0 + c1 t + ... with t from -1 at `begin` to 1 at `end`; e^2, where it is `squared`, else e. Speeds in m/s.
  struct piece {
    double begin, end;
    bool squared;
    std::array<double, terms> c;

    double operator()(double v) const {
      const double t = (2 * v - (begin + end)) / (end - begin);
      double sum = c[terms - 1];
      for (std::size_t i = terms - 1; i-- > 0;)
        sum = sum * t + c[i];
      return squared ? std::sqrt(std::max(sum, 0.)) : sum;
    }
  };

  /// low, high: range of speeds; sticking: speed up to which the pair sticks, 0 if it does not anywhere between; all in
  /// m/s. pieces: from the sticking speed, or low, to high. largest_error: found by comparison with collisions.
  /// \throws bad_input if the pieces do not join or the numbers are no range.
  restitution_map(double low, double high, double sticking, double largest_error, std::vector<piece> pieces)
      : low_(low), high_(high), sticking_(sticking), largest_error_(largest_error), pieces_(std::move(pieces)) {
    require("low speed of the map", low, positive);
    require("high speed of the map", high, range{.low = low, .low_included = false});
    double at = std::max(low, sticking);
    for (const piece& each : pieces_) {
      if (each.begin != at || !(each.end > at))
        throw bad_input("restitution map: no piece goes on at " + shown(at) + " m/s");
      at = each.end;
    }
    if (at != high)
      throw bad_input("restitution map: it ends at " + shown(at) + " m/s, not at " + shown(high) + " m/s");
    first_cell_ = cell_of(low);
    const std::size_t cells = cell_of(high) - first_cell_ + 1;
    std::size_t next = 0;
    for (std::size_t i = 0; i < cells; ++i) {
      const double begin = std::bit_cast<double>((first_cell_ + i) << shift);
      while (next + 1 < pieces_.size() && pieces_[next].end <= begin)
        ++next;
      start_.push_back(next);
    }
  }

  /// Restitution at a speed in m/s; NaN outside [low, high].
  double operator()(double v) const {
    if (!(v >= low_ && v <= high_))
      return std::numeric_limits<double>::quiet_NaN();
    if (v <= sticking_ || pieces_.empty())
      return 0;
    std::size_t i = start_[cell_of(v) - first_cell_];
    while (v > pieces_[i].end)
      ++i;
    return pieces_[i](v);
  }
  double operator()(speed v) const { return (*this)(in_si(v)); }

  /// The same as a plain function of C: `map` is the address of a restitution_map, `speed` in m/s.
  static double restitution(const void* map, double speed) {
    return (*static_cast<const restitution_map*>(map))(speed);
  }

  double low() const { return low_; }
  double high() const { return high_; }
  double sticking_speed() const { return sticking_; }
  double largest_error() const { return largest_error_; }
  const std::vector<piece>& pieces() const { return pieces_; }

  /// Format 1: text; comment lines begin with #; then low, high, sticking speed, largest error and the number of
  /// pieces, and a line for each piece: begin, end, 1 if squared, and its coefficients. \throws std::runtime_error
  void save(const std::filesystem::path& file) const {
    const std::filesystem::path unfinished = file.string() + ".part";
    std::ofstream out(unfinished);
    out.precision(17);
    out << "# ricochet " << version << " restitution map, format 1\n"
        << "# low [m/s], high [m/s], sticking speed [m/s], largest error, number of pieces; for each: begin [m/s],\n"
        << "# end [m/s], 1 if of e^2 (0: of e), coefficients c0 ... c7 of t, which goes from -1 at begin to 1 at end\n"
        << low_ << ' ' << high_ << ' ' << sticking_ << ' ' << largest_error_ << ' ' << pieces_.size() << '\n';
    for (const piece& each : pieces_) {
      out << each.begin << ' ' << each.end << ' ' << each.squared;
      for (const double c : each.c)
        out << ' ' << c;
      out << '\n';
    }
    out.close();
    if (!out)
      throw std::runtime_error("cannot write " + unfinished.string());
    std::filesystem::rename(unfinished, file);
  }

  /// \throws std::runtime_error naming the file if it is not there or not whole, bad_input if its numbers are no map.
  static restitution_map load(const std::filesystem::path& file) {
    std::ifstream in(file);
    if (!in)
      throw std::runtime_error("cannot read " + file.string());
    std::string line;
    std::getline(in, line);
    if (line.find("restitution map, format 1") == std::string::npos)
      throw std::runtime_error(file.string() + " is no restitution map of format 1");
    while (in.peek() == '#')
      std::getline(in, line);
    double low, high, sticking, largest_error;
    std::size_t count;
    in >> low >> high >> sticking >> largest_error >> count;
    std::vector<piece> pieces;
    for (std::size_t i = 0; in && i < count; ++i) {
      piece& each = pieces.emplace_back();
      in >> each.begin >> each.end >> each.squared;
      for (double& c : each.c)
        in >> c;
    }
    if (!in)
      throw std::runtime_error(file.string() + " is not whole");
    return {low, high, sticking, largest_error, std::move(pieces)};
  }

private:
  static constexpr int shift = 52 - 6; ///< 64 cells for each octave
  static std::uint64_t cell_of(double v) { return std::bit_cast<std::uint64_t>(v) >> shift; }

  double low_, high_, sticking_, largest_error_;
  std::vector<piece> pieces_;
  std::uint64_t first_cell_ = 0;
  std::vector<std::size_t> start_; ///< for each cell of speeds, the first piece that reaches into it
};

/// max_error: of the restitution; within a millionth of the sticking speed, of its square.
struct map_options {
  double max_error = 1e-8;
  unsigned threads = 0;
  progress_callback progress = {}; ///< told the number of pieces that are good, and of all at that time
};

namespace detail {

template <class Model>
class map_maker {
  static constexpr std::size_t terms = restitution_map::terms;
  using piece = restitution_map::piece;
  using values = Eigen::Matrix<double, terms, 1>;

public:
  map_maker(const Model& model, const map_options& options) : model_(model), options_(options) {
    require("max_error", options.max_error, range{.low = 1e-10, .high = 1e-2, .high_included = true});
    Eigen::Matrix<double, terms, terms> powers;
    for (std::size_t i = 0; i < terms; ++i) {
      node_[i] = -std::cos(pi<double>() * (double(i) + 0.5) / terms);
      for (std::size_t j = 0; j < terms; ++j)
        powers(Eigen::Index(i), Eigen::Index(j)) = std::pow(node_[i], double(j));
    }
    to_powers_ = powers.inverse();
  }

  restitution_map make(speed low, speed high) {
    require("low speed", low, positive);
    require("high speed", high, range{.low = in_si(low), .low_included = false});
    const double a = in_si(low), b = in_si(high);
    const bool sticks = !collide(model_, impact{low}).restitution;
    if (sticks && !collide(model_, impact{high}).restitution)
      return {a, b, b, 0, {}};
    sticking_ = sticks ? in_si(ricochet::sticking_speed(model_, low, high, 1e-12).smallest_separated) : 0;
    begin_ = std::max(a, sticking_);
    end_ = b;
    std::vector<cell> open;
    for (double octave = std::exp2(std::floor(std::log2(begin_))); octave < b; octave *= 2)
      add(open, octave, 2 * octave);
    std::vector<piece> good;
    std::vector<cell> of_good;
    while (!open.empty()) {
      std::vector<cell> next;
      const std::vector<piece> tried = polynomials(open);
      const std::vector<double> errors = largest_errors(open, tried);
      for (std::size_t i = 0; i < open.size(); ++i)
        if (errors[i] <= options_.max_error / 2 || too_narrow(open[i])) {
          good.push_back(tried[i]);
          largest_error_ = too_narrow(open[i]) ? largest_error_ : std::max(largest_error_, errors[i]);
        } else {
          const double middle = (open[i].begin + open[i].end) / 2;
          add(next, open[i].begin, middle);
          add(next, middle, open[i].end);
        }
      if (options_.progress)
        options_.progress(good.size(), good.size() + next.size());
      open = std::move(next);
    }
    std::sort(good.begin(), good.end(), [](const piece& x, const piece& y) { return x.begin < y.begin; });
    return {a, b, sticking_, largest_error_, std::move(good)};
  }

private:
  struct cell {
    double begin, end; ///< halved anew and anew; what is outside the map's range does not count
  };

  void add(std::vector<cell>& cells, double begin, double end) const {
    if (std::max(begin, begin_) < std::min(end, end_))
      cells.push_back({begin, end});
  }
  double begin_of(const cell& c) const { return std::max(c.begin, begin_); }
  double end_of(const cell& c) const { return std::min(c.end, end_); }
  double place(const cell& c, double t) const { return ((1 - t) * begin_of(c) + (1 + t) * end_of(c)) / 2; }
  double nearest(double t) const { return sticking_ * (1 + (t < -0.95 ? 1.01e-6 : t < -0.5 ? 1e-5 : 1e-4)); }
  static bool too_narrow(const cell& c) { return c.end - c.begin < 1e-13 * c.end; }

  std::vector<double> restitutions(const std::vector<impact>& impacts) const {
    const double tolerance = std::max(options_.max_error / 16, tolerance_range.low);
    std::vector<double> e;
    e.reserve(impacts.size());
    for (const auto& out : collide(model_, std::span<const impact>(impacts),
                                   batch_options{.tolerance = tolerance, .threads = options_.threads})) {
      if (out.ending != ending::separated && out.ending != ending::captured)
        throw bad_input("restitution map: the collision at " + shown(in_si(impacts[e.size()].speed)) + " m/s ended " +
                        name_of(out.ending) + ": " + out.reason);
      e.push_back(out.restitution.value_or(0));
    }
    return e;
  }

  std::vector<piece> polynomials(const std::vector<cell>& cells) const {
    std::vector<impact> impacts;
    for (const cell& c : cells)
      for (const double t : node_)
        impacts.push_back({place(c, t) * units::metres_per_second});
    const std::vector<double> e = restitutions(impacts);
    std::vector<piece> pieces;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      values at_nodes = Eigen::Map<const values>(e.data() + i * terms);
      // Where the energy decides, e^2 is smooth down to zero; a free edge lets go where e itself is.
      const bool squared = (!Model::has_crack_law || Model::yields) && at_nodes.minCoeff() < 0.5;
      if (squared)
        at_nodes = at_nodes.cwiseAbs2();
      const values c = to_powers_ * at_nodes;
      piece& each = pieces.emplace_back(piece{begin_of(cells[i]), end_of(cells[i]), squared, {}});
      std::copy(c.begin(), c.end(), each.c.begin());
    }
    return pieces;
  }

  /// Of each cell, at its ends, between the nodes, and at random; next to the sticking speed, where an error of e^2 is
  /// the largest of e, ever closer to it.
  std::vector<double> largest_errors(const std::vector<cell>& cells, const std::vector<piece>& pieces) {
    constexpr std::size_t looks = 8;
    std::vector<impact> impacts;
    for (const cell& c : cells) {
      const bool at_threshold = begin_of(c) == sticking_;
      for (const double t : {-0.995, -0.9, -0.4, 0., 0.4, 0.9, 0.995})
        impacts.push_back({(at_threshold && t < 0 ? nearest(t) : place(c, t)) * units::metres_per_second});
      impacts.push_back({place(c, std::uniform_real_distribution(-1., 1.)(random_)) * units::metres_per_second});
    }
    const std::vector<double> e = restitutions(impacts);
    std::vector<double> largest(cells.size());
    for (std::size_t i = 0; i < e.size(); ++i) {
      const double v = in_si(impacts[i].speed), mapped = pieces[i / looks](v);
      const double error =
          v < sticking_ * (1 + 1e-6) ? std::abs(mapped * mapped - e[i] * e[i]) : std::abs(mapped - e[i]);
      largest[i / looks] = std::max(largest[i / looks], error);
    }
    return largest;
  }

  const Model& model_;
  const map_options& options_;
  std::array<double, terms> node_;
  Eigen::Matrix<double, terms, terms> to_powers_;
  std::mt19937_64 random_{1};
  double sticking_ = 0, begin_ = 0, end_ = 0, largest_error_ = 0;
};

} // namespace detail

/// e(v) of a model between two speeds, to a largest error that is checked at eight speeds within each piece, one of
/// them at random. Pieces are halved until it is met, next to a kink of e(v) down to the last digits of v. \throws
/// bad_input if low is not positive or not below high, if the error is outside [1e-10, 1e-2], or if a collision cannot
/// be resolved
template <class Model>
restitution_map make_restitution_map(const Model& model, speed low, speed high, const map_options& options = {}) {
  return detail::map_maker<Model>(model, options).make(low, high);
}

} // namespace ricochet
