#include "libscene/mesh/ear_clipping.h"

#include "libscene/mesh/point_tree.h"

#include <algorithm>
#include <cmath>

namespace masu {
namespace {

// A vertex this far outside a cut, relative to the edge's length, still counts as on it: twice the bound of
// has_area, since the projection can foreshorten by √3.
constexpr double slack = 32 * RealTraits<double>::unit_roundoff;

double extent(const Point2& a, const Point2& b) {
  return max(std::abs(a.x - b.x), std::abs(a.y - b.y));
}

bool lies_between(double a, double value, double b) {
  return min(a, b) < value && value < max(a, b);
}

class EarClipper {
public:
  EarClipper(std::span<const Point2> points, std::span<const std::uint32_t> ring)
      : points_(points), previous_(points.size()), next_(points.size()), stamps_(points.size(), 0),
        ranks_(points.size(), Rank::open), obstacles_(points, {}), size_(ring.size()),
        retests_left_(64 * ring.size() + 4096), steps_left_(64 * ring.size() + 4000000),
        some_vertex_(ring.front()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t follower = ring[i + 1 < ring.size() ? i + 1 : 0];
      next_[ring[i]] = follower;
      previous_[follower] = ring[i];
    }
    obstacles_ = obstacles(ring);
    heap_.reserve(3 * ring.size());
    for (const std::uint32_t v : ring)
      classify(v);
  }

  void run(std::span<const std::uint32_t> ring, const std::function<bool()>& otherwise,
           Triangulation& result) {
    if (!turns_once(ring)) result.crosses_itself = true;
    while (size_ > 3) {
      if (effort_ == Effort::limited && steps_left_ == 0) {
        if (otherwise()) return;
        effort_ = result.crosses_itself ? Effort::untested : Effort::unlimited;
      }
      process(pop(), result);
    }
    if (size_ < 3) return;
    if (turn(some_vertex_) < 0) result.crosses_itself = true;
    emit(some_vertex_, result);
  }

private:
  // limited: until steps_left_ is 0. untested: ears may contain vertices, for polygons that have no
  // triangulation.
  enum class Effort { limited, unlimited, untested };
  // The kinds of vertices, in the order in which they are cut off.
  enum class Rank : std::uint8_t {
    spike,   // both edges have the same direction: no area
    open,    // convex, and not known to be blocked
    grazed,  // nearly straight, or a vertex is nearly on its cut: would make a sliver
    flat,    // straight
    blocked, // the ear contains a vertex
    reflex,
  };
  struct Candidate {
    Rank rank;
    double shape; // sine of the corner / length² of the cut: short cuts first, slivers last
    std::uint32_t vertex, stamp;
    bool operator<(const Candidate& other) const {
      if (rank != other.rank) return rank > other.rank;
      if (shape != other.shape) return shape < other.shape;
      return vertex > other.vertex;
    }
  };
  enum class Fit { clear, grazed, blocked };

  const Point2& before(std::uint32_t v) const { return points_[previous_[v]]; }
  const Point2& after(std::uint32_t v) const { return points_[next_[v]]; }
  double turn(std::uint32_t v) const { return orientation(before(v), points_[v], after(v)); }

  bool is_nearly_straight(std::uint32_t v, double turn) const {
    return turn <= slack * (extent(before(v), points_[v]) + extent(points_[v], after(v)));
  }

  Rank rank_by_turn(std::uint32_t v, double turn) const {
    if (turn != 0) return turn > 0 ? Rank::open : Rank::reflex;
    const Point2 &a = before(v), &p = points_[v], &b = after(v);
    return lies_between(a.x, p.x, b.x) || lies_between(a.y, p.y, b.y) ? Rank::flat : Rank::spike;
  }

  // An ear that contains a vertex of a simple polygon contains one that isn't strictly convex.
  PointTree obstacles(std::span<const std::uint32_t> ring) const {
    std::vector<std::uint32_t> found;
    for (const std::uint32_t v : ring)
      if (is_nearly_straight(v, turn(v))) found.push_back(v);
    return {points_, std::move(found)};
  }

  // Whether the polygon's turning number is 1, as for every simple polygon: counts how often the edges'
  // direction passes +x.
  bool turns_once(std::span<const std::uint32_t> ring) const {
    const auto is_upward = [](const Point2& from, const Point2& to) {
      return to.y > from.y || (to.y == from.y && to.x > from.x);
    };
    std::ptrdiff_t turns = 0;
    for (const std::uint32_t v : ring) {
      const double by = turn(v);
      if (by == 0 && rank_by_turn(v, by) == Rank::spike)
        return true; // half a turn in either sense: undecided
      const bool up_before = is_upward(before(v), points_[v]);
      const bool up_after = is_upward(points_[v], after(v));
      if (by > 0 && !up_before && up_after) ++turns;
      if (by < 0 && up_before && !up_after) --turns;
    }
    return turns == 1;
  }

