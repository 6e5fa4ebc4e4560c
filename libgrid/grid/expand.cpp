// The expansion on the host's cores: the cells that expand_along (expand_passes.h) makes, in about two fifths
// of its time.
#include "libgrid/grid/expand_passes.h"
#include "libscene/passes/host_executor.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

namespace masu {
namespace {

template <unsigned axis>
std::uint32_t& range_of(MergedCell& cell) {
  return axis == 0 ? cell.x : axis == 1 ? cell.y : cell.z;
}

// A grid whose cells are being expanded: `cells` are as this round leaves them.
struct Expansion {
  MergedGridView<double> view;
  std::uint64_t count;
  MergedCell* cells;
  std::vector<Neighbour> before;
  std::vector<std::uint8_t> blocked; // a cell's bit for each of its sides
};

// Expands cells towards one side.
//
// A face is moved by looking at its neighbours one after another, each found through the map: a chain of
// loads, and branches that can't be predicted. So many faces advance side by side, each in a lane of its own,
// a neighbour per step, and all decisions but the last are arithmetic.
template <unsigned axis, unsigned side>
class FaceLanes {
public:
  // For the cells from `begin` to before `end`.
  FaceLanes(Expansion& expansion, std::size_t begin, std::size_t end)
      : s_(expansion), next_cell_(begin), end_(end) {
    // Lanes without a face go round in voxel 0.
    u_end_.fill(1);
    v_end_.fill(1);
  }

  void expand() {
    while (live_ < lanes && take_face(live_))
      ++live_;
    while (live_ > 0) {
      find_neighbours();
      test_neighbours();
    }
  }

private:
  static constexpr unsigned lanes = 32;
  static constexpr unsigned u = (axis + 1) % 3, v = (axis + 2) % 3;
  static constexpr std::uint8_t side_bit = 1U << (2 * axis + side);
  using Lane = std::array<std::int32_t, lanes>;

  // The next cell's whose face isn't blocked; false when there is none.
  bool take_face(unsigned lane) {
    const std::int32_t limit = s_.view.division[static_cast<int>(axis)];
    for (; next_cell_ != end_; ++next_cell_) {
      if ((s_.blocked[next_cell_] & side_bit) != 0) continue;
      MergedCell& cell = s_.cells[next_cell_];
      const std::uint32_t along = range_of<axis>(cell);
      if (side == 0 ? first_of(along) == 0 : end_of(along) == limit) {
        block(next_cell_);
        continue;
      }
      cell_[lane] = next_cell_;
      signature_[lane] = s_.before[next_cell_].signature;
      plane_[lane] = side == 0 ? first_of(along) - 1 : end_of(along);
      i_[lane] = u_first_[lane] = first_of(range_of<u>(cell));
      u_end_[lane] = end_of(range_of<u>(cell));
      j_[lane] = first_of(range_of<v>(cell));
      next_j_[lane] = v_end_[lane] = end_of(range_of<v>(cell));
      reach_[lane] = side == 0 ? 0 : 0xffff;
      seen_[lane] = 0;
      ++next_cell_;
      return true;
    }
    return false;
  }

  // What is in the way stays in the way: the face only grows.
  void block(std::size_t cell) { s_.blocked[cell] = static_cast<std::uint8_t>(s_.blocked[cell] | side_bit); }

  // cell_number (grid.h) for every lane.
  void find_neighbours() {
    const std::uint32_t* const map = s_.view.voxel_map;
    const Lane &x = axis == 0 ? plane_
                    : u == 0  ? i_
                              : j_,
               &y = axis == 1 ? plane_
                    : u == 1  ? i_
                              : j_,
               &z = axis == 2 ? plane_
                    : u == 2  ? i_
                              : j_;
    const std::int32_t log2 = s_.view.nested_log2;
    const Vec3i top = s_.view.top;
    std::uint32_t word[lanes];
    std::int32_t x_log2[lanes], y_log2[lanes], z_log2[lanes];
    for (unsigned l = 0; l < lanes; ++l) {
      const std::int32_t place = ((z[l] >> log2) * top.y + (y[l] >> log2)) * top.x + (x[l] >> log2);
      word[l] = map[static_cast<std::uint32_t>(place)];
      x_log2[l] = y_log2[l] = z_log2[l] = log2;
    }
    for (;;) {
      std::uint32_t all = occupied_bit;
      for (const std::uint32_t w : word)
        all &= w;
      if (all != 0) break;
      for (unsigned l = 0; l < lanes; ++l) {
        // Lanes that have arrived divide their box by nothing, and keep their word.
        const auto arrived = static_cast<std::uint32_t>(static_cast<std::int32_t>(word[l]) >> 31);
        const MapDivision division = map_division(word[l] & ~arrived);
        x_log2[l] -= division.log2.x;
        y_log2[l] -= division.log2.y;
        z_log2[l] -= division.log2.z;
        const Vec3i at{x[l] >> x_log2[l], y[l] >> y_log2[l], z[l] >> z_log2[l]};
        const std::uint32_t next = map[division.offset + index_in_division(at, division.log2)];
        word[l] = (word[l] & arrived) | (next & ~arrived);
      }
    }
    for (unsigned l = 0; l < lanes; ++l)
      neighbour_[l] = word[l] & ~occupied_bit;
  }

