#include "arguments.hpp"
#include "as_typed.hpp"
#include "row.hpp"

#include <ricochet/version.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <fstream>

namespace fit_restitution {

namespace {

constexpr const char* description =
    "Finds the parameters with which a model gives measured coefficients of restitution best, and how well they are "
    "known.";

constexpr const char* details = R"(
DATA
  A table (CSV). Lines that begin with # are comments; the first other line names the columns, in any order:

    speed        m/s, of the bodies relative to each other, along the normal
    restitution  a number, or the word captured where the pair stuck
    error        standard deviation of the restitution; without this column it is estimated from the scatter

  and any other column that collisions takes (collisions --help lists them), where it differs from row to row, such as
  radius_1.

WHAT IS FITTED
  Model, bodies and laws are columns too: from --scene, a table with one row, or from --set. Those sought are --free,
  between two values; where both are above zero, by their logarithm. With --tie a column is a multiple of a free one, as
  bulk_time is where both come from one relaxation time: A = T_vis/nu^2.

OUTPUT
  On the screen, and with -o out/ice in

    out/ice.json          values, intervals, correlations, residuals, and what they were found from
    out/ice_points.csv    measured and fitted restitutions
    out/ice_curve.csv     the fitted curve
    out/ice.gp, .svg, .png  the figure, if gnuplot is there

  Intervals are by profile likelihood; warnings say what the data do not tell.
  Exit status: 0 fitted, 1 no fit, 2 wrong use or unreadable file.

EXAMPLE
  fit_restitution ice.csv --scene ice_scene.csv --free work_of_adhesion=0.05:5 --free relaxation_time=1e-13:1e-9
      --tie bulk_time=16*relaxation_time -o out/ice
)";

double number_in(const std::string& text, const std::string& option) {
  double x = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), x);
  if (text.empty() || fault != std::errc() || end != text.data() + text.size())
    throw ricochet::bad_input(fmt::format("{}: {} is not a number", option, collisions::quoted(text)));
  return x;
}

/// COLUMN=REST
std::pair<std::string, std::string> assignment(const std::string& text, const std::string& option,
                                               const std::string& form) {
  const std::size_t at = text.find('=');
  if (at == std::string::npos || at == 0 || at + 1 == text.size())
    throw ricochet::bad_input(fmt::format("{} {} is not of the form {}", option, text, form));
  return {text.substr(0, at), text.substr(at + 1)};
}

ricochet::free_parameter free_of(const std::string& text) {
  const std::string form = "COLUMN=LOW:HIGH";
  const auto [column, limits] = assignment(text, "--free", form);
  const std::size_t colon = limits.find(':');
  if (colon == std::string::npos)
    throw ricochet::bad_input(fmt::format("--free {} is not of the form {}", text, form));
  const std::string option = "--free " + column;
  const double low = number_in(limits.substr(0, colon), option), high = number_in(limits.substr(colon + 1), option);
  if (!(low < high))
    throw ricochet::bad_input(fmt::format("{}: {} is not below {}", option, low, high));
  return {column, low, high};
}

tie tie_of(const std::string& text) {
  const std::string form = "COLUMN=FACTOR*COLUMN";
  const auto [column, product] = assignment(text, "--tie", form);
  const std::size_t star = product.find('*');
  if (star == std::string::npos)
    throw ricochet::bad_input(fmt::format("--tie {} is not of the form {}", text, form));
  return {column, number_in(product.substr(0, star), "--tie " + column), product.substr(star + 1)};
}

/// The one row of a table, by columns; blank cells are left out.
columns scene_in(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw collisions::file_error("cannot read " + file);
  collisions::csv_reader reader(in);
  reader.comments();
  collisions::csv_record names, cells, more;
  if (!reader.next(names) || !reader.next(cells) || reader.next(more))
    throw ricochet::bad_input("--scene " + file + ": it is to have a line of columns and one row");
  const collisions::header header(names);
  const collisions::row row(header, cells);
  columns scene;
  for (const std::string& cell : header.cells()) {
    const std::string column = collisions::trimmed(cell);
    if (!row.is_blank(column))
      scene[column] = row.text(column, "the scene");
  }
  return scene;
}

} // namespace

