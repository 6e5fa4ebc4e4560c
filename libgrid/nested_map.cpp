#include "libgrid/nested_map.h"

#include "libgrid/grid_view.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>

namespace masu {
namespace {

// No more words than this for each cell that they lead to, unless one step down needs them: what is left of
// the depth takes another step.
constexpr std::size_t words_a_cell = 4;

constexpr std::size_t most_boxes = std::size_t{1} << (3 * most_division_log2);

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
      : leaves_(leaves), words_(words), cells_(leaves.size()) {
    std::iota(cells_.begin(), cells_.end(), 0U);
  }

  // The word for a place that holds all cells.
  std::uint32_t word_for_all(const Place& place) {
    return cells_.size() == 1 ? occupied_bit : word_for(place, 0, cells_.size());
  }

private:
  // The word for the place, which several cells divide between them: cells_[begin] to before cells_[end].
  std::uint32_t word_for(const Place& place, std::size_t begin, std::size_t end) {
    const Vec3i division = division_of(place, {cells_.data() + begin, cells_.data() + end});
    const Vec3i rest = place.log2 - division;
    const std::size_t begin_words = words_.size(), boxes = boxes_of(division);
    words_.resize(begin_words + rounded_to_unit(boxes));

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
    // Most parts are in one cell, and their words are done; the cells of the others go behind all those that
    // are waiting, part by part.
    std::uint32_t counts[most_boxes];
    std::fill_n(counts, boxes, 0U);
    for (std::size_t i = begin; i != end; ++i) {
      const std::uint32_t cell = cells_[i];
      for_each_part(cell, [&](std::uint32_t part) {
        ++counts[part];
        words_[begin_words + part] = occupied_bit | cell;
      });
    }
    std::size_t ends[most_boxes];
    const std::size_t waiting_before = cells_.size();
    std::size_t waiting = waiting_before;
    for (std::size_t part = 0; part < boxes; ++part) {
      ends[part] = waiting;
      if (counts[part] > 1) waiting += counts[part];
    }
    cells_.resize(waiting);
    for (std::size_t i = begin; i != end && waiting != waiting_before; ++i) {
      const std::uint32_t cell = cells_[i];
      for_each_part(cell, [&](std::uint32_t part) {
        if (counts[part] > 1) cells_[ends[part]++] = cell;
      });
    }
    for (std::uint32_t part = 0; part < boxes; ++part) {
      if (counts[part] < 2) continue;
      const auto at = [&](std::int32_t from, std::uint32_t number, std::int32_t log2) {
        return from + static_cast<std::int32_t>(number << log2);
      };
      const auto low = [](std::uint32_t number, std::int32_t bits) { return number & ((1U << bits) - 1); };
      const Vec3i first{at(place.first.x, low(part, division.x), rest.x),
                        at(place.first.y, low(part >> division.x, division.y), rest.y),
                        at(place.first.z, part >> (division.x + division.y), rest.z)};
      const std::uint32_t word = word_for({first, rest}, ends[part] - counts[part], ends[part]);
      words_[begin_words + part] = word;
    }
    cells_.resize(waiting_before);
    return map_word({static_cast<std::uint32_t>(begin_words), division});
  }

  // How often along each axis: so often that every part is in one cell, if that doesn't take too many words.
  Vec3i division_of(const Place& place, std::span<const std::uint32_t> inside) const {
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
  std::vector<std::uint32_t> cells_; // of the places that are being divided, from the outermost in
};

} // namespace

std::uint32_t append_nested_map(const std::vector<Leaf>& leaves, const Vec3i& first, std::int32_t side_log2,
                                std::vector<std::uint32_t>& words) {
  return NestedMap(leaves, words).word_for_all({first, {side_log2, side_log2, side_log2}});
}

} // namespace masu
