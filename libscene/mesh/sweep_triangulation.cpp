#include "libscene/mesh/sweep_triangulation.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace masu {
namespace {

// Vertices are numbered by their position in the ring; edge i leads from vertex i to the next one.
using Vertex = std::uint32_t;
using Diagonal = std::pair<Vertex, Vertex>;

constexpr Vertex none = ~Vertex{0};

struct Ring {
  std::vector<Point2> points;

  Vertex size() const { return static_cast<Vertex>(points.size()); }
  Vertex next(Vertex v) const { return v + 1 < size() ? v + 1 : 0; }
  Vertex previous(Vertex v) const { return v > 0 ? v - 1 : size() - 1; }
  // The order of the sweep: by x, by y where x is the same.
  bool is_before(Vertex a, Vertex b) const {
    const Point2 &p = points[a], &q = points[b];
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  }
  double turn(Vertex a, Vertex b, Vertex c) const { return orientation(points[a], points[b], points[c]); }
};

// --- The sweep ---------------------------------------------------------------------------------------------

// Finds the diagonals of the trapezoids between consecutive vertices of the sweep's order.
class Sweep {
public:
  explicit Sweep(const Ring& ring) : ring_(ring), status_(Below{this}), places_(ring.size()) {}

  SweepOutcome run(std::vector<Diagonal>& diagonals) {
    std::vector<Vertex> order(ring_.size());
    std::iota(order.begin(), order.end(), Vertex{0});
    std::sort(order.begin(), order.end(), [&](Vertex a, Vertex b) { return ring_.is_before(a, b); });
    for (std::size_t i = 1; i < order.size(); ++i)
      if (!ring_.is_before(order[i - 1], order[i])) return SweepOutcome::undecided; // the same point
    diagonals_ = &diagonals;
    for (const Vertex v : order) {
      pass(v);
      if (outcome_ != SweepOutcome::triangulated) return outcome_;
    }
    return outcome_;
  }

private:
  // An edge that the sweep line meets; it is replaced by the next one of its chain where that goes on.
  struct Edge {
    Vertex left, right;
    bool has_interior_above;
    Vertex trapezoid; // the left vertex of the trapezoid above, where the interior is there
  };
  struct Below {
    using is_transparent = void;
    Sweep* sweep;
    bool operator()(const Edge& a, const Edge& b) const { return sweep->is_below(a, b); }
    bool operator()(const Edge& a, Vertex v) const { return sweep->side(a, v) > 0; }
    bool operator()(Vertex v, const Edge& a) const { return sweep->side(a, v) < 0; }
  };
  using Status = std::set<Edge, Below>;
  using Place = Status::iterator;

  // What holds as long as the polygon doesn't touch itself; or what holds then as long as nothing crosses.
  void require(bool holds, SweepOutcome otherwise = SweepOutcome::undecided) {
    if (!holds && outcome_ == SweepOutcome::triangulated) outcome_ = otherwise;
  }
  // Interior and exterior alternate along the sweep line.
  void require_alternation(bool holds) { require(holds, SweepOutcome::crosses); }

  // Positive where v is above the edge.
  double side(const Edge& edge, Vertex v) {
    const double side = ring_.turn(edge.left, edge.right, v);
    require(side != 0 || edge.left == v || edge.right == v);
    return side;
  }
  // The one that begins last is new.
  bool is_below(const Edge& a, const Edge& b) {
    if (a.left == b.left) return ring_.turn(a.left, a.right, b.right) > 0;
    return ring_.is_before(a.left, b.left) ? side(a, b.left) > 0 : side(b, a.left) < 0;
  }

  void check_crossing(const Edge& a, const Edge& b) {
    const double al = ring_.turn(a.left, a.right, b.left), ar = ring_.turn(a.left, a.right, b.right),
                 bl = ring_.turn(b.left, b.right, a.left), br = ring_.turn(b.left, b.right, a.right);
    const bool meet = a.left == b.left || a.right == b.right || a.right == b.left || b.right == a.left;
    if (meet) return require((al != 0 || ar != 0) && (bl != 0 || br != 0));
    const auto differ = [](double s, double t) { return (s > 0) != (t > 0); };
    if (al == 0 || ar == 0 || bl == 0 || br == 0) {
      const bool touch = (al == 0 || ar == 0 || differ(al, ar)) && (bl == 0 || br == 0 || differ(bl, br));
      return require(!touch);
    }
    require(!(differ(al, ar) && differ(bl, br)), SweepOutcome::crosses);
  }
  void check_neighbours(Place place) {
    if (place != status_.begin()) check_crossing(*std::prev(place), *place);
    if (std::next(place) != status_.end()) check_crossing(*place, *std::next(place));
  }

