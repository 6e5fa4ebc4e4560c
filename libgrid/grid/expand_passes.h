// Expanding cells over their neighbours, after Pérard-Gayot, Kalojanov & Slusallek, "GPU Ray Tracing using
// Irregular Grids", CGF 36(2), 2017: a ray that leaves an expanded cell has passed neighbours that list
// nothing new to it.
//
// Each round expands cells over neighbours that are empty or list nothing but what the cell lists itself, by
// one layer along each direction; neighbours count as they are after the round before.
#pragma once

#include "libgrid/grid/grid.h"
#include "libscene/passes/executor.h"

#include <algorithm>

namespace masu {

// Whether all primitives of the list `part` are in the list `whole`.
MASU_HD inline bool lists_all(const PrimitiveIndex* references, std::uint32_t whole, std::uint32_t part) {
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

// A bit for each primitive of a list, several to a bit: 0 for an empty list alone, and a part's bits are
// among the whole's.
MASU_HD inline std::uint32_t signature_of(const PrimitiveIndex* references, std::uint32_t list) {
  if (list == empty_list) return 0;
  std::uint32_t signature = 0;
  for (bool last = false; !last; ++list) {
    last = (references[list] & last_bit) != 0;
    // Neighbours in space are often numbered in steps: the golden ratio spreads them over the bits.
    signature |= 1U << ((references[list] & ~last_bit) * 0x9e3779b1U >> 27);
  }
  return signature;
}

// The most neighbours a face looks at: one more of them would sooner or later be in the way.
inline constexpr std::int32_t max_neighbours = 32;

// What the expansion reads of a cell's neighbours: half a cache line.
struct alignas(32) Neighbour {
  std::uint32_t own[3];      // the voxels that lead to it
  std::uint32_t expanded[3]; // its box after the round before
  std::uint32_t signature;
  std::uint32_t list;
};
static_assert(sizeof(Neighbour) == 32);

// A grid whose cells are being expanded: `cells` as this round leaves them, `neighbours` after the round
// before. What is in a face's way stays there, since faces only grow: a bit of `blocked` for each of six.
struct Expansion {
  MergedGridView<double> grid;
  MergedCell* cells;
  Neighbour* neighbours;
  std::uint8_t* blocked;
};

template <unsigned axis, class Cell>
MASU_HD auto& range_of(Cell& cell) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}

// Expands cells towards one side.
//
// A face is moved by looking at its neighbours, row by row along u, then v; the next row begins where the
// first of this row's neighbours ends. Each is found through the map: a chain of loads, and branches that
// can't be predicted. So many faces advance side by side, each in a lane of its own, a neighbour per step,
// and all decisions but the last are arithmetic. A device's thread has one lane: many threads wait at once.
template <unsigned axis, unsigned side, unsigned lanes>
class FaceLanes {
public:
  // For the cells from `begin` to before `end`.
  MASU_HD FaceLanes(const Expansion& expansion, std::uint64_t begin, std::uint64_t end)
      : s_(expansion), next_cell_(begin), end_(end) {}

  MASU_HD void expand() {
    for (unsigned l = 0; l < lanes; ++l)
      take_face(l);
    while (any_lives()) {
      find_neighbours();
      pass_neighbours();
      end_faces();
    }
  }

private:
  static constexpr unsigned u = (axis + 1) % 3, v = (axis + 2) % 3;
  static constexpr std::uint8_t side_bit = 1U << (2 * axis + side);
  using Lane = std::int32_t[lanes];
  using BitLane = std::uint32_t[lanes];

