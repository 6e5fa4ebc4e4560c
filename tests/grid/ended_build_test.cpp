// Builds that their progress ends, at any time.
#include "libgrid/structure/chosen_structure.h"
#include "libscene/base/parallel.h"
#include "libscene/base/stopwatch.h"
#include "tests/random_scene.h"
#include "tests/random_test.h"
#include "tests/same_grid.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <thread>

namespace masu {
namespace {

struct Ended {};

template <class Stored>
class EndedBuild : public RandomTest {
protected:
  EndedBuild() { add_triangles(4000); }
  void add_triangles(int count) {
    for (int i = 0; i < count; ++i) {
      const Vec3d at = chance_.in_cube(1);
      const auto near = [&] { return cast<Stored>(at + chance_.in_cube(0.05)); };
      scene_.triangles.push_back(triangle_of(near(), near(), near()));
    }
  }
  Structure built(const BuildOptions& options, const std::function<void(double)>& progress) {
    return build_chosen(*cpu_builder(scene_.view(), progress), {scene_.bounds(), Hash{1, 2}}, options).grid;
  }
  std::vector<BuildOptions> all_options() const {
    std::vector<BuildOptions> all;
    for (const StructureKind kind :
         {StructureKind::uniform, StructureKind::x, StructureKind::balance, StructureKind::irregular,
          StructureKind::hierarchy, StructureKind::automatic, StructureKind::fastest})
      all.emplace_back().structure.kind = kind;
    all.emplace_back().structure = {StructureKind::hierarchy};
    all.back().structure.quality = HierarchyQuality::fast;
    return all;
  }

  TestScene<Stored> scene_;
};
TYPED_TEST_SUITE(EndedBuild, Reals);

TYPED_TEST(EndedBuild, ThrowsWhatItsProgressThrowsAndTheNextIsAsEver) {
  for (const BuildOptions& options : this->all_options()) {
    SCOPED_TRACE(static_cast<int>(options.structure.kind));
    std::atomic<int> reports = 0;
    std::atomic<bool> in_range = true;
    const Structure expected = this->built(options, {});
    expect_same(expected, this->built(options, [&](double done) {
      ++reports;
      if (!(done >= 0 && done <= 1)) in_range = false;
    }));
    EXPECT_TRUE(in_range);
    EXPECT_GT(reports, 20);
    for (int i = 0; i < 8; ++i) {
      std::atomic<int> left = this->chance_.whole(1, reports / 2); // with threads there may be some less
      EXPECT_THROW(static_cast<void>(this->built(options,
                                                 [&](double) {
                                                   if (--left <= 0) throw Ended();
                                                 })),
                   Ended);
    }
    expect_same(expected, this->built(options, {}));
  }
}

TEST(ParallelWork, ThrowsWherePartOfItIsLeftOut) {
  const auto done_of = [](std::size_t tasks) {
    std::atomic<int> done = 0;
    parallel_for(tasks, [&](std::size_t) { ++done; });
    return done.load();
  };
  EXPECT_EQ(done_of(1000), 1000);
  tbb::task_group_context outer;
  tbb::parallel_for(
      0, 1,
      [&](int) {
        EXPECT_EQ(done_of(1000), 1000);
        outer.cancel_group_execution();
        EXPECT_THROW(static_cast<void>(done_of(1000)), Error);
      },
      outer);
}

// So many that threads share nodes, too: what one has ended must not be gone on with by another.
TYPED_TEST(EndedBuild, OfAHierarchyOfManyTrianglesEndsAtAnyMoment) {
  this->add_triangles(250'000);
  const std::thread::id caller = std::this_thread::get_id(); // the others learn of it from TBB alone
  for (const HierarchyQuality quality : {HierarchyQuality::fast, HierarchyQuality::high}) {
    BuildOptions options;
    options.structure = {StructureKind::hierarchy};
    options.structure.quality = quality;
    const Stopwatch watch;
    const Structure expected = this->built(options, {});
    const double whole = watch.seconds();
    int ended = 0;
    for (std::int64_t i = cases(5); i > 0; --i) {
      const double end = watch.seconds() + (ended > 0 ? this->chance_.uniform(0, whole) : 0);
      try {
        this->built(options, [&](double) {
          if (std::this_thread::get_id() == caller && watch.seconds() > end) throw Ended();
        });
      } catch (const Ended&) {
        ++ended;
      }
    }
    EXPECT_GT(ended, 0);
    expect_same(expected, this->built(options, {}));
  }
}

TYPED_TEST(EndedBuild, SharesOfWhatIsDoneRise) {
  for (const BuildOptions& options : this->all_options()) {
    SCOPED_TRACE(static_cast<int>(options.structure.kind));
    made_by_threads(1, [&] {
      double last = 0;
      this->built(options, [&](double done) {
        EXPECT_GE(done, last);
        last = done;
      });
      return last;
    });
  }
}

} // namespace
} // namespace masu
