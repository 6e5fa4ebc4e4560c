#include "libscene/mesh/ear_clipping.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

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

// A k-d tree of points in a plane, with removal of points and queries by triangle.
class PointTree {
public:
  // `members`: indices of `points`, which must outlive the tree.
  PointTree(std::span<const Point2> points, std::vector<std::uint32_t> members)
      : points_(points), members_(std::move(members)) {
    position_.assign(points.size(), absent);
    if (members_.empty()) return;
    build(0, 0, static_cast<std::uint32_t>(members_.size()));
    for (std::uint32_t i = 0; i < members_.size(); ++i)
      position_[members_[i]] = i;
  }

  bool holds(std::uint32_t point) const { return position_[point] != absent; }

  void remove(std::uint32_t point) {
    const std::uint32_t position = std::exchange(position_[point], absent);
    for (std::size_t node = 0;;) {
      --nodes_[node].alive;
      const std::uint32_t middle = nodes_[node].middle();
      if (nodes_[node].is_leaf()) return;
      node = 2 * node + (position < middle ? 1 : 2);
    }
  }

  // Calls visit(point) for every point in the counter-clockwise triangle, including all within `slack` times
  // an edge's length outside it, and maybe for others nearby. Stops when visit returns true. Returns the
  // number of nodes that it looked at.
  template <class Visit>
  std::size_t visit(const std::array<Point2, 3>& triangle, Visit visit) const {
    if (nodes_.empty()) return 0;
    const auto [low, high] = box_of(triangle);
    std::array<std::size_t, 64> pending{};
    std::size_t count = 1, visited = 0;
    while (count > 0) {
      ++visited;
      const std::size_t index = pending[--count];
      const Node& node = nodes_[index];
      if (node.alive == 0 || node.max.x < low.x || node.min.x > high.x || node.max.y < low.y ||
          node.min.y > high.y)
        continue;
      if (is_outside(node, triangle)) continue;
      if (!node.is_leaf()) {
        pending[count++] = 2 * index + 2;
        pending[count++] = 2 * index + 1;
        continue;
      }
      for (std::uint32_t i = node.first; i < node.last; ++i)
        if (holds(members_[i]) && visit(members_[i])) return visited;
    }
    return visited;
  }

private:
  static constexpr std::uint32_t absent = 0xffffffffU;
  static constexpr std::uint32_t leaf_size = 8;

  // The children of node i are 2i+1 and 2i+2; each has half of its members.
  struct Node {
    Point2 min, max;
    std::uint32_t first, last, alive;
    std::uint32_t middle() const { return first + (last - first) / 2; }
    bool is_leaf() const { return last - first <= leaf_size; }
  };

  void build(std::size_t index, std::uint32_t first, std::uint32_t last) {
    if (nodes_.size() <= index) nodes_.resize(index + 1);
    Point2 low = points_[members_[first]];
    Point2 high = low;
    for (std::uint32_t i = first + 1; i < last; ++i) {
      const Point2& p = points_[members_[i]];
      low = {min(low.x, p.x), min(low.y, p.y)};
      high = {max(high.x, p.x), max(high.y, p.y)};
    }
    const Node node{low, high, first, last, last - first};
    nodes_[index] = node;
    if (node.is_leaf()) return;
    const bool by_x = high.x - low.x >= high.y - low.y;
    std::nth_element(members_.begin() + first, members_.begin() + node.middle(), members_.begin() + last,
                     [&](std::uint32_t a, std::uint32_t b) {
                       return by_x ? points_[a].x < points_[b].x : points_[a].y < points_[b].y;
                     });
    build(2 * index + 1, first, node.middle());
    build(2 * index + 2, node.middle(), last);
  }

  static std::pair<Point2, Point2> box_of(const std::array<Point2, 3>& triangle) {
    const auto [a, b, c] = triangle;
    const Point2 low{min(a.x, min(b.x, c.x)), min(a.y, min(b.y, c.y))};
    const Point2 high{max(a.x, max(b.x, c.x)), max(a.y, max(b.y, c.y))};
    const double margin = slack * max(high.x - low.x, high.y - low.y);
    return {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
  }

  // Whether the node's box is outside an edge, tested at the box's corner farthest inside.
  static bool is_outside(const Node& node, const std::array<Point2, 3>& triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2& a = triangle[i];
      const Point2 along{triangle[(i + 1) % 3].x - a.x, triangle[(i + 1) % 3].y - a.y};
      const Point2 inmost{along.y < 0 ? node.max.x : node.min.x, along.x > 0 ? node.max.y : node.min.y};
      const double side = along.x * (inmost.y - a.y) - along.y * (inmost.x - a.x);
      if (side < -slack * max(std::abs(along.x), std::abs(along.y))) return true;
    }
    return false;
  }

  std::span<const Point2> points_;
  std::vector<std::uint32_t> members_;  // in the tree's order
  std::vector<std::uint32_t> position_; // of each point in members_
  std::vector<Node> nodes_;
};

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
    const std::size_t steps = obstacles_.visit(ear, [&](std::uint32_t other) {
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
    heap_.push({rank, ear_shape(before(v), points_[v], after(v), turn(v)), v, ++stamps_[v]});
  }

  Candidate pop() {
    for (;;) {
      const Candidate top = heap_.top();
      heap_.pop();
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
  std::priority_queue<Candidate> heap_; // one valid candidate for each vertex of the ring
  PointTree obstacles_;                 // vertices that can block an ear: all that aren't clearly convex
  std::size_t size_;                    // vertices in the ring
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
