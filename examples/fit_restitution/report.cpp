#include "report.hpp"
#include "input_columns.hpp"

#include <ricochet/study/sweep.hpp>
#include <ricochet/study/table.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <spawn.h>
#include <sys/wait.h>

namespace fit_restitution {

namespace {

std::string with_unit(const std::string& number, const std::string& column) {
  const std::string unit = *collisions::unit_of(column);
  return unit == "1" ? number : number + ' ' + unit;
}

std::size_t captured_in(const ricochet::measured_curve& data) {
  return std::size_t(
      std::count_if(data.data.begin(), data.data.end(), [](const auto& each) { return !each.restitution; }));
}

std::string model_of(const arguments& given) {
  const auto model = given.scene.find("model");
  return model == given.scene.end() ? "models as in " + given.data : model->second;
}

/// Whose the fitted curve is, where measurements differ by more than their speed.
std::string of_which(const family& family) {
  return family.alike() ? "" : fmt::format(", all but the speed as in line {}", family.measured().lines[0]);
}

nlohmann::json as_json(const arguments& given, const family& family, const ricochet::fit_result& found) {
  using nlohmann::json;
  const ricochet::measured_curve& data = family.measured();
  json all;
  all["program"] = std::string("fit_restitution of ricochet ") + ricochet::version;
  all["command"] = given.command;
  all["data"] = {{"file", given.data},
                 {"comments", data.comments},
                 {"measurements", data.data.size()},
                 {"captured", captured_in(data)}};
  all["scene"] = given.scene;
  all["tolerance"] = given.options.tolerance;
  all["confidence"] = given.options.confidence;
  for (std::size_t k = 0; k < found.parameters.size(); ++k) {
    const auto& p = found.parameters[k];
    json parameter{{"name", p.name},
                   {"unit", *collisions::unit_of(p.name)},
                   {"value", p.value},
                   {"standard_error", p.standard_error},
                   {"searched", {given.free[k].low, given.free[k].high}}};
    if (given.options.confidence > 0)
      parameter["interval"] = {p.low, p.high};
    all["parameters"].push_back(parameter);
  }
  for (const auto& [column, value] : family.tied(values_of(found)))
    all["tied"][column] = value;
  all["chi_square"] = found.chi_square;
  all["degrees_of_freedom"] = found.degrees_of_freedom;
  all["scatter"] = found.scatter;
  for (Eigen::Index k = 0; k < found.correlation.rows(); ++k)
    all["correlation"].push_back(std::vector<double>(found.correlation.row(k).begin(), found.correlation.row(k).end()));
  all["warnings"] = found.warnings;
  for (std::size_t i = 0; i < data.data.size(); ++i) {
    const auto& m = data.data[i];
    all["residuals"].push_back({{"speed", ricochet::in_si(m.speed)}, {"measured_minus_fitted", found.residuals[i]}});
  }
  all["collisions"] = found.collisions;
  return all;
}

void write_text(const std::string& file, const std::string& text) {
  std::ofstream out(file);
  out << text;
  out.close();
  if (!out)
    throw std::runtime_error("cannot write " + file);
}

/// In single quotes, as gnuplot has them.
std::string in_quotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    out += c == '\'' ? "''" : std::string(1, c);
  return out + "'";
}

/// Round numbers about the speeds.
std::string tics(const ricochet::measured_curve& data) {
  const auto slower = [](const auto& a, const auto& b) { return a.speed < b.speed; };
  const auto [low, high] = std::minmax_element(data.data.begin(), data.data.end(), slower);
  const double first = std::log10(ricochet::in_si(low->speed)), last = std::log10(ricochet::in_si(high->speed));
  const std::vector<double> steps =
      last - first < 0.7 ? std::vector<double>{1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8} : std::vector<double>{1, 2, 5};
  std::string all;
  for (int decade = int(std::floor(first)) - 1; decade <= last + 1; ++decade)
    for (const double step : steps)
      all += fmt::format("{}{}e{}", all.empty() ? "" : ", ", step, decade);
  return all;
}

std::string figure_script(const arguments& given, const family& family) {
  const ricochet::measured_curve& data = family.measured();
  const std::string prefix = given.output.string();
  const bool errors = data.data[0].error > 0, captured = captured_in(data) > 0;
  const bool far_from_zero = std::all_of(data.data.begin(), data.data.end(),
                                         [](const auto& each) { return each.restitution.value_or(0) > 0.5; });
  const std::string bars = errors ? "with yerrorbars" : "with points";
  const auto columns = [&](const char* value) {
    return fmt::format("using 'speed':'{}'{}", value, errors ? ":'error'" : "");
  };
  std::string script =
      fmt::format(R"(# {}
points = {}
curve = {}
blue = '#0072b2'; red = '#d55e00'
do for [format in 'svg png'] {{
  reset
  set datafile separator ','
  set datafile missing NaN
  if (format eq 'svg') {{
    set terminal svg size 800,700 font 'Helvetica,14' background '#ffffff'
    set output {}
  }} else {{
    set terminal pngcairo size 1200,1050 font 'Helvetica,18' background '#ffffff'
    set output {}
  }}
  set multiplot
  set grid xtics ytics lc rgb '#dddddd' lt 1
  set logscale x
  set format x ''
  set xtics ({})
  set lmargin at screen 0.11
  set rmargin at screen 0.97
  set tmargin at screen 0.88
  set bmargin at screen 0.38
  set yrange [{}:*]
  set ylabel 'coefficient of restitution'
  set key horizontal center at screen 0.54, 0.905 samplen 2
  set title {} noenhanced offset 0,1.4
  stats curve using 'speed' nooutput
  set xrange [STATS_min:STATS_max]
  plot curve using 'speed':'restitution' with lines lw 2.5 lc rgb blue title {}, \
       points {} {} pt 7 ps 0.8 lc rgb red title 'measured'{}
  set format x '%g'
  set ytics autofreq
  set tmargin at screen 0.35
  set bmargin at screen 0.10
  unset title
  unset key
  set yrange [*:*]
  set xlabel 'speed (m/s)'
  set ylabel 'measured - fitted'
  plot 0 with lines lw 1.5 lc rgb blue, points {} {} pt 7 ps 0.8 lc rgb red
  unset multiplot
}}
)",
                  given.command, in_quotes(prefix + "_points.csv"), in_quotes(prefix + "_curve.csv"),
                  in_quotes(prefix + ".svg"), in_quotes(prefix + ".png"), tics(data), far_from_zero ? "*" : "0",
                  in_quotes(model_of(given)), in_quotes("fitted" + of_which(family)), columns("measured"), bars,
                  captured ? ", \\\n       points using 'speed':(column('captured') == 1 ? 0 : NaN) with points "
                             "pt 6 ps 1.4 lw 1.5 lc rgb red title 'measured: captured'"
                           : "",
                  columns("measured_minus_fitted"), bars);
  return script;
}

