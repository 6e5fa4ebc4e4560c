#include "libgrid/grid/merge.h"

#include "libgrid/grid/merge_passes.h"
#include "libscene/base/parallel.h"
#include "libscene/passes/host_executor.h"

#include <algorithm>
#include <atomic>

namespace masu {

namespace {

constexpr double parts_share = 0.6; // of an irregular grid's time; the rest is expansion

// Whole rows along x; of few pairs and voxels, but at least a row. With 65536 pairs a part no longer fits a
// cache of 1 MiB, and a build takes a sixth more time. Parts don't depend on the number of threads.
constexpr std::uint64_t max_part_pairs = 4096, max_part_voxels = 65536;
std::vector<VoxelSpan> parts_of(const VoxelSpan& all, const Vec3i& division) {
  std::vector<VoxelSpan> parts;
  VoxelSpan part{0, 0, all.indices, all.primitives, 0};
  while (part.end != all.end) {
    const std::uint64_t end = part.end + static_cast<std::uint64_t>(division.x);
    const std::uint64_t* const pairs_end =
        std::lower_bound(part.indices + part.pairs, all.indices + all.pairs, end);
    const auto pairs = static_cast<std::uint64_t>(pairs_end - part.indices);
    if (part.size() > 0 && (pairs > max_part_pairs || end - part.first > max_part_voxels)) {
      parts.push_back(part);
      part = {part.end, part.end, part.indices + part.pairs, part.primitives + part.pairs, 0};
      continue;
    }
    part.end = end;
    part.pairs = pairs;
  }
  parts.push_back(part);
  return parts;
}

// Where a part's words that its voxels' lead to, its cells and its references begin in the whole.
struct PartBegin {
  std::uint64_t nested, cells, references;
};

void copy_part(const Structure& own, const VoxelSpan& span, const PartBegin& begin, Structure& whole) {
  const std::uint64_t own_nested = rounded_to_unit(span.size());
  const auto first_cell = static_cast<std::uint32_t>(begin.cells),
             first_list = static_cast<std::uint32_t>(begin.references),
             words_before = static_cast<std::uint32_t>(begin.nested - own_nested);
  const auto moved_word = [=](std::uint32_t word) {
    if (word == 0) return word; // fills a unit up
    if ((word & occupied_bit) != 0) return word + first_cell;
    const MapDivision division = map_division(word);
    return map_word({division.offset + words_before, division.log2});
  };
  const auto moved_cell = [=](MergedCell cell) {
    if (cell.list != empty_list) cell.list += first_list;
    return cell;
  };
  const std::uint32_t* const words = own.voxel_map.data();
  std::transform(words, words + span.size(), whole.voxel_map.data() + span.first, moved_word);
  std::transform(words + own_nested, words + own.voxel_map.size(), whole.voxel_map.data() + begin.nested,
                 moved_word);
  std::transform(own.cells.begin(), own.cells.end(), whole.cells.data() + begin.cells, moved_cell);
  std::copy(own.references.begin(), own.references.end(), whole.references.data() + begin.references);
}

} // namespace

// Part by part, each by one thread; a row of very many pairs is shared by all.
template <class BuildPart>
Structure build_in_parts(TbbExecutor& executor, const GridLayout& layout, const VoxelSpan& all,
                         std::uint64_t max_words, const BuildPart& build_part) {
  const std::vector<VoxelSpan> spans = parts_of(all, layout.division);
  std::vector<Structure> parts(spans.size());
  const auto is_large = [&](std::size_t i) { return spans[i].pairs > 16 * max_part_pairs; };
  std::atomic<std::size_t> finished = 0;
  const std::uint64_t top_words = rounded_to_unit(all.size());
  std::atomic<std::uint64_t> words =
      top_words; // of the parts so far: if too many, the others needn't be built
  const auto too_many = [&] { return exceeded_by_sizes(0, 0, top_words, words, max_words); };
  parallel_for(spans.size(), [&](std::size_t i) {
    SerialExecutor serial{executor.progress};
    if (too_many() != nullptr) return;
    if (!is_large(i)) {
      parts[i] = build_part(serial, spans[i]);
      words +=
          parts[i].voxel_map.size() - std::min(parts[i].voxel_map.size(), rounded_to_unit(spans[i].size()));
    }
    if (executor.progress != nullptr)
      (*executor.progress)(parts_share * static_cast<double>(++finished) / static_cast<double>(spans.size()));
  });
  Structure whole{layout};
  if ((whole.exceeded = too_many()) != nullptr) return whole;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (is_large(i)) parts[i] = build_part(executor, spans[i]);
  }

  whole.kind = parts[0].kind;
  whole.nested_log2 = parts[0].nested_log2;
  PartBegin end{top_words, 0, 0};
  std::vector<PartBegin> begins;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if ((whole.exceeded = parts[i].exceeded) != nullptr) return whole;
    const Structure& part = parts[i];
    begins.push_back(end);
    end.nested += part.voxel_map.size() - rounded_to_unit(spans[i].size());
    end.cells += part.cells.size();
    end.references += part.references.size();
  }
  if ((whole.exceeded = exceeded_by_sizes(end.cells, end.references, top_words, end.nested, max_words)) !=
      nullptr)
    return whole;
  whole.voxel_map.resize(end.nested);
  std::fill(whole.voxel_map.data() + all.size(), whole.voxel_map.data() + top_words, 0U);
  whole.cells.resize(end.cells);
  whole.references.resize(end.references);
  parallel_for(parts.size(), [&](std::size_t i) {
    copy_part(parts[i], spans[i], begins[i], whole);
    parts[i] = {};
  });
  return whole;
}

template <class Stored>
Structure merged_grid(const SceneView<Stored>& scene, const GridLayout& layout, Overlap overlap,
                      const StructureOptions& options, ProgressMonitor* progress) {
  TbbExecutor executor{progress};
  return merged_grid(executor, scene, layout, overlap, options);
}
template Structure merged_grid(const SceneView<float>&, const GridLayout&, Overlap, const StructureOptions&,
                               ProgressMonitor*);
template Structure merged_grid(const SceneView<double>&, const GridLayout&, Overlap, const StructureOptions&,
                               ProgressMonitor*);

} // namespace masu