  // The next cell's that isn't blocked. Without one a lane goes round in its last face, or in voxel 0.
  MASU_HD void take_face(unsigned l) {
    for (live_[l] = 0; live_[l] == 0 && next_cell_ != end_; ++next_cell_) {
      if ((s_.blocked[next_cell_] & side_bit) != 0) continue;
      const MergedCell& cell = s_.cells[next_cell_];
      const std::uint32_t along = range_of<axis>(cell);
      if (side == 0 ? first_of(along) == 0 : end_of(along) == s_.grid.division[axis]) {
        block(next_cell_);
        continue;
      }
      cell_[l] = next_cell_;
      signature_[l] = s_.neighbours[next_cell_].signature;
      plane_[l] = side == 0 ? first_of(along) - 1 : end_of(along);
      i_[l] = u_first_[l] = first_of(range_of<u>(cell));
      u_end_[l] = end_of(range_of<u>(cell));
      j_[l] = first_of(range_of<v>(cell));
      next_j_[l] = v_end_[l] = end_of(range_of<v>(cell));
      reach_[l] = side == 0 ? 0 : 0xffff;
      seen_[l] = 0;
      live_[l] = ~0U;
    }
  }

  MASU_HD bool any_lives() const {
    std::uint32_t any = 0;
    for (const std::uint32_t live : live_)
      any |= live;
    return any != 0;
  }

  MASU_HD void block(std::uint64_t cell) {
    s_.blocked[cell] = static_cast<std::uint8_t>(s_.blocked[cell] | side_bit);
  }

  // cell_number (grid.h) for every lane.
  MASU_HD void find_neighbours() {
    const Lane& x = axis == 0 ? plane_ : u == 0 ? i_ : j_;
    const Lane& y = axis == 1 ? plane_ : u == 1 ? i_ : j_;
    const Lane& z = axis == 2 ? plane_ : u == 2 ? i_ : j_;
    BitLane word, x_bits, y_bits, z_bits;
    for (unsigned l = 0; l < lanes; ++l) {
      const MapPlace top = top_place(s_.grid, {x[l], y[l], z[l]});
      word[l] = top.word;
      x_bits[l] = top.x;
      y_bits[l] = top.y;
      z_bits[l] = top.z;
    }
    while (!all_arrived(word)) {
      for (unsigned l = 0; l < lanes; ++l) {
        // Lanes that have arrived divide their box by nothing, and keep their word.
        const auto arrived = static_cast<std::uint32_t>(static_cast<std::int32_t>(word[l]) >> 31);
        MapPlace place{word[l] & ~arrived, x_bits[l], y_bits[l], z_bits[l]};
        step_down(s_.grid.voxel_map, place);
        word[l] = (word[l] & arrived) | (place.word & ~arrived);
        x_bits[l] = place.x;
        y_bits[l] = place.y;
        z_bits[l] = place.z;
      }
    }
    for (unsigned l = 0; l < lanes; ++l)
      neighbour_[l] = word[l] & ~occupied_bit;
  }

  MASU_HD static bool all_arrived(const BitLane& words) {
    std::uint32_t all = occupied_bit;
    for (const std::uint32_t word : words)
      all &= word;
    return all != 0;
  }

  // Why a lane is looked at. uncertain: the signatures don't say whether the neighbour lists something else.
  static constexpr std::uint32_t blocked = 1, moved = 2, uncertain = 4;

  // Goes on along u to where the neighbour ends, or along v to where the first of this row's neighbours ends.
  // A lane comes to an end at the face's end, at what is in the way, or after very many neighbours.
  MASU_HD void pass_neighbours() {
    BitLane signature;
    Lane bound, u_own, v_own;
    for (unsigned l = 0; l < lanes; ++l) {
      const Neighbour neighbour = fetched(s_.neighbours + neighbour_[l]);
      signature[l] = neighbour.signature;
      bound[l] = side == 0 ? first_of(neighbour.expanded[axis]) : end_of(neighbour.expanded[axis]);
      u_own[l] = end_of(neighbour.own[u]);
      v_own[l] = end_of(neighbour.own[v]);
    }
    for (unsigned l = 0; l < lanes; ++l) {
      const bool in_the_way = (signature[l] & ~signature_[l]) != 0 || seen_[l] == max_neighbours;
      ++seen_[l];
      reach_[l] = side == 0 ? std::max(reach_[l], bound[l]) : std::min(reach_[l], bound[l]);
      const std::int32_t next_j = std::min(next_j_[l], v_own[l]);
      const bool row_ends = u_own[l] >= u_end_[l], face_ends = row_ends && next_j >= v_end_[l];
      i_[l] = row_ends ? u_first_[l] : u_own[l];
      j_[l] = row_ends && !face_ends ? next_j : j_[l];
      next_j_[l] = row_ends ? v_end_[l] : next_j;
      ended_[l] = live_[l] & ((in_the_way ? blocked : 0U) | (face_ends ? moved : 0U) |
                              (signature[l] != 0 ? uncertain : 0U));
    }
  }

