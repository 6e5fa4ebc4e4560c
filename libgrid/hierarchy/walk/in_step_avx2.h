// Eight rays' walks through a bounding volume hierarchy, or through placed meshes, in step, on one thread of
// a processor with AVX2: for lists of rays that have little in common. A lane whose ray is done takes the
// next.
//
// One ray's walk mostly waits: for memory, and after branches that were mispredicted. So here hardly any
// branch depends on a ray, and what is needed next is prefetched. The nodes that the rays meet are sorted for
// all eight at once, by a network (Batcher's, of eight); the triangles that they meet are tested eight at a
// time, whichever ray's they are.
//
// Host only.
#pragma once

#include "libgrid/hierarchy/walk/sorted_rows_avx2.h"
#include "libgrid/placed/placed_lanes_avx2.h"
#include "libgrid/trace/trace.h"
#include "libscene/geometry/triangle_lanes.h"

#include <cstring>

namespace masu {

// M: a Method by watertight tests. Structure: a hierarchy, or a PlacedRay<Stored> of triangles that are
// tested in lanes, of which each ray has its own mask and world. Walks are cut into four stages, which are
// called in turn: in between comes other groups' work, so that what one stage loads or computes is there for
// the next.
//
//   meet_boxes  tests the boxes of each ray's node, and prefetches the primitives that may be met
//   push        puts the nodes that are met ahead, and takes the nearest as the next
//   test        tests primitives
//   resume      keeps the hits; where the next node is beyond them, takes another; or the walk ends
template <Query query, class M, class Stored, class Structure = HierarchyView<typename M::Real>>
class EightWalks {
public:
  using Real = typename M::Real;
  static constexpr int lanes = 8;

  // No lane has a ray.
  explicit EightWalks( // NOLINT(cppcoreguidelines-pro-type-member-init): idle lanes count for nothing
      const Structure& structure)
      : structure_(structure) {
    for (int lane = 0; lane < lanes; ++lane) {
      std::fill_n(ahead_[lane].entries, below, nowhere);
      ahead_[lane].siblings[below - 1] = 0;
      node_[lane] = first_nodes();
      leave_idle(lane);
    }
  }

  EightWalks(const EightWalks&) = delete; // lanes point to rays within
  EightWalks& operator=(const EightWalks&) = delete;
  ~EightWalks() = default;

  // Gives a ray to a lane: a prepared one, with its direction's inverse, bounded (bounded_inverse()).
  // `seen`: the structure as it sees it.
  MASU_ALWAYS_INLINE void begin(int lane, const Structure& seen, const WatertightRay<Real>& ray,
                                const Vec3<Real>& inverse, Real t_min, Real t_max) {
    const auto i = static_cast<std::size_t>(lane);
    origin_.set(i, ray.origin);
    direction_.set(i, ray.direction);
    across1_.set(i, ray.across1);
    across2_.set(i, ray.across2);
    inverse_square_.of[i] = ray.inverse_square;
    t_min_[lane] = t_min;
    t_max_[lane] = t_[lane] = t_max;
    farthest_.of[i] = in_float32(t_max);
    primitive_[lane] = 0; // wins no tie at t_max
    const BoxRay<Stored> box_ray(ray.origin, inverse);
    if constexpr (is_placed) {
      box_rays_[lane][0] = {box_ray, box_ray.origin};
      const auto [first, second] = seen.roots();
      if (first == no_root) return leave_idle(lane);
      leave_mesh(lane);
      mask_[lane] = seen.mask;
      ahead_[lane].entries[below] = 0;
      ahead_[lane].siblings[below] = std::uint64_t{second} << 32;
      go_to(lane, first_nodes() + first, 0, second != no_root ? below + 1 : below);
    } else {
      box_rays_[lane][0] = box_ray;
      go_to(lane, first_nodes(), 0, below);
    }
  }
  MASU_ALWAYS_INLINE void leave_idle(int lane) {
    box_rays_[lane][0] = {};
    leave_mesh(lane);
    farthest_.of[lane] = -1; // meets no box
    end(lane);
  }

