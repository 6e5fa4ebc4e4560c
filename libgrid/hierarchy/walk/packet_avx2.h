// Rays that are alike, as camera rays are, through a bounding volume hierarchy or placed meshes as a packet,
// on one thread of a processor with AVX2: a node is visited once for all of them. Boxes that no ray between
// the bounds of their origins and inverse directions meets are passed over, eight at a time (after Boulos,
// Wald & Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006). What is left is
// tested against a row of rays at a time, eight in float32 and four in float64: a node's box until some meet
// it (after Overbeck, Ramamoorthi & Mark, "Large Ray Packets for Real-Time Whitted Ray Tracing", 2008), that
// of references against all, and each primitive against the rows that meet its box. Host only.
#pragma once

#include "libgrid/placed/placed_lanes_avx2.h"
#include "libgrid/trace/trace.h"
#include "libscene/geometry/triangle_lanes.h"

namespace masu {

// Takes from what is left of each row the rays that run as one of them does: by their inverse directions.
template <class Real, int rows, class InverseOf>
MASU_ALWAYS_INLINE void take_alike(const InverseOf& inverse_of, const Vec3<Real>& way, unsigned (&left)[rows],
                                   unsigned (&alike)[rows]) {
  for (int e = 0; e < rows; ++e) {
    alike[e] = 0;
    if (left[e] == 0) continue;
    alike[e] = left[e] & ~(smallest(inverse_of(e) * all_of(way)) < Real(0)).bits();
    left[e] ^= alike[e];
  }
}

// Rays of a packet that run the same way along each axis, on their way through a hierarchy. M: a Method by
// watertight tests. Rays: a row of rays made ready (renderer/cpu/ray_lanes.h). Structure: a hierarchy, or a
// PlacedRay<Stored> of triangles that are tested in lanes, which all of them see alike: through a mesh go
// together those that run the same way in it.
template <Query query, class M, class Stored, class Rays, class Structure = HierarchyView<typename M::Real>>
class PacketWalk {
public:
  using Real = typename M::Real;
  static constexpr int rows = 32 / Rays::count; // a tile of 8 by 4 pixels
  static constexpr bool is_placed = !std::is_same_v<Structure, HierarchyView<Real>>;

  // `lanes`: of each row a bit for each ray that takes part, of which there is one at least; `way`: signs of
  // all their directions. Of rows of which no ray takes part nothing is read.
  MASU_ALWAYS_INLINE PacketWalk( // NOLINT(cppcoreguidelines-pro-type-member-init): the body does it
      const SceneView<Stored>& scene, const Structure& structure, const Rays (&rays)[rows],
      const unsigned (&lanes)[rows], const Vec3<Real>& way)
      : scene_(scene), rays_(rays), structure_(structure) {
    for (int e = 0; e < rows; ++e) {
      t_[e] = Real(-1); // meets no box
      if (lanes[e] == 0) continue;
      taking_part_ |= 1U << e;
      const Vec3<Number> origin = rays[e].origin.all();
      world_.rays[e] = {origin, origin, bounded(rays[e].inverse.all())};
      t_[e] = select(lanes_of<Real>(lanes[e]), rays[e].t_max.all(), t_[e]);
      primitive_[e] = _mm256_setzero_si256(); // wins no tie at t_max
    }
    world_.bind(lanes, way);
    update_farthest();
  }

  MASU_ALWAYS_INLINE void walk() {
    Ahead ahead[max_ahead + boxes_per_node];
    if constexpr (is_placed) {
      const auto [first, second] = structure_.roots();
      for (const std::uint32_t root : {first, second})
        if (root != no_root) visit_all<false>(world_, {0, root, taking_part_}, ahead, 0);
    } else {
      visit_all<false>(world_, {0, 0, taking_part_}, ahead, 0);
    }
  }

  // The nearest hit of a ray that takes part; of occlusion one that is nearer than t_max.
  Hit<Real> hit(int e, std::size_t lane) const {
    alignas(32) Real t[Rays::count];
    t_[e].store(t);
    PrimitiveIndex primitives[8];
    store_eight(primitives, primitive_[e]);
    const bool hits = t[lane] < (query == Query::occlusion ? Real(0) : rays_[e].t_max.of[lane]);
    return hits ? Hit<Real>{t[lane], primitives[lane * 8 / Rays::count]} : no_hit<Real>();
  }

private:
  using Number = Lanes<Real>;
  static constexpr int max_ahead = is_placed ? max_placed_ahead : max_nodes_ahead;