  MASU_HD void end_faces() {
    BitLane ended;
    unsigned count = 0;
    for (unsigned l = 0; l < lanes; ++l) {
      ended[count] = l;
      count += ended_[l] != 0 ? 1 : 0;
    }
    for (unsigned i = 0; i < count; ++i)
      if (ends(ended[i])) take_face(ended[i]);
  }

  MASU_HD bool ends(unsigned l) {
    MergedCell& cell = s_.cells[cell_[l]];
    if ((ended_[l] & blocked) != 0 ||
        ((ended_[l] & uncertain) != 0 &&
         !lists_all(s_.grid.references, cell.list, s_.neighbours[neighbour_[l]].list))) {
      block(cell_[l]);
      return true;
    }
    if ((ended_[l] & moved) == 0) return false;
    std::uint32_t& along = range_of<axis>(cell);
    const auto reach = static_cast<std::uint32_t>(reach_[l]);
    along = side == 0 ? (along & 0xffff0000U) | reach : (along & 0xffffU) | reach << 16;
    return true;
  }

  const Expansion& s_;
  std::uint64_t next_cell_, end_;
  BitLane live_{}; // all bits where the lane has a face
  BitLane ended_{};
  std::uint64_t cell_[lanes]{};
  BitLane signature_{}, neighbour_{};
  // The voxel looked at: plane_ along the axis, i_ along u, j_ along v. It runs over the face, which is from
  // u_first_ to u_end_ and up to v_end_; the next row is at next_j_.
  Lane plane_{}, i_{}, j_{}, next_j_{}, u_first_{}, u_end_{}, v_end_{};
  Lane reach_{}, seen_{};
};

// `grid` is a view of what `cells` are the cells of, in the executor's memory.
template <class Executor>
void expand_cells(Executor& executor, const MergedGridView<double>& grid, std::uint64_t count,
                  MergedCell* cells, int rounds) {
  if (rounds == 0) return;
  auto neighbours = executor.template array<Neighbour>(count);
  auto blocked = executor.template zeros<std::uint8_t>(count);
  const Expansion s{grid, cells, neighbours.data(), blocked.data()};
  executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
    const MergedCell& cell = cells[i];
    const std::uint32_t signature = signature_of(grid.references, cell.list);
    s.neighbours[i] = {{cell.x, cell.y, cell.z}, {cell.x, cell.y, cell.z}, signature, cell.list};
  });
  // So many cells are under way at once on the host, so as to wait for the loads of all together.
  constexpr unsigned lanes = Executor::has_warps ? 1 : 32;
  for (int round = 0; round < rounds; ++round) {
    executor.for_each_part(count, [=] MASU_PASS(std::uint64_t begin, std::uint64_t end) {
      FaceLanes<0, 0, lanes>(s, begin, end).expand();
      FaceLanes<0, 1, lanes>(s, begin, end).expand();
      FaceLanes<1, 0, lanes>(s, begin, end).expand();
      FaceLanes<1, 1, lanes>(s, begin, end).expand();
      FaceLanes<2, 0, lanes>(s, begin, end).expand();
      FaceLanes<2, 1, lanes>(s, begin, end).expand();
    });
    if (round + 1 == rounds) break;
    executor.for_each(count, [=] MASU_PASS(std::uint64_t i) {
      std::uint32_t(&expanded)[3] = s.neighbours[i].expanded;
      expanded[0] = cells[i].x;
      expanded[1] = cells[i].y;
      expanded[2] = cells[i].z;
    });
  }
}

} // namespace masu