  void process(const Candidate& candidate, Triangulation& result) {
    const std::uint32_t v = candidate.vertex;
    switch (candidate.rank) {
    case Rank::spike:
      if (!(points_[v] == before(v)) && !(points_[v] == after(v))) ++result.slivers;
      return unlink(v);
    case Rank::open:
    case Rank::grazed: {
      const Fit found = fit(v);
      if (found == Fit::blocked) return push(v, Rank::blocked);
      if (found == Fit::grazed && candidate.rank == Rank::open) return push(v, Rank::grazed);
      return cut(v, result);
    }
    case Rank::flat:
    case Rank::blocked:
    case Rank::reflex:
      // There is no ear, so the polygon isn't simple: make the best of it.
      if (retest_blocked()) {
        if (candidate.rank != Rank::blocked) push(v, candidate.rank);
        return;
      }
      if (candidate.rank == Rank::flat) {
        ++result.slivers;
        return unlink(v);
      }
      result.crosses_itself = true;
      return cut(v, result);
    }
  }

  // Makes blocked ears candidates again, if the ring has changed and the limit of tests isn't reached.
  bool retest_blocked() {
    if (!changed_ || retests_left_ < size_) return false;
    changed_ = false;
    retests_left_ -= size_;
    bool any = false;
    std::uint32_t v = some_vertex_;
    for (std::size_t i = 0; i < size_; ++i, v = next_[v])
      if (ranks_[v] == Rank::blocked) {
        push(v, Rank::open);
        any = true;
      }
    return any;
  }

  Fit fit(std::uint32_t v) {
    if (effort_ == Effort::untested) return Fit::clear;
    const std::array<Point2, 3> ear{before(v), points_[v], after(v)};
    Fit worst = Fit::clear;
    const std::size_t steps = obstacles_.visit(ear, slack, [&](std::uint32_t other) {
      if (other != v && other != previous_[v] && other != next_[v]) worst = std::max(worst, fit(ear, other));
      return worst == Fit::blocked;
    });
    steps_left_ -= std::min(steps_left_, steps);
    return worst;
  }

  Fit fit(const std::array<Point2, 3>& ear, std::uint32_t other) const {
    const Point2 &a = ear[0], &b = ear[1], &c = ear[2];
    const Point2& p = points_[other];
    const double by_cut = orientation(c, a, p);
    if (by_cut < -slack * extent(c, a)) return Fit::clear;
    const double by_ab = orientation(a, b, p);
    if (by_ab < 0) return Fit::clear;
    const double by_bc = orientation(b, c, p);
    if (by_bc < 0) return Fit::clear;
    if (by_cut < 0) return Fit::grazed;
    if (by_ab > 0 && by_bc > 0) return Fit::blocked;
    // On an edge or a corner of the ear, as at bridges to holes: blocks it only if one of its edges leads
    // inside.
    const auto leads_inside = [&](const Point2& to) {
      return (by_ab > 0 || orientation(a, b, to) > 0) && (by_bc > 0 || orientation(b, c, to) > 0) &&
             (by_cut > 0 || orientation(c, a, to) > 0);
    };
    return leads_inside(before(other)) || leads_inside(after(other)) ? Fit::blocked : Fit::clear;
  }

  void push(std::uint32_t v, Rank rank) {
    ranks_[v] = rank;
    heap_.push_back({rank, ear_shape(before(v), points_[v], after(v), turn(v)), v, ++stamps_[v]});
    std::push_heap(heap_.begin(), heap_.end());
  }

  Candidate pop() {
    for (;;) {
      std::pop_heap(heap_.begin(), heap_.end());
      const Candidate top = heap_.back();
      heap_.pop_back();
      if (top.stamp == stamps_[top.vertex]) return top;
    }
  }

  // Updates a vertex whose neighbours have changed.
  void classify(std::uint32_t v) {
    const double by = turn(v);
    const Rank rank = rank_by_turn(v, by);
    const bool is_straight = is_nearly_straight(v, by);
    if (obstacles_.holds(v) && !is_straight) obstacles_.remove(v);
    push(v, rank == Rank::open && is_straight ? Rank::grazed : rank);
  }

  void unlink(std::uint32_t v) {
    const std::uint32_t left = previous_[v];
    const std::uint32_t right = next_[v];
    next_[left] = right;
    previous_[right] = left;
    ++stamps_[v];
    if (obstacles_.holds(v)) obstacles_.remove(v);
    some_vertex_ = left;
    --size_;
    changed_ = true;
    classify(left);
    classify(right);
  }

  void cut(std::uint32_t v, Triangulation& result) {
    emit(v, result);
    unlink(v);
  }

  void emit(std::uint32_t v, Triangulation& result) const {
    if (turn(v) < 0)
      result.triangles.push_back({next_[v], v, previous_[v]});
    else
      result.triangles.push_back({previous_[v], v, next_[v]});
  }

  std::span<const Point2> points_;
  std::vector<std::uint32_t> previous_, next_;
  std::vector<std::uint32_t> stamps_; // of each vertex's valid candidate: older ones are ignored
  std::vector<Rank> ranks_;
  std::vector<Candidate> heap_; // one valid candidate for each vertex of the ring
  PointTree obstacles_;         // vertices that can block an ear: all that aren't clearly convex
  std::size_t size_;            // vertices in the ring
  std::size_t retests_left_, steps_left_;
  Effort effort_ = Effort::limited;
  bool changed_ = false; // since blocked ears were last tested again
  std::uint32_t some_vertex_;
};

} // namespace

void clip_ears(std::span<const Point2> points, std::span<const std::uint32_t> ring,
               const std::function<bool()>& otherwise, Triangulation& result) {
  EarClipper(points, ring).run(ring, otherwise, result);
}

} // namespace masu