  // The nearest hit; of occlusion one that is nearer than t_max.
  MASU_ALWAYS_INLINE Hit<Real> hit(int lane) const {
    const Real t = t_[lane];
    return t < t_max_[lane] ? Hit<Real>{t, primitive_[lane]} : no_hit<Real>();
  }

  MASU_ALWAYS_INLINE void meet_boxes(const SceneView<Stored>& scene) {
    const __m256i numbers = _mm256_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7), is_node = _mm256_set1_epi32(0x18);
    unsigned with_references = 0; // a bit per lane
    for (int lane = 0; lane < lanes; ++lane) {
      const HierarchyNode& node = *node_[lane];
      const auto& ray = own_ray(lane);
      const BoxesMet<float> met =
          boxes_met(node, planes_of(node, ray), ray, leaving_from(ray), ray.inverse, farthest_.of[lane]);
      const __m256i slots = eight_bytes(node.slots);
      const __m256i nodes = _mm256_cmpeq_epi32(slots & is_node, is_node) & met.lanes.whole();
      const __m256i entry = (met.enter.whole() & ~_mm256_set1_epi32(slot_mask)) | numbers;
      entries_met_[lane] = _mm256_blendv_epi8(_mm256_set1_epi32(-1), entry, nodes);
      met_[lane] = slots_met(slots, met.lanes);
      with_references |= ((met_[lane] & all_references) != 0 ? 1U : 0U) << lane;
    }
    std::uint32_t end = 0;
    each_bit(with_references, [&](int lane) {
      std::uint32_t bits = met_[lane] & all_references;
      const auto count = static_cast<std::uint32_t>(std::popcount(bits));
      const std::uint32_t first_reference = node_[lane]->first_reference;
      const auto add = [&](std::uint32_t at) {
        test_lane_[at] = lane;
        test_[at] = first_reference + static_cast<std::uint32_t>(std::countr_zero(bits));
        bits &= bits - 1;
      };
      for (std::uint32_t i = 0; i < 4; ++i) // without branches: there are seldom more
        add(end + i);
      for (std::uint32_t i = 4; i < count; ++i)
        add(end + i);
      end += count;
    });
    test_count_ = end;
    for (std::uint32_t i = 0; i < end; ++i) {
      if constexpr (is_placed)
        prefetch(structure_.placed.of_meshes.leaves + test_[i]);
      else
        test_[i] = structure_.references[test_[i]];
      if constexpr (!is_placed && tests_triangles_in_lanes<M, Stored>) prefetch(scene.triangles + test_[i]);
    }
  }

  MASU_ALWAYS_INLINE void push() {
    sort_descending(entries_met_);
    for (int lane = 0; lane < lanes; ++lane) {
      NodesAhead& ahead = ahead_[lane];
      const std::ptrdiff_t height = height_[lane], higher = height + std::popcount(met_[lane] >> 24);
      store_eight(ahead.entries + height, entries_met_[lane]);
      static_assert(offsetof(HierarchyNode, first_node) == offsetof(HierarchyNode, exponents) + 4);
      long long siblings;
      std::memcpy(&siblings, &node_[lane]->exponents, sizeof siblings);
      store_eight(ahead.siblings + height, _mm256_set1_epi64x(siblings));
      store_eight(ahead.siblings + height + 4, _mm256_set1_epi64x(siblings));
      // There is room, but while a mapped file changes: then results are thrown away.
      take(lane, higher > below + max_ahead ? below : higher);
      prefetch(node_[lane]);
    }
  }

