#include "libgrid/build/nested_map.h"

#include <numeric>
#include <span>

namespace masu {
namespace {

class NestedMap {
public:
  NestedMap(const std::vector<Leaf>& leaves, std::vector<std::uint32_t>& words)
      : leaves_(leaves), words_(words), cells_(leaves.size()) {
    std::iota(cells_.begin(), cells_.end(), 0U);
  }

  // The word for a place that holds all cells.
  std::uint32_t word_for_all(const MapPlace& place) {
    return cells_.size() == 1 ? occupied_bit : word_for(place, 0, cells_.size());
  }

private:
  // The word for the place, which several cells divide between them: cells_[begin] to before cells_[end].
  std::uint32_t word_for(const MapPlace& place, std::size_t begin, std::size_t end) {
    const Vec3i division = division_of(place, {cells_.data() + begin, cells_.data() + end});
    const std::size_t begin_words = words_.size();
    const std::uint32_t parts = parts_of(division);
    words_.resize(begin_words + rounded_to_unit(parts));

    const auto for_each_part = [&](std::uint32_t cell, const auto& act) {
      for_each_voxel(map_parts(place, division, leaves_[cell].box),
                     [&](const Vec3i& part) { act(index_in_division(part, division)); });
    };
    // Most parts are in one cell, and their words are done; the cells of the others go behind all those that
    // are waiting, part by part.
    std::uint32_t counts[most_parts];
    std::fill_n(counts, parts, 0U);
    for (std::size_t i = begin; i != end; ++i) {
      const std::uint32_t cell = cells_[i];
      for_each_part(cell, [&](std::uint32_t part) {
        ++counts[part];
        words_[begin_words + part] = occupied_bit | cell;
      });
    }
    std::size_t ends[most_parts];
    const std::size_t waiting_before = cells_.size();
    std::size_t waiting = waiting_before;
    for (std::uint32_t part = 0; part < parts; ++part) {
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
    for (std::uint32_t part = 0; part < parts; ++part) {
      if (counts[part] < 2) continue;
      const std::uint32_t word =
          word_for(map_part(place, division, part), ends[part] - counts[part], ends[part]);
      words_[begin_words + part] = word;
    }
    cells_.resize(waiting_before);
    return map_word({static_cast<std::uint32_t>(begin_words), division});
  }

  Vec3i division_of(const MapPlace& place, std::span<const std::uint32_t> inside) const {
    std::uint32_t planes[3] = {};
    for (const std::uint32_t cell : inside) {
      for (int axis = 0; axis < 3; ++axis)
        planes[axis] |= plane_bits(place, leaves_[cell].box, axis);
    }
    return map_division_for(place, planes, static_cast<std::uint32_t>(inside.size()));
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
