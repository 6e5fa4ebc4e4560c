// Triangles tested several at a time give the bits that each gives alone: in float32 and in float64, for any
// numbers.
#include "libscene/base/portable.h"

#ifdef MASU_HOST_AVX2
#include "libscene/geometry/triangle_lanes.h"
#endif

#include "tests/random_test.h"
#include "tests/stability/same_bits.h"

namespace masu {
namespace {

// Arithmetic, and how triangles are stored.
template <class Real_, class Stored_>
struct ArithmeticAndStore {
  using Real = Real_;
  using Stored = Stored_;
};

template <class Types>
class TrianglesInLanes : public RandomTest {};
using AllTypes = testing::Types<ArithmeticAndStore<float, float>, ArithmeticAndStore<double, float>,
                                ArithmeticAndStore<double, double>>;
TYPED_TEST_SUITE(TrianglesInLanes, AllTypes);

#ifdef MASU_HOST_AVX2

// Few values, so that corners, edges and planes coincide, and rays go through them and along axes; or any.
template <class Real>
Vec3<Real> point(Chance& chance, bool few) {
  const auto number = [&] { return few ? static_cast<double>(chance.whole(-2, 2)) : chance.uniform(-2, 2); };
  return cast<Real>(Vec3d{number(), number(), number()});
}

template <class Real>
WatertightRay<Real> any_ray(Chance& chance, bool few) {
  const Vec3<Real> origin = point<Real>(chance, few), to = point<Real>(chance, few);
  Vec3<Real> direction = to == origin ? Vec3<Real>{1, 0, 0} : to - origin;
  if (direction.x == 0 && chance.one_in(4)) direction.x = Real(-0.0);
  WatertightRay<Real> ray;
  prepare(ray, origin, direction);
  return ray;
}

TYPED_TEST(TrianglesInLanes, GiveTheBitsOfEachAlone) {
  using Real = typename TypeParam::Real;
  using Stored = typename TypeParam::Stored;
  constexpr std::size_t count = Lanes<Real>::count;
  Chance& chance = this->chance_;
  std::int64_t hits = 0;
  for (std::int64_t c = cases(50'000); c > 0 && !this->HasFailure(); --c) {
    const bool few = chance.one_in(2);
    const auto scale = static_cast<Stored>(chance.one_of({1.0, 0x1p-40, 0x1p-62, 0x1p40}));
    Triangle<Stored> triangles[count];
    PrimitiveIndex numbers[count];
    for (Triangle<Stored>& t : triangles) {
      const auto corner = [&] { return point<Stored>(chance, few) * scale; };
      t = {corner(), 0, corner(), 0, corner(), 0};
      if (chance.one_in(8)) t.b = t.a;
      if (chance.one_in(8)) t.c = t.a + (t.b - t.a) * Stored(2);
      if (chance.one_in(200))
        t.b.set(chance.whole(0, 2), chance.one_in(2) ? std::numeric_limits<Stored>::quiet_NaN()
                                                     : std::numeric_limits<Stored>::infinity());
    }
    WatertightRay<Real> each[count];
    const bool same_ray = chance.one_in(2);
    alignas(32) Real of_lanes[3 * 4 + 1][count];
    for (std::size_t i = 0; i < count; ++i) {
      numbers[i] = static_cast<PrimitiveIndex>(chance.index(count));
      each[i] = same_ray && i > 0 ? each[0] : any_ray<Real>(chance, few);
      each[i].origin = each[i].origin * static_cast<Real>(scale);
      const Vec3<Real> vectors[]{each[i].origin, each[i].direction, each[i].across1, each[i].across2};
      for (std::size_t v = 0; v < 4; ++v)
        for (int axis = 0; axis < 3; ++axis)
          of_lanes[3 * v + static_cast<std::size_t>(axis)][i] = vectors[v][axis];
      of_lanes[12][i] = each[i].inverse_square;
    }
    const auto vectors = [&](std::size_t v) {
      const auto numbers_of = [&](std::size_t axis) { return Lanes<Real>::load(of_lanes[3 * v + axis]); };
      return Vec3<Lanes<Real>>{numbers_of(0), numbers_of(1), numbers_of(2)};
    };
    const WatertightRay<Lanes<Real>> rays{
        {vectors(0), vectors(1), Lanes<Real>::load(of_lanes[12])}, vectors(2), vectors(3)};
    Lanes<Real> all = 0;
    const unsigned met = intersect(rays, triangles, numbers, all).bits();
    alignas(32) Real t[count];
    all.store(t);
    for (std::size_t i = 0; i < count; ++i) {
      Real alone = 0;
      const bool is_met = intersect(each[i], triangles[numbers[i]], alone) && alone > 0;
      hits += is_met;
      const Triangle<Stored>& triangle = triangles[numbers[i]];
      EXPECT_EQ(met >> i & 1, is_met ? 1U : 0U)
          << described(each[i].origin, each[i].direction) << described(triangle);
      EXPECT_TRUE(!is_met || stability::same_bits(t[i], alone))
          << described(t[i]) << ", alone " << described(alone);
    }
  }
  EXPECT_GT(hits, cases(10'000));
}

#else

TYPED_TEST(TrianglesInLanes, GiveTheBitsOfEachAlone) {
  GTEST_SKIP() << "built without AVX2: triangles are tested one at a time";
}

#endif

} // namespace
} // namespace masu
