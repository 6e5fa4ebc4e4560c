// Lists of rays as text: CSV whose first line names the columns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace masu {

// Reads a list a piece of its text at a time. Columns, in any order: ox, oy, oz, dx, dy, dz, and tmin (0
// without it) and tmax (infinity). Blank lines are skipped. Throws Error(input, "name:line:column", …).
//
// It is a value: a copy goes on from where the original is, and one whose line is set from the beginning of
// that line.
class RayCsv {
public:
  explicit RayCsv(std::string name) : name_(std::move(name)) {}

  // Reads the names. `text`: from the start on; unless `is_all` is true, more of it follows. Returns how many
  // bytes they took: none where the line doesn't end in `text`.
  std::size_t read_names(std::string_view text, bool is_all);
  // Appends the next rays, up to so many. Returns how many bytes of `text` their lines took.
  std::size_t read_rays(std::string_view text, bool is_all, std::size_t count, std::vector<double>& rays);
  // The same, of rays that aren't looked at: how many there are is added to `rays`.
  std::size_t skip_rays(std::string_view text, bool is_all, std::size_t count, std::uint64_t& rays);

  // A ray is 6 (origin, direction) or 8 (origin, tmin, direction, tmax).
  int numbers() const { return has_limits_ ? 8 : 6; }
  std::uint64_t line() const { return line_; } // that was read last, from 1 on
  void set_line(std::uint64_t line) { line_ = line; }

private:
  [[noreturn]] void fail(std::string_view line, const char* position, const std::string& what) const;
  template <class Act>
  std::size_t each_line(std::string_view text, bool is_all, std::size_t count, const Act& act);
  double number(std::string_view line, const char*& position) const;

  std::string name_;
  bool has_limits_ = false;
  std::vector<std::size_t> columns_; // for each column, the index of its number among the 8 of a ray
  std::uint64_t line_ = 0;
};

} // namespace masu