  MASU_ALWAYS_INLINE void test(const SceneView<Stored>& scene) {
    std::fill_n(hits_, std::size(hits_), 0);
    const auto add_hits = [&](std::uint32_t first, std::uint64_t bits) {
      hits_[first / 64] |= bits << first % 64;
    };
    if constexpr (tests_triangles_in_lanes<M, Stored>) {
      if (test_count_ == 0) return;
      // Beyond the last: the last again.
      store_eight(test_ + test_count_, _mm256_set1_epi32(static_cast<int>(test_[test_count_ - 1])));
      store_eight(test_lane_ + test_count_, _mm256_setzero_si256());
      constexpr std::uint32_t at_once = Lanes<Real>::count;
      for (std::uint32_t first = 0; first < test_count_; first += at_once) {
        const int* const of = test_lane_ + first;
        const WatertightRay<Lanes<Real>> rays{
            {origin_.of_rays(of), direction_.of_rays(of), inverse_square_.of_rays(of)},
            across1_.of_rays(of),
            across2_.of_rays(of)};
        [[maybe_unused]] Lanes<Stored> rows[3][4];
        if constexpr (is_placed)
          for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
              rows[row][column] = rows_[row][column].of_rays(of);
        Lanes<Real> t = 0;
        const LaneMask<Real> hits = intersect<Stored>(
            rays,
            [&](auto corner)
                __attribute__((always_inline)) { return corners_of(scene, test_ + first, rows, corner); },
            t);
        t.store(test_t_ + first);
        add_hits(first, _bzhi_u32(hits.bits(), test_count_ - first));
      }
    } else {
      NoTestCounts counts;
      for (std::uint32_t i = 0; i < test_count_; ++i) {
        const auto lane = static_cast<std::size_t>(test_lane_[i]);
        const WatertightRay<Real> ray{{origin_.of(lane), direction_.of(lane), inverse_square_.of[lane]},
                                      across1_.of(lane),
                                      across2_.of(lane)};
        if (test_primitive<M::kinds>(scene, ray, test_[i], t_min_[lane], test_t_[i], counts)) add_hits(i, 1);
      }
    }
  }

  // At the end of a walk, and each time for an idle lane, calls next_ray(lane): which may use hit(), and
  // calls begin() or leave_idle().
  template <class NextRay>
  MASU_ALWAYS_INLINE void resume(const NextRay& next_ray) {
    for (std::uint32_t first = 0; first < test_count_; first += 64) {
      for (std::uint64_t bits = hits_[first / 64]; bits != 0; bits &= bits - 1) {
        const std::uint32_t i = first + static_cast<std::uint32_t>(std::countr_zero(bits));
        keep(test_lane_[i], test_t_[i], primitive(i));
      }
    }
    const __m256i farthest = farthest_.all().whole() | _mm256_set1_epi32(slot_mask),
                  beyond = _mm256_cmpgt_epi32(load_eight(entry_), farthest);
    each_bit(static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(beyond))), [&](int lane) {
      // Eight are looked at: to take one that is beyond does no harm.
      const __m256i top = load_eight(ahead_[lane].entries + height_[lane] - 8),
                    limit = _mm256_set1_epi32(static_cast<int>(bits_of(farthest_.of[lane])) | slot_mask);
      const auto bits =
          static_cast<std::uint8_t>(_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpgt_epi32(top, limit))));
      const std::ptrdiff_t height = height_[lane] - std::countl_one(bits);
      if (height > below) {
        take(lane, height);
      } else {
        next_ray(lane);
      }
    });
    if constexpr (is_placed) {
      const __m256i elsewhere = _mm256_cmpeq_epi32(load_eight(entry_), _mm256_set1_epi32(nowhere)),
                    above = _mm256_cmpeq_epi32(load_eight(mesh_begin_) | elsewhere, _mm256_setzero_si256());
      each_bit(static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(above))), [&](int lane) {
        if (node_slots(*node_[lane]) == 0) enter_mesh(lane);
      });
    }
  }