  // A node to visit, and where the first ray enters it: before that, or there.
  struct Ahead {
    float enter;
    std::uint32_t node;
    unsigned rows; // a bit for each whose rays may meet it
  };

  // The rows' rays where boxes are, in the world or in a mesh. In the world origins are the same.
  struct Space {
    BoundRay<Vec3<Number>> rays[rows]{};
    BoxRay<Stored> entering, leaving; // bound()

    MASU_ALWAYS_INLINE void bind(const unsigned (&lanes)[rows], const Vec3<Real>& way) {
      entering = bound(rays, &BoundRay<Vec3<Number>>::entering, lanes, way);
      leaving = bound(rays, &BoundRay<Vec3<Number>>::leaving, lanes, way);
    }
  };

  // A ray that enters no box after one of the packet's does, or one that leaves none before. That is so of
  // products that are positive; negative ones are before all rays begin.
  static BoxRay<Stored> bound(const BoundRay<Vec3<Number>> (&rays)[rows],
                              Vec3<Number> BoundRay<Vec3<Number>>::*origin_of, const unsigned (&lanes)[rows],
                              const Vec3<Real>& way) {
    const bool enters = origin_of == &BoundRay<Vec3<Number>>::entering;
    constexpr Real largest = RealTraits<Real>::largest;
    Vec3<Real> origin{}, speed{};
    for (int axis = 0; axis < 3; ++axis) {
      const bool last = enters != (way[axis] < 0); // the last origin and the least inverse, or the contrary
      Number from = last ? -largest : largest, inverted = -from;
      for (int e = 0; e < rows; ++e) {
        if (lanes[e] == 0) continue;
        const LaneMask<Real> own = lanes_of<Real>(lanes[e]);
        const Number own_from = select(own, (rays[e].*origin_of)[axis], from),
                     own_inverse = select(own, rays[e].inverse[axis], inverted);
        from = last ? max(from, own_from) : min(from, own_from);
        inverted = last ? min(inverted, own_inverse) : max(inverted, own_inverse);
      }
      origin.set(axis, last ? largest_lane(from) : least_lane(from));
      speed.set(axis, last ? least_lane(inverted) : largest_lane(inverted));
    }
    return {origin, speed};
  }

  MASU_ALWAYS_INLINE void update_farthest() {
    Number all = t_[0];
    for (const Number t : t_)
      all = max(all, t);
    farthest_ = in_float32(largest_lane(all));
  }

  // The same one by one.
  struct Planes {
    alignas(32) Real near[3][boxes_per_node], far[3][boxes_per_node];
    MASU_ALWAYS_INLINE explicit Planes(const NodePlanes& planes) {
      for (int axis = 0; axis < 3; ++axis) {
        for (std::size_t first = 0; first < boxes_per_node; first += Rays::count) {
          part_of<Real>(planes.near[axis], first).store(near[axis] + first);
          part_of<Real>(planes.far[axis], first).store(far[axis] + first);
        }
      }
    }
  };

  // A function of a slot: which of a row's rays meet its box.
  template <bool in_mesh>
  MASU_ALWAYS_INLINE auto meeting(const BoundRay<Vec3<Number>>& rays, const HierarchyNode& node,
                                  const Planes& planes, int e) const {
    const auto unit = [&](int axis) -> Number {
      return float_of((node.exponents >> (8 * axis) & 0xff) << 23);
    };
    const Vec3<Number> scale = rays.inverse * Vec3<Number>{unit(0), unit(1), unit(2)},
                       origin{Real(node.origin[0]), Real(node.origin[1]), Real(node.origin[2])},
                       entered = (origin - rays.entering) * rays.inverse,
                       left = in_mesh ? (origin - rays.leaving) * rays.inverse : entered;
    return [&planes, scale, entered, left, farthest = t_[e] ](int slot) __attribute__((always_inline)) {
      const auto at = [&](const Real(&of_slots)[3][boxes_per_node], const Vec3<Number>& start)
          __attribute__((always_inline)) {
        const auto along = [&](int axis) __attribute__((always_inline)) {
          return fma(Number(of_slots[axis][slot]), scale[axis], start[axis]);
        };
        return Vec3<Number>{along(0), along(1), along(2)};
      };
      return boxes_met<Real>(at(planes.near, entered), at(planes.far, left), farthest).slots();
    };
  }

