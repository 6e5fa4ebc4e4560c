#include "libgrid/stretch.h"

#include "libgrid/grid_file.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace masu {
namespace {

using Range = std::array<std::int32_t, 2>; // first and end along an axis
using Ranges = std::array<Range, 3>;

Ranges ranges_of(const MergedCell& cell) {
  const auto range = [](std::uint32_t packed) {
    return Range{static_cast<std::int32_t>(packed & 0xffff), static_cast<std::int32_t>(packed >> 16)};
  };
  return {range(cell.x), range(cell.y), range(cell.z)};
}

void set_ranges(MergedCell& cell, const Ranges& ranges) {
  const auto packed = [](const Range& range) {
    return static_cast<std::uint32_t>(range[0]) | static_cast<std::uint32_t>(range[1]) << 16;
  };
  cell.x = packed(ranges[0]);
  cell.y = packed(ranges[1]);
  cell.z = packed(ranges[2]);
}

// Whether all that `part` lists is listed by `whole`.
bool lists_all(const PrimitiveIndex* references, std::uint32_t whole, std::uint32_t part) {
  if (part == empty_list) return true;
  if (whole == empty_list) return false;
  for (;;) {
    const PrimitiveIndex wanted = references[part], found = references[whole];
    if ((wanted & ~last_bit) == (found & ~last_bit)) {
      if ((wanted & last_bit) != 0) return true;
      ++part;
    } else if ((wanted & ~last_bit) < (found & ~last_bit)) {
      return false;
    }
    if ((found & last_bit) != 0) return false;
    ++whole;
  }
}

class Stretcher {
public:
  explicit Stretcher(Grid& grid) : grid_(grid), view_(merged_view_of<double>(grid)), own_(grid.cells) {}

  void pass() {
    const std::vector<MergedCell> before(grid_.cells);
    blocked_.resize(before.size(), 0);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, before.size(), 1024), [&](const auto& range) {
      for (std::size_t i = range.begin(); i != range.end(); ++i)
        stretch_cell(i, before);
    });
  }

private:
  void stretch_cell(std::size_t number, const std::vector<MergedCell>& before) {
    if (blocked_[number] == all_blocked) return;
    MergedCell& cell = grid_.cells[number];
    Ranges ranges = ranges_of(cell);
    for (unsigned direction = 0; direction < 6; ++direction) {
      // What is in the way stays in the way: the face only grows.
      if ((blocked_[number] & (1U << direction)) != 0) continue;
      if (!stretch_towards(direction, cell.list, before, ranges))
        blocked_[number] = static_cast<std::uint8_t>(blocked_[number] | (1U << direction));
    }
    set_ranges(cell, ranges);
  }

  // As far as every neighbour on that side lets it; false when one doesn't, or where they are very many: one
  // of them would sooner or later.
  bool stretch_towards(unsigned direction, std::uint32_t list, const std::vector<MergedCell>& before,
                       Ranges& ranges) const {
    const unsigned axis = direction / 2, side = direction % 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    Range& along = ranges[axis];
    if (side == 0 ? along[0] == 0 : along[1] == view_.division[static_cast<int>(axis)]) return false;
    std::int32_t reach = side == 0 ? 0 : 0xffff;
    int seen = 0;
    Vec3i voxel{};
    voxel.set(static_cast<int>(axis), side == 0 ? along[0] - 1 : along[1]);
    for (std::int32_t j = ranges[v][0], next_j; j < ranges[v][1]; j = next_j) {
      voxel.set(static_cast<int>(v), j);
      next_j = ranges[v][1];
      for (std::int32_t i = ranges[u][0]; i < ranges[u][1];) {
        voxel.set(static_cast<int>(u), i);
        const std::uint32_t neighbour = cell_number(view_, voxel);
        if (++seen > most_neighbours || !lists_all(grid_.references.data(), list, before[neighbour].list))
          return false;
        const Ranges own = ranges_of(own_[neighbour]);
        const Ranges stretched = ranges_of(before[neighbour]);
        reach = side == 0 ? std::max(reach, stretched[axis][0]) : std::min(reach, stretched[axis][1]);
        next_j = std::min(next_j, own[v][1]);
        i = own[u][1];
      }
    }
    along[side] = reach;
    return true;
  }

  static constexpr std::uint8_t all_blocked = 0x3f;
  static constexpr int most_neighbours = 32;
  Grid& grid_;
  MergedGridView<double> view_;
  std::vector<MergedCell> own_;
  std::vector<std::uint8_t> blocked_;
};

} // namespace

void stretch(Grid& grid, int passes) {
  Stretcher stretcher(grid);
  for (int i = 0; i < passes; ++i)
    stretcher.pass();
}

} // namespace masu
