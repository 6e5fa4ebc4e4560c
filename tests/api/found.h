// All that queries of the C interface find for rays.
#pragma once

#include <masu/masu.hpp>

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#define ASSERT_DONE(call) ASSERT_EQ(call, MASU_OK) << masu_error()

// What the exception says that act() must throw, of that status.
template <class Act>
std::string refused(const Act& act, masu_status status = MASU_ERROR_USAGE) {
  try {
    act();
  } catch (const masu::Exception& error) {
    EXPECT_EQ(error.status, status) << error.what();
    return error.what();
  }
  ADD_FAILURE() << "was done";
  return {};
}

// In arrays of that kind, which are made of a count and have data().
template <template <class...> class Array>
struct FoundIn {
  Array<float> t, uv, normal, shading;
  Array<std::uint64_t> position; // the bits: NaN is itself
  Array<std::uint32_t> primitive, object, face;
  Array<std::uint8_t> occluded;

  explicit FoundIn(std::size_t n)
      : t(n), uv(2 * n), normal(3 * n), shading(3 * n), position(3 * n), primitive(n), object(n), face(n),
        occluded(n) {}

  masu_hits hits() {
    return {sizeof(masu_hits), t.data(),
            primitive.data(),  object.data(),
            uv.data(),         normal.data(),
            face.data(),       nullptr,
            nullptr,           reinterpret_cast<double*>(position.data()),
            shading.data()};
  }
  void find(const masu_tracer* tracer, const void* rays, std::size_t n, const masu_query& query) {
    const masu_hits to = hits();
    EXPECT_EQ(masu_nearest(tracer, rays, n, &query, &to), MASU_OK) << masu_error();
    EXPECT_EQ(masu_occluded(tracer, rays, n, &query, occluded.data()), MASU_OK) << masu_error();
  }
  bool operator==(const FoundIn&) const = default;
};
using Found = FoundIn<std::vector>;

inline void expect_same(const Found& a, const Found& b) {
  EXPECT_EQ(a.t, b.t);
  EXPECT_EQ(a.uv, b.uv);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.shading, b.shading);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.primitive, b.primitive);
  EXPECT_EQ(a.object, b.object);
  EXPECT_EQ(a.face, b.face);
  EXPECT_EQ(a.occluded, b.occluded);
}

inline Found found_by(const masu_tracer* tracer, const void* rays, std::size_t count,
                      const masu_query& query = masu::sized<masu_query>()) {
  Found found(count);
  found.find(tracer, rays, count, query);
  return found;
}
inline Found found_by(const masu_tracer* tracer, const std::vector<masu_ray>& rays,
                      const masu_query& query = masu::sized<masu_query>()) {
  return found_by(tracer, rays.data(), rays.size(), query);
}
inline Found found_by(const masu::Tracer& tracer, const std::vector<masu_ray>& rays,
                      const masu_query& query = masu::sized<masu_query>()) {
  return found_by(tracer.get(), rays, query);
}