std::optional<arguments> read_arguments(int argc, const char* const* argv, int& status) {
  arguments given;
  std::string scene, output;
  std::vector<std::string> set, free, ties;
  CLI::App app(description, "fit_restitution");
  app.add_option("data", given.data, "file with the measurements")->type_name("DATA")->required();
  app.add_option("--scene", scene, "file with the other columns, in one row")->type_name("FILE");
  app.add_option("--set", set, "another column; instead of the one in --scene")->type_name("COLUMN=VALUE");
  app.add_option("--free", free, "a parameter sought, and where")->type_name("COLUMN=LOW:HIGH")->required();
  app.add_option("--tie", ties, "a column that is a multiple of a free one")->type_name("COLUMN=FACTOR*COLUMN");
  app.add_option("-o,--output", output, "beginning of the files' names; without it none are written")
      ->type_name("PREFIX");
  app.add_option("--confidence", given.options.confidence, "of the intervals, below 1; 0: none")
      ->capture_default_str()
      ->type_name("NUMBER");
  app.add_option("--starts", given.options.starts,
                 "points of the ranges that are looked at before the best are followed")
      ->capture_default_str()
      ->type_name("NUMBER");
  app.add_option("--tolerance", given.options.tolerance, "error of each restitution computed, 1e-12 to 1e-1")
      ->capture_default_str()
      ->type_name("NUMBER");
  app.add_option("--threads", given.options.threads, "at once; 0: as many as the machine has")
      ->capture_default_str()
      ->type_name("NUMBER");
  app.set_version_flag("--version", std::string("fit_restitution of ricochet ") + ricochet::version);
  app.footer(details);
  const auto wrong = [&](const std::string& why) {
    std::fprintf(stderr, "fit_restitution: %s\n", why.c_str());
    status = 2;
    return std::nullopt;
  };
  try {
    app.parse(argc, argv);
    columns in_file;
    if (!scene.empty())
      in_file = scene_in(scene);
    for (const std::string& each : free) {
      given.free.push_back(free_of(each));
      in_file.erase(given.free.back().name); // there it may have a first guess
    }
    for (const std::string& each : ties) {
      given.ties.push_back(tie_of(each));
      in_file.erase(given.ties.back().column);
    }
    for (const std::string& each : set) {
      const auto added = given.scene.insert(assignment(each, "--set", "COLUMN=VALUE"));
      if (!added.second)
        throw ricochet::bad_input(fmt::format("{} is set twice by --set", added.first->first));
      given.set.push_back(added.first->first);
    }
    given.scene.merge(in_file); // those set stay as they are
    if (output.ends_with('/') || std::filesystem::is_directory(output))
      throw ricochet::bad_input(fmt::format("-o {} is a folder: add the beginning of the files' names, as in {}/fit",
                                            output,
                                            output.ends_with('/') ? output.substr(0, output.size() - 1) : output));
    if (!output.empty())
      for (const char* ending : {".json", "_points.csv", "_curve.csv", ".gp", ".svg", ".png"})
        for (const std::string& input : {given.data, scene})
          if (std::error_code ignored; std::filesystem::equivalent(output + ending, input, ignored))
            throw ricochet::bad_input(fmt::format("-o {} would overwrite {}", output, input));
    ricochet::require("--tolerance", given.options.tolerance, ricochet::tolerance_range);
    ricochet::require("--starts", double(given.options.starts), ricochet::range{.low = 1});
    ricochet::require("--confidence", given.options.confidence, ricochet::range{.high = 1});
  } catch (const CLI::ParseError& ended) {
    if (ended.get_exit_code() != 0)
      return wrong(std::string(ended.what()) + "; see fit_restitution --help");
    status = app.exit(ended);
    return {};
  } catch (const collisions::row_error& error) {
    return wrong(fmt::format("--scene {}{}{}: {}", scene, error.place.empty() ? "" : ", ", error.place, error.what()));
  } catch (const std::exception& refused) {
    return wrong(refused.what());
  }
  given.output = output;
  given.command = collisions::command_as_typed("fit_restitution", argc, argv);
  return given;
}

} // namespace fit_restitution