  Edge edge_of(Vertex i, Vertex trapezoid) const {
    const Vertex a = i, b = ring_.next(i);
    return ring_.is_before(a, b) ? Edge{a, b, true, trapezoid} : Edge{b, a, false, trapezoid};
  }
  void insert(Vertex i, Vertex trapezoid) {
    const auto [place, is_new] = status_.insert(edge_of(i, trapezoid));
    require(is_new);
    places_[i] = place;
    check_neighbours(place);
  }
  void erase(Vertex i) {
    const Place after = status_.erase(places_[i]);
    if (after != status_.begin() && after != status_.end()) check_crossing(*std::prev(after), *after);
  }
  // The chain goes on: at the same place of the order.
  void replace(Vertex from, Vertex to, Vertex trapezoid) {
    const Place place = places_[from];
    const_cast<Edge&>(*place) = edge_of(to, trapezoid);
    places_[to] = place;
    check_neighbours(place);
  }

  // The trapezoid above the edge ends at v, where another one begins.
  void end_trapezoid(Edge& below, Vertex v) {
    const Vertex left = std::exchange(below.trapezoid, v);
    require_alternation(below.has_interior_above && left != none);
    if (outcome_ != SweepOutcome::triangulated) return;
    if (ring_.next(left) != v && ring_.next(v) != left) diagonals_->push_back(std::minmax(left, v));
  }
  void end_trapezoid_below(Place place, Vertex v) {
    require_alternation(place != status_.begin());
    if (place != status_.begin()) end_trapezoid(const_cast<Edge&>(*std::prev(place)), v);
  }
  // Whether the interior is below the place.
  bool is_inside(Place place) const {
    return place != status_.begin() && std::prev(place)->has_interior_above;
  }

  void pass(Vertex v) {
    const Vertex p = ring_.previous(v), n = ring_.next(v); // edge p ends at v, edge v begins there
    const bool from_left = ring_.is_before(p, v), to_right = ring_.is_before(v, n);
    const bool is_convex = ring_.turn(p, v, n) > 0;
    if (from_left && to_right) { // the interior is above
      end_trapezoid(const_cast<Edge&>(*places_[p]), v);
      replace(p, v, v);
    } else if (!from_left && !to_right) { // below
      end_trapezoid_below(places_[v], v);
      replace(v, p, none);
    } else if (to_right) { // begins, or splits a trapezoid
      const Place above = status_.upper_bound(v);
      require_alternation(is_inside(above) != is_convex);
      if (!is_convex) end_trapezoid_below(above, v);
      if (outcome_ != SweepOutcome::triangulated) return;
      insert(v, v);
      insert(p, none);
    } else { // ends, or merges two
      end_trapezoid(const_cast<Edge&>(*places_[p]), v);
      if (!is_convex) end_trapezoid_below(places_[v], v);
      require_alternation(std::next(is_convex ? places_[p] : places_[v]) ==
                          (is_convex ? places_[v] : places_[p]));
      if (outcome_ != SweepOutcome::triangulated) return;
      erase(p);
      erase(v);
    }
  }

  const Ring& ring_;
  Status status_;
  std::vector<Place> places_; // of the edges in it
  std::vector<Diagonal>* diagonals_ = nullptr;
  SweepOutcome outcome_ = SweepOutcome::triangulated;
};

// --- Pieces ------------------------------------------------------------------------------------------------

// Calls act(its vertices in the ring's order) for each piece that the diagonals divide the ring into, until
// it returns false. False also where the diagonals cross each other.
template <class Act>
bool for_each_piece(Vertex size, std::vector<Diagonal>& diagonals, const Act& act) {
  // Each vertex's diagonals to vertices before it, farthest last; those behind it are open meanwhile.
  std::ranges::sort(diagonals, [](const Diagonal& a, const Diagonal& b) {
    return a.second != b.second ? a.second < b.second : a.first > b.first;
  });
  auto diagonal = diagonals.begin();
  std::vector<Vertex> stack, piece;
  for (Vertex v = 0; v < size; ++v) {
    for (; diagonal != diagonals.end() && diagonal->second == v; ++diagonal) {
      // What is on the stack behind the diagonal's first vertex lies between both.
      const auto first = std::lower_bound(stack.begin(), stack.end(), diagonal->first);
      if (first == stack.end() || *first != diagonal->first || stack.end() - first < 2) return false;
      piece.assign(first, stack.end());
      piece.push_back(v);
      stack.erase(first + 1, stack.end());
      if (!act(piece)) return false;
    }
    stack.push_back(v);
  }
  return stack.size() >= 3 && act(stack);
}

// --- Mountains ---------------------------------------------------------------------------------------------

class MountainClipper {
public:
  MountainClipper(const Ring& ring, std::vector<std::array<Vertex, 3>>& triangles)
      : ring_(ring), triangles_(triangles), previous_(ring.size()), next_(ring.size()) {}

