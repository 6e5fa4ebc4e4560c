#include "libgrid/nested_map.h"

#include "libgrid/grid_view.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace masu {
namespace {

// No more words than this for each cell that they lead to, unless one step down needs them: what is left of
// the depth takes another step.
constexpr std::size_t words_a_cell = 8;
constexpr std::int32_t most_side_log2 = 4;

struct Cube {
  Vec3i first;
  std::int32_t side_log2;
};

class NestedMap {
public:
  NestedMap(const std::vector<Leaf>& leaves, std::vector<std::uint32_t>& words)
      : leaves_(leaves), words_(words) {}

  // The word for the cube, which the cells `inside` divide between them.
  std::uint32_t word_for(const Cube& cube, const std::vector<std::uint32_t>& inside) {
    if (inside.size() == 1) return occupied_bit | inside.front();
    const std::int32_t side = division_of(cube, inside), rest = cube.side_log2 - side;
    const std::size_t place = words_.size(), count = std::size_t{1} << (3 * side);
    words_.resize(place + count);

    // The cells inside each part, by counting.
    const auto for_each_part = [&](std::uint32_t cell, const auto& act) {
      const VoxelBox& box = leaves_[cell].box;
      const std::int32_t last = (1 << side) - 1;
      Vec3i from{}, to{};
      for (int axis = 0; axis < 3; ++axis) {
        from.set(axis, std::max(box.first[axis] - cube.first[axis], 0) >> rest);
        to.set(axis, std::min((box.end[axis] - 1 - cube.first[axis]) >> rest, last));
      }
      for (std::int32_t z = from.z; z <= to.z; ++z)
        for (std::int32_t y = from.y; y <= to.y; ++y)
          for (std::int32_t x = from.x; x <= to.x; ++x)
            act(index_in_block({x, y, z}, side));
    };
    std::vector<std::uint32_t> begin(count + 1, 0);
    for (const std::uint32_t cell : inside)
      for_each_part(cell, [&](std::uint32_t part) { ++begin[part + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> cells(begin.back()), next(begin.begin(), begin.end() - 1);
    for (const std::uint32_t cell : inside)
      for_each_part(cell, [&](std::uint32_t part) { cells[next[part]++] = cell; });

    std::vector<std::uint32_t> of_part;
    const std::int32_t mask = (1 << side) - 1;
    for (std::uint32_t part = 0; part < count; ++part) {
      const auto number = static_cast<std::int32_t>(part);
      const Vec3i offset{number & mask, (number >> side) & mask, number >> (2 * side)};
      of_part.assign(cells.begin() + begin[part], cells.begin() + begin[part + 1]);
      const Vec3i first{cube.first.x + (offset.x << rest), cube.first.y + (offset.y << rest),
                        cube.first.z + (offset.z << rest)};
      words_[place + part] = word_for({first, rest}, of_part);
    }
    return static_cast<std::uint32_t>(place) | static_cast<std::uint32_t>(side);
  }

private:
  // Into how many parts a side (as a power of two): so many that every part is in one cell, if that doesn't
  // take too many words.
  std::int32_t division_of(const Cube& cube, const std::vector<std::uint32_t>& inside) const {
    std::uint32_t planes = 0;
    const std::int32_t side = 1 << cube.side_log2;
    for (const std::uint32_t cell : inside) {
      for (int axis = 0; axis < 3; ++axis) {
        for (const std::int32_t plane : {leaves_[cell].box.first[axis], leaves_[cell].box.end[axis]}) {
          const std::int32_t at = plane - cube.first[axis];
          if (at > 0 && at < side) planes |= static_cast<std::uint32_t>(at);
        }
      }
    }
    std::int32_t log2 = std::min(cube.side_log2 - std::countr_zero(planes), most_side_log2);
    while (log2 > 1 && (std::size_t{1} << (3 * log2)) > words_a_cell * inside.size())
      --log2;
    return log2;
  }

  const std::vector<Leaf>& leaves_;
  std::vector<std::uint32_t>& words_;
};

} // namespace

std::uint32_t append_nested_map(const std::vector<Leaf>& leaves, const Vec3i& first, std::int32_t side_log2,
                                std::vector<std::uint32_t>& words) {
  std::vector<std::uint32_t> all(leaves.size());
  std::iota(all.begin(), all.end(), 0U);
  return NestedMap(leaves, words).word_for({first, side_log2}, all);
}

} // namespace masu