private:
  static constexpr bool is_placed = !std::is_same_v<Structure, HierarchyView<Real>>;
  static constexpr int max_ahead = is_placed ? max_placed_ahead : max_nodes_ahead;

  // Nodes that a lane has still to visit, those of a node with the nearest last. `entries`: the bits of where
  // the ray enters them, which as whole numbers are in the same order, with the slot in place of the last
  // three: so an entry is compared with a distance whose last three bits are set. `siblings`: `exponents` of
  // the node that they are in and, in the high half, `first_node`. Before the first are some that no ray
  // reaches, and eight are always written, of which those that weren't met don't count.
  static constexpr int below = 9;
  struct NodesAhead {
    std::int32_t entries[below + max_ahead + boxes_per_node];
    std::uint64_t siblings[below + max_ahead + boxes_per_node];
  };
  static constexpr std::int32_t nowhere = 0x7fffffff;
  static constexpr int slot_mask = 7;
  static constexpr std::uint32_t all_references = 0xffffff;
  static constexpr unsigned most_tests = lanes * max_references_per_node;

  // One that leaves boxes from another origin than it enters them.
  struct MovedRay : BoxRay<Stored> {
    Lanes<Stored> leaving = Stored(0);
  };
  MASU_ALWAYS_INLINE static Lanes<Stored> leaving_from(const BoxRay<Stored>& ray) { return ray.origin; }
  MASU_ALWAYS_INLINE static Lanes<Stored> leaving_from(const MovedRay& ray) { return ray.leaving; }

  // Where a ray begins.
  MASU_ALWAYS_INLINE const HierarchyNode* first_nodes() const {
    if constexpr (is_placed)
      return structure_.placed.upper_nodes;
    else
      return structure_.nodes;
  }
  MASU_ALWAYS_INLINE void set_level(int lane, const MovedRay& ray, const HierarchyNode* nodes,
                                    std::ptrdiff_t begin) {
    moved_ray_[lane] = &ray;
    nodes_[lane] = nodes;
    mesh_begin_[lane] = static_cast<std::int32_t>(begin);
  }
  MASU_ALWAYS_INLINE void leave_mesh([[maybe_unused]] int lane) {
    if constexpr (is_placed) set_level(lane, box_rays_[lane][0], first_nodes(), 0);
  }
  MASU_ALWAYS_INLINE const auto& own_ray(int lane) const {
    if constexpr (is_placed)
      return *moved_ray_[lane];
    else
      return box_rays_[lane][0];
  }
  MASU_ALWAYS_INLINE void go_to(int lane, const HierarchyNode* node, std::int32_t entry,
                                std::ptrdiff_t height) {
    node_[lane] = node;
    entry_[lane] = entry;
    height_[lane] = height;
  }
  MASU_ALWAYS_INLINE void end(int lane) { go_to(lane, node_[lane], nowhere, below); }
  // From an item to the root of its mesh, whose nodes are put ahead above all others; an item that the ray
  // doesn't see is a node without boxes.
  MASU_ALWAYS_INLINE void enter_mesh(int lane) {
    const PlacedView<Stored>& placed = structure_.placed;
    const std::uint32_t item = node_[lane]->first_reference;
    const auto own = placed.entrance(*node_[lane]);
    if (!PlacedRay<Stored>{placed, 0, mask_[lane], structure_.object_masks}.sees(item, own)) return;
    const auto i = static_cast<std::size_t>(lane);
    const BoundRay<Lanes<Real>> ray = carried_ray(own, origin_.of(i), direction_.of(i));
    box_rays_[lane][1] = {BoxRay<Stored>(rounded<Stored>(ray.entering), rounded<Stored>(ray.inverse)),
                          rounded<Stored>(ray.leaving)};
    const Placement<Stored>& placement = placed.placements[item];
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        rows_[row][column].of[lane] = placement.rows[row][column];
    first_triangle_[lane] = placement.first_triangle;
    set_level(lane, box_rays_[lane][1], placed.of_meshes.nodes, height_[lane]);
    node_[lane] = nodes_[lane] + own.root;
    prefetch(node_[lane]);
  }
  // One corner each of triangles, placed by the rows of transforms.
  MASU_ALWAYS_INLINE Vec3<Lanes<Real>> corners_of(const SceneView<Stored>& scene, const std::uint32_t* tests,
                                                  [[maybe_unused]] const Lanes<Stored> (&rows)[3][4],
                                                  Vec3<Stored> Triangle<Stored>::*corner) const {
    if constexpr (is_placed) {
      static_assert(sizeof(Leaf<Stored>) == sizeof(Triangle<Stored>));
      const Vec3<Lanes<Stored>> v =
          corners<Stored>(&structure_.placed.of_meshes.leaves->record, tests, corner);
      const auto along = [&](int row) __attribute__((always_inline)) {
        if constexpr (std::is_same_v<Real, Stored>)
          return masu::along(rows[row], v);
        else
          return part_of<Real>(masu::along(rows[row], v), 0);
      };
      return {along(0), along(1), along(2)};
    } else {
      return corners<Real>(scene.triangles, tests, corner);
    }
  }
  MASU_ALWAYS_INLINE PrimitiveIndex primitive(std::uint32_t test) const {
    if constexpr (is_placed)
      return first_triangle_[test_lane_[test]] + structure_.placed.of_meshes.leaves[test_[test]].primitive();
    else
      return test_[test];
  }
  // The last of those ahead.
  MASU_ALWAYS_INLINE void take(int lane, std::ptrdiff_t height) {
    const std::uint64_t siblings = ahead_[lane].siblings[--height];
    const std::int32_t entry = ahead_[lane].entries[height];
    const std::uint32_t before =
        _bzhi_u32(static_cast<std::uint32_t>(siblings) >> 24, static_cast<std::uint32_t>(entry & slot_mask));
    const HierarchyNode* nodes = first_nodes();
    if constexpr (is_placed) {
      if (height < mesh_begin_[lane]) leave_mesh(lane);
      nodes = nodes_[lane];
    }
    go_to(lane, nodes + (siblings >> 32) + std::popcount(before), entry, height);
  }

  MASU_ALWAYS_INLINE void keep(int lane, Real t, PrimitiveIndex primitive) {
    if (!(t > t_min_[lane])) return;
    if constexpr (query == Query::occlusion) {
      if (!(t < t_max_[lane])) return;
      end(lane);
    } else {
      if (!is_nearer(t, primitive, {t_[lane], primitive_[lane]})) return;
      primitive_[lane] = primitive;
    }
    t_[lane] = t;
    farthest_.of[lane] = in_float32(t);
  }

  // Of each lane: its ray, and the nearest hit so far, at t_max where there is none.
  Vectors<Real, lanes> origin_, direction_, across1_, across2_;
  Numbers<Real, lanes> inverse_square_;
  // As boxes are met by it, in the world and in a mesh.
  std::conditional_t<is_placed, MovedRay, BoxRay<Stored>> box_rays_[lanes][is_placed ? 2 : 1];
  Real t_min_[lanes], t_max_[lanes], t_[lanes];
  Numbers<float, lanes> farthest_; // in_float32(t_); where nothing is to be met -1
  PrimitiveIndex primitive_[lanes];

  // The node to visit, where the ray enters it, and what is ahead besides.
  const HierarchyNode* node_[lanes];
  std::int32_t entry_[lanes];
  std::ptrdiff_t height_[lanes];
  NodesAhead ahead_[lanes];

  // What is met of it: nodes as NodesAhead has them, -1 where there is none; and slots_met().
  __m256i entries_met_[lanes];
  std::uint32_t met_[lanes];

  // Primitives to be tested, of meshes leaves, each one's lane, and where it is hit, a bit for each hit.
  alignas(32) Real test_t_[most_tests + 8];
  std::uint32_t test_[most_tests + 8];
  int test_lane_[most_tests + 8];
  std::uint64_t hits_[most_tests / 64];
  std::uint32_t test_count_ = 0;

  // Of each lane through placed meshes: its ray, nodes, and how high what is ahead begins, in a mesh, or 0
  // above: for each node all three are needed; and of a mesh the rows of the placement's transform.
  const MovedRay* moved_ray_[lanes];
  const HierarchyNode* nodes_[lanes];
  std::int32_t mesh_begin_[lanes];
  std::uint32_t mask_[lanes], first_triangle_[lanes];
  Numbers<Stored, lanes> rows_[3][4];
  const Structure structure_;
};

} // namespace masu