  // Goes on along u to where the neighbour ends, or along v to where the first of this row's neighbours ends.
  // A lane comes to an end at the face's end, at what is in the way, or after very many neighbours.
  void test_neighbours() {
    std::uint32_t signature[lanes], ended[lanes], ending[lanes];
    std::int32_t bound[lanes], u_own[lanes], v_own[lanes];
    for (unsigned l = 0; l < lanes; ++l) {
      const Neighbour& neighbour = s_.before[neighbour_[l]];
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
      ended[l] =
          (in_the_way ? blocked : 0U) | (face_ends ? moved : 0U) | (signature[l] != 0 ? uncertain : 0U);
    }
    unsigned count = 0;
    for (unsigned l = 0; l < live_; ++l) {
      ending[count] = l;
      count += ended[l] != 0 ? 1 : 0;
    }
    // From the last lane on, so that what moves into another's place has been tested.
    while (count > 0) {
      const unsigned l = ending[--count];
      if (!ends(l, ended[l])) continue;
      if (!take_face(l)) move_lane(--live_, l);
    }
  }

  // Why a lane is looked at. uncertain: the signatures don't say whether the neighbour lists something else.
  static constexpr std::uint32_t blocked = 1, moved = 2, uncertain = 4;

  bool ends(unsigned l, std::uint32_t why) {
    MergedCell& cell = s_.cells[cell_[l]];
    if ((why & blocked) != 0 || ((why & uncertain) != 0 &&
                                 !lists_all(s_.view.references, cell.list, s_.before[neighbour_[l]].list))) {
      block(cell_[l]);
      return true;
    }
    if ((why & moved) == 0) return false;
    std::uint32_t& along = range_of<axis>(cell);
    const auto reach = static_cast<std::uint32_t>(reach_[l]);
    along = side == 0 ? (along & 0xffff0000U) | reach : (along & 0xffffU) | reach << 16;
    return true;
  }

  void move_lane(unsigned from, unsigned to) {
    cell_[to] = cell_[from];
    signature_[to] = signature_[from];
    for (Lane* lane : {&plane_, &i_, &j_, &next_j_, &u_first_, &u_end_, &v_end_, &reach_, &seen_})
      (*lane)[to] = (*lane)[from];
  }

  Expansion& s_;
  std::size_t next_cell_, end_;
  unsigned live_ = 0; // lanes that have a face: the first ones
  std::array<std::size_t, lanes> cell_{};
  std::array<std::uint32_t, lanes> signature_{}, neighbour_{};
  // The voxel looked at: plane_ along the axis, i_ along u, j_ along v. It runs over the face, which is from
  // u_first_ to u_end_ and up to v_end_; the next row is at next_j_.
  Lane plane_{}, i_{}, j_{}, next_j_{}, u_first_{}, u_end_{}, v_end_{};
  Lane reach_{}, seen_{};
};

template <class Act>
void for_all_cells(const TbbExecutor& executor, std::uint64_t count, const Act& act) {
  constexpr std::size_t cells_per_task = 4096, cells_per_check = 8 * cells_per_task;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, cells_per_task), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); i += cells_per_check) {
      check_progress(executor.progress);
      act(i, std::min(i + cells_per_check, range.end()));
    }
  });
}

void expand_all(const TbbExecutor& executor, Expansion& expansion) {
  for_all_cells(executor, expansion.count, [&](std::size_t begin, std::size_t end) {
    FaceLanes<0, 0>(expansion, begin, end).expand();
    FaceLanes<0, 1>(expansion, begin, end).expand();
    FaceLanes<1, 0>(expansion, begin, end).expand();
    FaceLanes<1, 1>(expansion, begin, end).expand();
    FaceLanes<2, 0>(expansion, begin, end).expand();
    FaceLanes<2, 1>(expansion, begin, end).expand();
  });
}

} // namespace

void expand_cells(TbbExecutor& executor, const MergedGridView<double>& grid, std::uint64_t count,
                  MergedCell* cells, int rounds) {
  if (rounds == 0) return;
  Expansion expansion{grid, count, cells, std::vector<Neighbour>(count), std::vector<std::uint8_t>(count, 0)};
  for_all_cells(executor, count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i != end; ++i)
      expansion.before[i] = as_neighbour(cells[i], grid.references);
  });
  for (int round = 0; round < rounds; ++round) {
    expand_all(executor, expansion);
    if (round + 1 == rounds) break;
    for_all_cells(executor, count, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i != end; ++i)
        set_expanded(expansion.before[i], cells[i]);
    });
  }
}

} // namespace masu
