#include "arguments.hpp"
#include "as_typed.hpp"
#include "input_columns.hpp"
#include "output_table.hpp"
#include "scene_reader.hpp"

#include <ricochet/solve/collide.hpp>
#include <ricochet/version.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace collisions {

namespace {

constexpr const char* description =
    "Reads a table of collisions of small spheres (CSV) and writes the same table with their outcomes.";

std::string help_on_columns() {
  std::string text = R"(
INPUT
  The first line names the columns, in any order; each further line is a collision. Numbers are in SI units, with a
  decimal point. Cells are separated by commas. Lines before the header that begin with # are comments. The text is
  UTF-8; a line, or a row whose quoted cells hold line ends, has at most 1 MiB.

  column                     unit    needed by
)";
  text += input_help();
  text += R"(
  What a row's model does not need may be blank, or its column missing; angle and spins are then 0. Other columns are
  copied, with a note on standard error where one nearly has a name from above.

LAWS for the column model
  hertz, linear              elastic spheres, or linear springs, without adhesion; always one of them
  jkr, line_force, dmt, maugis_dugdale
                             adhesion; one of them; maugis_dugdale without friction
  greenwood, greenwood_fit, maugis_barquins
                             finite speed of the adhesive edge, with jkr: exact, as published, or a power law; one of
                             them
  kuwabara_kono, hunt_crossley, tsuji
                             damping in the bulk, with hertz; one of them
  linear_dashpot             damping, with linear
  coulomb, mindlin           friction of oblique impacts and spinning bodies: slides or rolls as a whole, or sticks and
                             slips at once (with hertz, not with jkr); one of them
  coulomb_with_peeling       coulomb, and a moment that resists rolling; of a sphere on a wall, with line_force
  thornton_ning              plastic flow, its loss added to those of the motion; with hertz, without friction
  thornton_ning_contact      the same within the motion; alone or with jkr, without greenwood and the like
  end_at_zero_force, end_at_zero_overlap
                             where a contact without adhesion ends; at zero force if none is named

  linear, maugis_dugdale, maugis_barquins, mindlin, coulomb_with_peeling and thornton_ning_contact go with the
  automatic stepper only.

OUTPUT
  All columns of the input, then these. A column of the input that has one of these names is called input_... there.

  column                     unit    meaning
)";
  text += output_help();
  text += R"(
  A row that cannot be computed is marked failed, with the reason on standard error, and the others go on.
  With -o the rows are in FILE.part until it is whole; after an interruption the same command goes on from there, once
  each row kept has been found in the input. Delete FILE.part to begin anew.
  Exit status: 0 all rows computed, 1 some failed or unresolved, 2 wrong use or unreadable file.

EXAMPLE
  a file ice.csv: two ice spheres of radius 2 um at 8 m/s, and an ice sphere against a steel wall

    model,radius_1,radius_2,density_1,density_2,youngs_modulus_1,youngs_modulus_2,poissons_ratio_1,poissons_ratio_2,work_of_adhesion,bulk_time,speed
    hertz+jkr,2e-6,2e-6,1000,1000,7e9,7e9,0.25,0.25,0.74,,8
    hertz+kuwabara_kono,2e-6,inf,1000,,7e9,190e9,0.25,0.28,,1.6e-10,8

  collisions ice.csv -o outcomes.csv
)";
  return text;
}

} // namespace

std::optional<arguments> read_arguments(int argc, const char* const* argv, int& status) {
  arguments given;
  std::string stepper(steppers[0].name);
  std::vector<std::string> names;
  for (const stepper_choice& choice : steppers)
    names.emplace_back(choice.name);

  CLI::App app(description, "collisions");
  app.add_option("input", given.input, "file to read; standard input if none is given")->type_name("FILE");
  app.add_option("-o,--output", given.output, "file to write, in place only when it is whole; else standard output")
      ->type_name("FILE");
  app.add_option("--tolerance", given.tolerance, "largest error wanted in the restitution, 1e-12 to 1e-1")
      ->capture_default_str()
      ->type_name("NUMBER");
  app.add_option("--stepper", stepper, "how to integrate: automatic, dopri5 or bulirsch_stoer")
      ->capture_default_str()
      ->type_name("NAME")
      ->check(CLI::IsMember(names));
  app.set_version_flag("--version", std::string("collisions of ricochet ") + ricochet::version);
  app.footer(help_on_columns());
  try {
    app.parse(argc, argv);
    ricochet::require("--tolerance", given.tolerance, ricochet::tolerance_range);
    if (app.count("--output") != 0 && given.output.empty())
      throw ricochet::bad_input("--output: the name of the file is empty");
    if (app.count("input") != 0 && given.input.empty())
      throw ricochet::bad_input("the name of the input file is empty");
  } catch (const CLI::ParseError& ended) {
    if (ended.get_exit_code() == 0) { // --help, --version
      status = app.exit(ended);
    } else {
      std::fprintf(stderr, "collisions: %s; see collisions --help\n", ended.what());
      status = 2;
    }
    return {};
  } catch (const ricochet::bad_input& refused) {
    std::fprintf(stderr, "collisions: %s\n", refused.what());
    status = 2;
    return {};
  }
  for (const stepper_choice& choice : steppers)
    if (choice.name == stepper)
      given.stepper = choice;
  given.command = command_as_typed("collisions", argc, argv);
  return given;
}

} // namespace collisions
