// Boxes whose planes lie side by side: min and max of all axes take an instruction. Host only.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace masu {

// x, y, z, and a lane that boxes ignore.
using Lanes4 = float __attribute__((vector_size(16)));
using WholeLanes4 = std::int32_t __attribute__((vector_size(16)));
using Lanes8 = float __attribute__((vector_size(32)));
using WholeLanes8 = std::int32_t __attribute__((vector_size(32)));
using BitLanes8 = std::uint32_t __attribute__((vector_size(32)));

inline Lanes4 smaller(Lanes4 a, Lanes4 b) {
  return a < b ? a : b;
}
inline Lanes4 larger(Lanes4 a, Lanes4 b) {
  return a > b ? a : b;
}

struct LaneBox {
  Lanes4 low = {INFINITY, INFINITY, INFINITY, INFINITY};
  Lanes4 high = {-INFINITY, -INFINITY, -INFINITY, -INFINITY};

  void join(const LaneBox& other) {
    low = smaller(low, other.low);
    high = larger(high, other.high);
  }
  Lanes4 twice_the_centre() const { return low + high; }
  // Half of the surface: what SAH compares.
  float area() const {
    const Lanes4 side = high - low;
    return side[0] * (side[1] + side[2]) + side[1] * side[2];
  }
};

// Boxes joined, and numbers of what begins and ends with them: upper planes are negated, so that it takes one
// minimum to join another box, and the numbers are in the lanes that planes leave.
struct CountedBox {
  Lanes8 planes = {INFINITY, INFINITY, INFINITY, 0, INFINITY, INFINITY, INFINITY, 0};

  CountedBox() = default;
  // The numbers are in all lanes.
  explicit CountedBox(const LaneBox& box, WholeLanes4 begin = WholeLanes4{},
                      WholeLanes4 end = WholeLanes4{}) {
    set(__builtin_shufflevector(box.low, -box.high, 0, 1, 2, 3, 4, 5, 6, 7),
        __builtin_shufflevector(begin, end, 0, 1, 2, 3, 4, 5, 6, 7));
  }
  void join(const CountedBox& other) {
    // Of all lanes: without a sign, for the sums of planes mean nothing.
    set(planes < other.planes ? planes : other.planes,
        reinterpret_cast<WholeLanes8>(reinterpret_cast<BitLanes8>(planes) +
                                      reinterpret_cast<BitLanes8>(other.planes)));
  }
  LaneBox box() const {
    return {__builtin_shufflevector(planes, planes, 0, 1, 2, 3),
            -__builtin_shufflevector(planes, planes, 4, 5, 6, 7)};
  }

private:
  void set(const Lanes8& boxes, const WholeLanes8& numbers) {
    planes = __builtin_shufflevector(boxes, reinterpret_cast<Lanes8>(numbers), 0, 1, 2, 11, 4, 5, 6, 15);
  }
};

// A counted box in each lane.
struct CountedLanes {
  Lanes8 planes[3]; // the upper ones come after the lower ones, negated
  WholeLanes8 numbers{};

  CountedLanes() { std::fill_n(planes, 3, Lanes8{} + INFINITY); }
  // Of three; what is in the last lanes is ignored.
  CountedLanes(const CountedBox& a, const CountedBox& b, const CountedBox& c) {
    const auto first = __builtin_shufflevector(a.planes, b.planes, 0, 8, 1, 9, 4, 12, 5, 13),
               last = __builtin_shufflevector(a.planes, b.planes, 2, 10, 3, 11, 6, 14, 7, 15);
    planes[0] = __builtin_shufflevector(first, c.planes, 0, 1, 8, 8, 4, 5, 12, 12);
    planes[1] = __builtin_shufflevector(first, c.planes, 2, 3, 9, 9, 6, 7, 13, 13);
    planes[2] = __builtin_shufflevector(last, c.planes, 0, 1, 10, 10, 4, 5, 14, 14);
    numbers =
        reinterpret_cast<WholeLanes8>(__builtin_shufflevector(last, c.planes, 2, 3, 11, 11, 6, 7, 15, 15));
  }
  void join(const CountedLanes& other) {
    for (int axis = 0; axis < 3; ++axis)
      planes[axis] = planes[axis] < other.planes[axis] ? planes[axis] : other.planes[axis];
    numbers += other.numbers;
  }
  WholeLanes4 begin() const { return __builtin_shufflevector(numbers, numbers, 0, 1, 2, 3); }
  WholeLanes4 end() const { return __builtin_shufflevector(numbers, numbers, 4, 5, 6, 7); }
  Lanes4 low(int axis) const { return __builtin_shufflevector(planes[axis], planes[axis], 0, 1, 2, 3); }
  Lanes4 high(int axis) const { return -__builtin_shufflevector(planes[axis], planes[axis], 4, 5, 6, 7); }
  Lanes4 areas() const {
    const Lanes4 x = high(0) - low(0), y = high(1) - low(1), z = high(2) - low(2);
    return x * (y + z) + y * z;
  }
  // The same; 0 of a box that holds nothing.
  Lanes4 areas_or_0() const {
    return (low(0) <= high(0)) & (low(1) <= high(1)) & (low(2) <= high(2)) ? areas() : Lanes4{};
  }
};

} // namespace masu