  // And all below it; what is ahead up to `begin` isn't.
  template <bool in_mesh>
  MASU_ALWAYS_INLINE void visit_all(const Space& space, Ahead next, Ahead* ahead, const int begin) {
    for (int height = begin;;) {
      height = visit<in_mesh>(space, next, ahead, height);
      do {
        if (height == begin) return;
        next = ahead[--height];
      } while (!(next.enter <= farthest_));
    }
  }

  void visit_mesh(const HierarchyNode& item, unsigned of_rows, Ahead* ahead, int height) {
    const auto own = structure_.placed.entrance(item);
    if (!structure_.sees(item.first_reference, own)) return;
    placement_ = structure_.placed.placements + item.first_reference;
    Space mesh;
    unsigned left[rows] = {}, alike[rows];
    each_bit(of_rows, [&](int e) {
      mesh.rays[e] = carried_rays(own, rays_[e].origin.all(), rays_[e].flushed.all());
      left[e] = (Number(Real(0)) <= t_[e]).bits();
    });
    for (int e = 0; e < rows; ++e) {
      while (left[e] != 0) {
        Vectors<Real, Rays::count> inverse{};
        inverse.set(mesh.rays[e].inverse);
        const Vec3<Real> way = inverse.of(static_cast<std::size_t>(std::countr_zero(left[e])));
        take_alike([&](int row) { return mesh.rays[row].inverse; }, way, left, alike);
        mesh.bind(alike, way);
        unsigned taking_part = 0;
        for (int row = e; row < rows; ++row)
          taking_part |= (alike[row] != 0 ? 1U : 0U) << row;
        visit_all<true>(mesh, {0, own.root, taking_part}, ahead, height);
      }
    }
  }

  template <bool in_mesh>
  MASU_ALWAYS_INLINE const HierarchyNode* nodes() const {
    if constexpr (is_placed)
      return in_mesh ? structure_.placed.of_meshes.nodes : structure_.placed.upper_nodes;
    else
      return structure_.nodes;
  }
  // A reference's triangle as it is stored; of other kinds none.
  MASU_ALWAYS_INLINE const Triangle<Stored>* stored_triangle(std::uint32_t reference) const {
    if constexpr (is_placed)
      return &structure_.placed.of_meshes.leaves[reference].record;
    else if constexpr (!tests_triangles_in_lanes<M, Stored>)
      return nullptr;
    else
      return scene_.triangles + structure_.references[reference];
  }

