// The cells of one row by the names of their columns.
#pragma once
#include "csv_reader.hpp"
#include "errors.hpp"

#include <ricochet/body/validate.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace collisions {

/// Text without the spaces and tabs around it.
std::string trimmed(const std::string& text);

/// Names of the columns. \throws file_error if two are alike.
class header {
public:
  explicit header(const csv_record& record);
  const std::vector<std::string>& cells() const { return cells_; } ///< as they stand
  bool has(const std::string& name) const { return places_.contains(name); }
  std::size_t place_of(const std::string& name) const { return places_.at(name); }

private:
  std::vector<std::string> cells_;
  std::map<std::string, std::size_t> places_;
};

class row {
public:
  /// \throws row_error unless the record has a cell for every column.
  row(const header& header, const csv_record& record);

  bool is_blank(const std::string& column) const;

  /// The cell without spaces around it. \throws row_error, with who needs it, if it is blank or there is no such
  /// column.
  std::string text(const std::string& column, std::string_view needed_by) const;

  /// A number, whole and finite or within `allowed`, times one SI unit of Quantity. \throws row_error
  template <class Quantity>
  Quantity quantity(const std::string& column, const ricochet::range& allowed, std::string_view needed_by) const {
    const double x = number(column, needed_by);
    return checked(column, [&] {
      Quantity value;
      if constexpr (std::is_same_v<Quantity, double>)
        value = x;
      else
        value = Quantity::from_value(x);
      ricochet::require(column, value, allowed);
      return value;
    });
  }

  /// What `action` returns; if the library refuses, that is a fault of this cell. \throws row_error
  template <class Action>
  auto checked(const std::string& column, const Action& action) const {
    try {
      return action();
    } catch (const ricochet::bad_input& refused) {
      throw row_error(place(column), refused.what());
    }
  }

  /// `column radius_1, value "-1"`, for messages.
  std::string place(const std::string& column) const;

  /// Input columns that are not blank, and that nobody has asked for.
  std::vector<std::string> unread() const;

private:
  double number(const std::string& column, std::string_view needed_by) const;
  const std::string& cell(const std::string& column) const {
    const std::size_t place = header_.place_of(column);
    read_[place] = true;
    return record_.cells[place];
  }

  const header& header_;
  const csv_record& record_;
  mutable std::vector<bool> read_;
};

} // namespace collisions
