// Hits of placed meshes are those of the 113-bit oracle, to which their vertices are given written out: far
// away, tiny, of all scales, stretched and mirrored.
#include "stability/placed_hits.h"

#include "libscene/file/scene_file.h"
#include "stability/run.h"
#include "tests/random_test.h"
#include "tests/temporary_folder.h"

namespace masu::stability {
namespace {

using PlacedOracle = RandomTest;

template <class Stored>
void expect_right(const SceneView<Stored>& scene, const Boxd& bounds, const PlacedHits& hits,
                  const PlacedHits::Hits& found, Precision precision, Tally& total) {
  if (found.t.empty()) return;
  std::vector<Ray<double>> rays;
  std::vector<Found> one;
  for (std::size_t i = 0; i < hits.rays.size(); ++i) {
    const auto& [x, y, z, dx, dy, dz] = hits.rays[i];
    rays.push_back(unbounded_ray(Vec3d{x, y, z}, Vec3d{dx, dy, dz}));
    one.push_back({found.t[i], found.primitive[i], true});
  }
  const Tally tally = judged(oracle::SceneOracle(scene), rays, slack_for(precision, bounds),
                             unit_roundoff_of(precision), std::span(&one, 1))
                          .front();
  EXPECT_EQ(tally.failures(), 0U) << "of " << tally.rays << " rays " << tally.missed << " missed, "
                                  << tally.false_hit << " false, " << tally.wrong << " wrong, "
                                  << tally.misplaced << " misplaced; precision "
                                  << static_cast<int>(precision);
  total += tally;
}

TEST_F(PlacedOracle, HitsAreThoseOfExactArithmetic) {
  const TemporaryFolder folder;
  std::mt19937_64 engine = seed_.engine();
  Tally total;
  for (std::size_t kind = 0; kind < placed_kind_count(); ++kind) {
    SCOPED_TRACE(kind);
    const std::string path = folder.file("written.scene");
    const PlacedHits hits = placed_hits(kind, engine, static_cast<std::size_t>(cases(60)), path);
    const SceneFile file(path);
    file.with_view([&](const auto& scene) {
      expect_right(scene, file.bounds(), hits, hits.robust, Precision::robust, total);
      expect_right(scene, file.bounds(), hits, hits.double_precision, Precision::doubled, total);
    });
  }
  EXPECT_LT(2 * total.unsure, total.rays); // otherwise the checks would say little
}

} // namespace
} // namespace masu::stability