/// Runs gnuplot; false if that is not there, or fails.
bool draw(const std::string& script) {
  std::string program = "gnuplot", file = script;
  char* const arguments[] = {program.data(), file.data(), nullptr};
  pid_t child = 0;
  int status = 0;
  return posix_spawnp(&child, program.c_str(), nullptr, nullptr, arguments, environ) == 0 &&
         waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

std::vector<double> values_of(const ricochet::fit_result& found) {
  std::vector<double> values;
  for (const auto& parameter : found.parameters)
    values.push_back(parameter.value);
  return values;
}

void print(const arguments& given, const ricochet::measured_curve& data, const ricochet::fit_result& found) {
  fmt::print("{}: {} measurements, {} of them captured; {}\n", given.data, data.data.size(), captured_in(data),
             model_of(given));
  for (const auto& p : found.parameters) {
    fmt::print("{:<27} = {}, standard error {:.2g}", p.name, with_unit(fmt::format("{:.6g}", p.value), p.name),
               p.standard_error);
    if (given.options.confidence > 0)
      fmt::print(", {:g} % between {:.6g} and {:.6g}", 100 * given.options.confidence, p.low, p.high);
    fmt::print("\n");
  }
  if (data.data[0].error > 0)
    fmt::print("chi^2 = {:.4g} of {} degrees of freedom\n", found.chi_square, found.degrees_of_freedom);
  else
    fmt::print("scatter of one restitution: {:.3g}, from {} degrees of freedom\n", found.scatter,
               found.degrees_of_freedom);
  for (std::size_t k = 0; k < found.parameters.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) {
      const double c = found.correlation(Eigen::Index(k), Eigen::Index(l));
      fmt::print("correlation of {} and {}: {}\n", found.parameters[l].name, found.parameters[k].name,
                 std::isnan(c) ? "undetermined" : fmt::format("{:.4f}", c));
    }
  fmt::print("{} collisions computed\n", found.collisions);
  for (const std::string& warning : found.warnings)
    fmt::print("note: {}\n", warning);
}

std::vector<std::string> write(const arguments& given, const family& family, const ricochet::fit_result& found) {
  const ricochet::measured_curve& data = family.measured();
  const std::string prefix = given.output.string();
  if (given.output.has_parent_path())
    std::filesystem::create_directories(given.output.parent_path());
  std::vector<std::string> written{prefix + ".json", prefix + "_points.csv", prefix + "_curve.csv", prefix + ".gp"};
  write_text(written[0], as_json(given, family, found).dump(2) + "\n");

  const double none = std::numeric_limits<double>::quiet_NaN();
  double slowest = std::numeric_limits<double>::infinity(), fastest = 0;
  ricochet::table points(written[1], given.command, "measured and fitted restitution",
                         {{"speed", "m/s"},
                          {"measured", "1"},
                          {"captured", "1 or 0"},
                          {"error", "1"},
                          {"fitted", "1"},
                          {"measured_minus_fitted", "1"}});
  for (std::size_t i = 0; i < data.data.size(); ++i) {
    const auto& m = data.data[i];
    const double v = ricochet::in_si(m.speed), e = m.restitution.value_or(0);
    points.row({v, m.restitution.value_or(none), m.restitution ? 0. : 1., m.error > 0 ? m.error : none,
                e - found.residuals[i], found.residuals[i]});
    slowest = std::min(slowest, v);
    fastest = std::max(fastest, v);
  }
  points.finish();

  std::vector<double> speeds;
  using ricochet::units::metres_per_second;
  for (const auto& v :
       ricochet::logarithmic_speeds(slowest / 1.3 * metres_per_second, fastest * 1.3 * metres_per_second, 241))
    speeds.push_back(ricochet::in_si(v));
  const std::vector<double> e = family.restitutions(values_of(found), 1e-6, speeds);
  ricochet::table curve(written[2], given.command,
                        "fitted restitution of " + model_of(given) + of_which(family) + "; 0: captured",
                        {{"speed", "m/s"}, {"restitution", "1"}});
  for (std::size_t i = 0; i < speeds.size(); ++i)
    curve.row({speeds[i], e[i]});
  curve.finish();

  write_text(written[3], figure_script(given, family));
  if (draw(written[3])) {
    written.push_back(prefix + ".svg");
    written.push_back(prefix + ".png");
  } else {
    fmt::print(stderr, "fit_restitution: no figure: gnuplot is not there, or did not take {}\n", written[3]);
  }
  return written;
}

} // namespace fit_restitution