  // Tests what the rays meet of a node's references, and puts its nodes that they meet ahead, the nearest
  // last. Returns how many there are then.
  template <bool in_mesh>
  MASU_ALWAYS_INLINE int visit(const Space& space, const Ahead& own, Ahead* ahead, int height) {
    const HierarchyNode& node = nodes<in_mesh>()[own.node];
    if constexpr (is_placed && !in_mesh)
      if (node_slots(node) == 0) {
        visit_mesh(node, own.rows, ahead, height);
        return height;
      }
    const NodePlanes numbers = planes_of(node, space.entering);
    const BoxesMet<float> boxes =
        boxes_met(node, numbers, space.entering, space.leaving.origin, space.leaving.inverse, farthest_);
    const Planes planes(numbers);
    const unsigned siblings = node_slots(node), with_references = boxes.slots() & ~siblings;

    // Of nodes the rows from the first on that meets them, of references the lanes that meet their box.
    unsigned undecided = boxes.slots() & siblings, to_visit = 0, met_by[boxes_per_node];
    std::uint8_t lanes[boxes_per_node][rows] = {};
    for (int e = 0; e < rows && (undecided | with_references) != 0; ++e) {
      if ((own.rows >> e & 1) == 0) continue;
      const auto meets = meeting<in_mesh>(space.rays[e], node, planes, e);
      each_bit(undecided, [&](int slot) {
        if (meets(slot) == 0) return;
        undecided &= ~(1U << slot);
        to_visit |= 1U << slot;
        met_by[slot] = own.rows >> e << e;
      });
      each_bit(with_references, [&](int slot) { lanes[slot][e] = static_cast<std::uint8_t>(meets(slot)); });
    }

    const auto each_reference = [&](const auto& act) {
      each_bit(with_references, [&](int slot) {
        const std::uint32_t held = slot_byte(node.slots, slot),
                            first = node.first_reference + references_begin(held);
        for (std::uint32_t i = 0; i < references_in(held); ++i)
          act(first + i, lanes[slot]);
      });
    };
    if constexpr (tests_triangles_in_lanes<M, Stored>)
      each_reference([&](std::uint32_t reference, const auto&) { prefetch(stored_triangle(reference)); });
    if (to_visit != 0) {
      // There is room, but while a mapped file changes: then results are thrown away.
      if (height > max_ahead) [[unlikely]]
        height = 0;
      const int begin = height;
      alignas(32) float enter[boxes_per_node];
      boxes.enter.store(enter);
      each_bit(to_visit, [&](int slot) {
        const auto before = static_cast<std::uint32_t>(std::popcount(siblings & ((1U << slot) - 1)));
        const Ahead child{enter[slot], node.first_node + before, met_by[slot]};
        int at = height++;
        for (; at != begin && ahead[at - 1].enter < child.enter; --at)
          ahead[at] = ahead[at - 1];
        ahead[at] = child;
      });
      prefetch(nodes<in_mesh>() + ahead[height - 1].node);
    }
    each_reference([&](std::uint32_t reference, const auto& of) {
      const auto test_all = [&](PrimitiveIndex primitive, const Triangle<Stored>* triangle)
          __attribute__((always_inline)) {
        for (int e = 0; e < rows; ++e)
          if (of[e] != 0) test(e, of[e], primitive, triangle);
      };
      if constexpr (is_placed) {
        const Leaf<Stored> leaf{placed_triangle(*placement_, *stored_triangle(reference))};
        test_all(placement_->first_triangle + leaf.primitive(), &leaf.record);
      } else {
        test_all(structure_.references[reference], stored_triangle(reference));
      }
    });
    if (with_references != 0) update_farthest();
    return height;
  }

  MASU_ALWAYS_INLINE void test(int e, unsigned lanes, PrimitiveIndex primitive,
                               const Triangle<Stored>* triangle) {
    const Rays& own = rays_[e];
    if constexpr (tests_triangles_in_lanes<M, Stored>) {
      const WatertightRay<Number> ray{{own.origin.all(), own.flushed.all(), own.inverse_square.all()},
                                      own.across1.all(),
                                      own.across2.all()};
      const auto corner = [&](const auto& c) { return all_of(cast<Real>(c)) - ray.origin; };
      Number t = 0;
      const LaneMask<Real> hits =
          intersect(ray, corner(triangle->a), corner(triangle->b), corner(triangle->c), t);
      keep(e, hits & (own.t_min.all() < t), t, primitive);
    } else {
      NoTestCounts counts;
      alignas(32) Real t[Rays::count] = {};
      unsigned hits = 0;
      each_bit(lanes, [&](int lane) {
        const WatertightRay<Real> ray = own.test_ray(static_cast<std::size_t>(lane));
        if (test_primitive<M::kinds>(scene_, ray, primitive, own.t_min.of[lane], t[lane], counts))
          hits |= 1U << lane;
      });
      keep(e, lanes_of<Real>(hits), Number::load(t), primitive);
    }
  }

  MASU_ALWAYS_INLINE void keep(int e, LaneMask<Real> hits, Number t, PrimitiveIndex primitive) {
    if constexpr (query == Query::occlusion) {
      t_[e] = select(hits & (t < t_[e]), Real(-1), t_[e]);
    } else {
      const __m256i number = whole_in_lanes<Real>(primitive);
      const LaneMask<Real> lower = is_greater<Real>(primitive_[e], number),
                           nearer = hits & ((t < t_[e]) | ((t == t_[e]) & lower));
      t_[e] = select(nearer, t, t_[e]);
      primitive_[e] = _mm256_blendv_epi8(primitive_[e], number, nearer.whole());
    }
  }

  Number t_[rows];
  __m256i primitive_[rows];
  Space world_;
  const SceneView<Stored>& scene_;
  const Placement<Stored>* placement_ = nullptr; // in whose mesh the rays are
  const Rays (&rays_)[rows];
  const Structure structure_;
  unsigned taking_part_ = 0; // a bit for each row
  float farthest_;           // of the nearest hits
};

} // namespace masu
