// The columns of the input that mean something.
#pragma once
#include "row.hpp"

#include <optional>
#include <string>
#include <vector>

namespace collisions {

/// Unit of an input column, "" of text; nothing if there is no such column.
std::optional<std::string> unit_of(const std::string& column);

/// "; did you mean radius_1?" where a name is nearly that of an input column, else empty.
std::string hint_for(const std::string& name);

/// Input columns with units and who needs them, one a line, for the help.
std::string input_help();

/// A sentence for each column of the header that is no input column but nearly has the name of one.
std::vector<std::string> notes_on_misspelt(const header& header);

} // namespace collisions