  // Cuts off the convex vertex with the best shape first, as ear clipping does. False where none is left.
  bool clip(const std::vector<Vertex>& piece) {
    if (piece.size() == 3) return emit(piece[0], piece[1], piece[2]);
    const auto before = [&](Vertex a, Vertex b) { return ring_.is_before(a, b); };
    const auto [low, high] = std::minmax_element(piece.begin(), piece.end(), before);
    low_ = *low;
    high_ = *high;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const Vertex follower = piece[i + 1 < piece.size() ? i + 1 : 0];
      next_[piece[i]] = follower;
      previous_[follower] = piece[i];
    }
    if (next_[low_] != high_ && next_[high_] != low_) return false; // has no base
    heap_.clear();
    for (const Vertex v : piece)
      push(v);
    for (std::size_t left = piece.size(); left > 2; --left) {
      const Vertex v = pop();
      if (v == none || !emit(previous_[v], v, next_[v])) return false;
      const Vertex p = previous_[v], n = next_[v];
      next_[p] = n;
      previous_[n] = p;
      next_[v] = none; // not in the ring any more
      if (left == 3) break;
      push(p);
      push(n);
    }
    return true;
  }

private:
  struct Candidate {
    double shape;
    Vertex previous, vertex, next;
    bool operator<(const Candidate& other) const {
      return shape != other.shape ? shape < other.shape : vertex > other.vertex;
    }
  };

  bool emit(Vertex a, Vertex b, Vertex c) {
    triangles_.push_back({a, b, c});
    return ring_.turn(a, b, c) > 0;
  }
  void push(Vertex v) {
    const Vertex p = previous_[v], n = next_[v];
    const double turn = ring_.turn(p, v, n);
    if (v == low_ || v == high_ || !(turn > 0)) return;
    heap_.push_back({ear_shape(ring_.points[p], ring_.points[v], ring_.points[n], turn), p, v, n});
    std::push_heap(heap_.begin(), heap_.end());
  }
  Vertex pop() {
    while (!heap_.empty()) {
      std::pop_heap(heap_.begin(), heap_.end());
      const Candidate top = heap_.back();
      heap_.pop_back();
      if (next_[top.vertex] == top.next && previous_[top.vertex] == top.previous) return top.vertex;
    }
    return none;
  }

  const Ring& ring_;
  std::vector<std::array<Vertex, 3>>& triangles_;
  std::vector<Vertex> previous_, next_; // in the piece
  std::vector<Candidate> heap_;         // outdated ones have other neighbours
  Vertex low_ = none, high_ = none;
};

} // namespace

SweepOutcome triangulate_by_sweep(std::span<const Point2> points, std::span<const std::uint32_t> ring,
                                  std::vector<std::array<std::uint32_t, 3>>& triangles) {
  Ring own;
  own.points.reserve(ring.size());
  for (const std::uint32_t v : ring)
    own.points.push_back(points[v]);
  std::vector<Diagonal> diagonals;
  if (const SweepOutcome outcome = Sweep(own).run(diagonals); outcome != SweepOutcome::triangulated)
    return outcome;
  triangles.clear();
  triangles.reserve(ring.size() - 2);
  MountainClipper clipper(own, triangles);
  const bool done = for_each_piece(own.size(), diagonals,
                                   [&](const std::vector<Vertex>& piece) { return clipper.clip(piece); });
  if (!done || triangles.size() != ring.size() - 2) return SweepOutcome::undecided;
  for (auto& triangle : triangles)
    for (std::uint32_t& v : triangle)
      v = ring[v];
  return SweepOutcome::triangulated;
}

} // namespace masu
