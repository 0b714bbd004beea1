// One composition of laws with one stepper, and what is looked at in each of its collisions.
#pragma once
#include "finding.hpp"
#include "scene.hpp"

#include <ricochet/solve/accuracy.hpp>

#include <string>
#include <vector>

namespace campaign {

struct instance {
  std::string name; ///< laws joined by +, then the stepper, unless it is the default
  bool by_default_stepper() const { return name.find(" by ") == std::string::npos; }
  /// \throws ricochet::bad_input where the library refuses the scene.
  finding (*solve)(const scene&, const ricochet::collide_options&);
  std::optional<double> (*reference)(const scene&) = nullptr; ///< restitution in long double; not of all
};

// The parts of the whole list, each compiled in a file of its name.
void add_hertzian(std::vector<instance>& all);
void add_adhesive(std::vector<instance>& all);
void add_crack_laws(std::vector<instance>& all);
void add_plastic(std::vector<instance>& all);
void add_oblique(std::vector<instance>& all);
void add_steppers(std::vector<instance>& all);

std::vector<instance> all_instances();

} // namespace campaign
