// A k-d tree of points in a plane, with removal of points and queries by triangle.
#pragma once

#include "libscene/geometry/orientation.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace masu {

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
  std::size_t visit(const std::array<Point2, 3>& triangle, double slack, Visit visit) const {
    if (nodes_.empty()) return 0;
    const auto [low, high] = box_of(triangle, slack);
    std::array<std::size_t, 64> pending{};
    std::size_t count = 1, visited = 0;
    while (count > 0) {
      ++visited;
      const std::size_t index = pending[--count];
      const Node& node = nodes_[index];
      if (node.alive == 0 || node.max.x < low.x || node.min.x > high.x || node.max.y < low.y ||
          node.min.y > high.y)
        continue;
      if (is_outside(node, triangle, slack)) continue;
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

  static std::pair<Point2, Point2> box_of(const std::array<Point2, 3>& triangle, double slack) {
    const auto [a, b, c] = triangle;
    const Point2 low{min(a.x, min(b.x, c.x)), min(a.y, min(b.y, c.y))};
    const Point2 high{max(a.x, max(b.x, c.x)), max(a.y, max(b.y, c.y))};
    const double margin = slack * max(high.x - low.x, high.y - low.y);
    return {{low.x - margin, low.y - margin}, {high.x + margin, high.y + margin}};
  }

  // Whether the node's box is outside an edge, tested at the box's corner farthest inside.
  static bool is_outside(const Node& node, const std::array<Point2, 3>& triangle, double slack) {
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

} // namespace masu
