#include "libgrid/nested_map.h"

#include "libgrid/grid_view.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace masu {
namespace {

// No more words than this for each cell that they lead to, unless one step down needs them: what is left of
// the depth takes another step.
constexpr std::size_t words_a_cell = 4;

// 2^log2 voxels along each axis.
struct Place {
  Vec3i first, log2;
};

std::size_t boxes_of(const Vec3i& log2) {
  return std::size_t{1} << (log2.x + log2.y + log2.z);
}

// Words begin at multiples of the unit.
std::size_t rounded_to_unit(std::size_t words) {
  constexpr std::size_t rest = (std::size_t{1} << place_unit_log2) - 1;
  return (words + rest) & ~rest;
}

class NestedMap {
public:
  NestedMap(const std::vector<Leaf>& leaves, std::vector<std::uint32_t>& words)
      : leaves_(leaves), words_(words) {}

  // The word for the place, which the cells `inside` divide between them.
  std::uint32_t word_for(const Place& place, const std::vector<std::uint32_t>& inside) {
    if (inside.size() == 1) return occupied_bit | inside.front();
    const Vec3i division = division_of(place, inside), rest = place.log2 - division;
    const std::size_t begin_words = words_.size(), count = boxes_of(division);
    words_.resize(begin_words + rounded_to_unit(count));

    // The cells inside each part, by counting.
    const auto for_each_part = [&](std::uint32_t cell, const auto& act) {
      const VoxelBox& box = leaves_[cell].box;
      VoxelRange parts{};
      for (int axis = 0; axis < 3; ++axis) {
        parts.first.set(axis, std::max(box.first[axis] - place.first[axis], 0) >> rest[axis]);
        parts.last.set(
            axis, std::min((box.end[axis] - 1 - place.first[axis]) >> rest[axis], (1 << division[axis]) - 1));
      }
      for_each_voxel(parts, [&](const Vec3i& part) { act(index_in_division(part, division)); });
    };
    std::vector<std::uint32_t> begin(count + 1, 0);
    for (const std::uint32_t cell : inside)
      for_each_part(cell, [&](std::uint32_t part) { ++begin[part + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> cells(begin.back()), next(begin.begin(), begin.end() - 1);
    for (const std::uint32_t cell : inside)
      for_each_part(cell, [&](std::uint32_t part) { cells[next[part]++] = cell; });

    std::vector<std::uint32_t> of_part;
    const VoxelRange all{{0, 0, 0}, {(1 << division.x) - 1, (1 << division.y) - 1, (1 << division.z) - 1}};
    for_each_voxel(all, [&](const Vec3i& part) {
      const std::uint32_t number = index_in_division(part, division);
      of_part.assign(cells.begin() + begin[number], cells.begin() + begin[number + 1]);
      const Vec3i first{place.first.x + (part.x << rest.x), place.first.y + (part.y << rest.y),
                        place.first.z + (part.z << rest.z)};
      const std::uint32_t word = word_for({first, rest}, of_part);
      words_[begin_words + number] = word;
    });
    return map_word({static_cast<std::uint32_t>(begin_words), division});
  }

private:
  // How often along each axis: so often that every part is in one cell, if that doesn't take too many words.
  Vec3i division_of(const Place& place, const std::vector<std::uint32_t>& inside) const {
    Vec3i division{};
    for (int axis = 0; axis < 3; ++axis) {
      std::uint32_t planes = 0;
      for (const std::uint32_t cell : inside) {
        for (const std::int32_t plane : {leaves_[cell].box.first[axis], leaves_[cell].box.end[axis]}) {
          const std::int32_t at = plane - place.first[axis];
          if (at > 0 && at < (1 << place.log2[axis])) planes |= static_cast<std::uint32_t>(at);
        }
      }
      if (planes == 0) continue;
      division.set(axis, std::min(place.log2[axis] - std::countr_zero(planes),
                                  static_cast<std::int32_t>(most_division_log2)));
    }
    while (boxes_of(division) > 2 && boxes_of(division) > words_a_cell * inside.size()) {
      const int most = division.x >= division.y && division.x >= division.z ? 0
                       : division.y >= division.z                           ? 1
                                                                            : 2;
      division.set(most, division[most] - 1);
    }
    return division;
  }

  const std::vector<Leaf>& leaves_;
  std::vector<std::uint32_t>& words_;
};

} // namespace

std::uint32_t append_nested_map(const std::vector<Leaf>& leaves, const Vec3i& first, std::int32_t side_log2,
                                std::vector<std::uint32_t>& words) {
  std::vector<std::uint32_t> all(leaves.size());
  std::iota(all.begin(), all.end(), 0U);
  return NestedMap(leaves, words).word_for({first, {side_log2, side_log2, side_log2}}, all);
}

} // namespace masu
