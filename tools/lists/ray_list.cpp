#include "tools/lists/ray_list.h"

#include "libscene/base/error.h"
#include "libscene/base/parallel.h"
#include "libscene/base/stopwatch.h"
#include "libscene/file/input_file.h"
#include "renderer/rays/automatic_loop.h"
#include "tools/common/progress.h"
#include "tools/common/repeated.h"
#include "tools/jobs/run_tasks.h"
#include "tools/lists/npy.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <future>
#include <memory>
#include <mutex>
#include <optional>

namespace masu {
namespace {

constexpr std::size_t rays_per_task = 1 << 14;

// --- A chunk of the list -----------------------------------------------------------------------------------

struct Chunk {
  std::uint64_t index = 0;
  std::vector<std::uint8_t> rays;
  std::vector<PrimitiveIndex> excluded;
  std::size_t count = 0;
  std::uint64_t file_bytes = 0;                   // that they were read from
  std::vector<std::vector<std::uint8_t>> results; // an array for each field
  TaskTotals totals;

  RayResults make_room(const std::vector<HitField>& fields, std::uint32_t row) {
    for (const HitField field : fields)
      results.emplace_back(count * bytes_of(field, row));
    const auto array = [&](HitField field) -> void* {
      const auto found = static_cast<std::size_t>(std::ranges::find(fields, field) - fields.begin());
      return found < fields.size() ? results[found].data() : nullptr;
    };
    RayResults room;
    room.t = static_cast<float*>(array(HitField::t));
    room.t64 = static_cast<double*>(array(HitField::t64));
    room.object = static_cast<std::uint32_t*>(array(HitField::object));
    room.primitive = static_cast<std::uint32_t*>(array(HitField::primitive));
    room.face = static_cast<std::uint32_t*>(array(HitField::face));
    room.uv = static_cast<float(*)[2]>(array(HitField::uv));
    room.normal = static_cast<float(*)[3]>(array(HitField::normal));
    room.front = static_cast<std::uint8_t*>(array(HitField::front));
    room.count = static_cast<std::uint32_t*>(array(HitField::count));
    room.inside = static_cast<std::uint8_t*>(array(HitField::inside));
    room.occluded = static_cast<std::uint8_t*>(array(HitField::occluded));
    return room;
  }

  // A record for each ray.
  std::vector<std::uint8_t> records(std::size_t record_bytes) const {
    std::vector<std::uint8_t> records(count * record_bytes);
    parallel_ranges(count, rays_per_task, [&](std::size_t begin, std::size_t end) {
      std::size_t offset = 0;
      for (const std::vector<std::uint8_t>& array : results) {
        const std::size_t bytes = array.size() / count;
        for (std::size_t i = begin; i != end; ++i)
          std::memcpy(records.data() + i * record_bytes + offset, array.data() + i * bytes, bytes);
        offset += bytes;
      }
    });
    return records;
  }
};

// In the numbers of the arithmetic that traces them.
template <class Real>
std::uint64_t invalid_rays(const RayList& rays) {
  return parallel_reduce(
      rays.count, rays_per_task, std::uint64_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::uint64_t sum = 0;
        for (std::size_t i = begin; i != end; ++i) {
          const Ray<Real> ray = loaded<Real>(rays.rays, rays.format, i);
          sum += is_valid(ray) && !std::isnan(ray.t_min) && !std::isnan(ray.t_max) ? 0 : 1;
        }
        return sum;
      },
      std::plus<>());
}

// --- Chunks ------------------------------------------------------------------------------------------------

std::size_t rays_per_chunk(const RayListJob& job) {
  return (std::size_t{1} << 20) / hit_rules(job.request).row();
}
std::uint64_t chunks_of(std::uint64_t rays, std::size_t each) {
  return (rays + each - 1) / each;
}
// Hits per ray that a record has a dimension for.
std::uint32_t row_of(const RayListJob& job) {
  return job.request.query == Query::all_hits ? job.request.limit : 0;
}

// The chunks of a list, each of which is read while those before it are traced: all in their order, or those
// that this one of several ranks takes.
class ChunkReader {
public:
  ChunkReader(RayFile& file, std::size_t rays_per_chunk, Ranks& ranks)
      : file_(file), rays_per_chunk_(rays_per_chunk), ranks_(ranks) {}

  // Nothing after the last one. For threads at the same time.
  std::shared_ptr<Chunk> next() {
    const std::lock_guard lock(mutex_);
    if (ended_) return {};
    const auto begin = [this] { return std::async(std::launch::async, [this] { return read(); }); };
    if (!coming_.valid()) coming_ = begin();
    std::shared_ptr<Chunk> chunk = coming_.get();
    ended_ = chunk->count == 0;
    if (ended_) return {};
    coming_ = begin();
    return chunk;
  }

private:
  // Without rays after the last one.
  std::shared_ptr<Chunk> read() {
    auto chunk = std::make_shared<Chunk>();
    chunk->index = ranks_.next();
    const bool is_shared = ranks_.count() > 1;
    if (is_shared && chunk->index >= chunks_of(file_.all_rays(), rays_per_chunk_)) return chunk;
    RaysRead read = is_shared ? file_.chunk(chunk->index) : file_.next(rays_per_chunk_);
    chunk->rays = std::move(read.rays);
    chunk->file_bytes = read.bytes;
    chunk->count = chunk->rays.size() / file_.format().bytes_per_ray();
    return chunk;
  }

  RayFile& file_;
  std::size_t rays_per_chunk_;
  Ranks& ranks_;
  bool ended_ = false;
  std::mutex mutex_;
  std::future<std::shared_ptr<Chunk>> coming_;
};

// An int32 for each ray of a list, -1 for none: the numbers alone, or a NumPy array of shape (N,).
class ExcludedFile {
public:
  // `rays`: of the list, where that is known. Throws Error(input) for what isn't such a file, or of another
  // number of rays.
  ExcludedFile(const std::string& path, std::optional<std::uint64_t> rays) : file_(path) {
    const auto fail = [&](const std::string& what) { throw Error(ErrorCode::input, path, what); };
    std::uint64_t bytes = file_.size();
    const auto is_read = [&](void* to, std::size_t count) {
      if (count > file_.size() - first_byte_) return false;
      file_.read(first_byte_, {static_cast<std::uint8_t*>(to), count});
      first_byte_ += count;
      return true;
    };
    std::string start(npy_magic.size(), ' ');
    const bool is_npy = is_read(start.data(), start.size()) && start == npy_magic;
    first_byte_ = 0;
    if (is_npy) {
      const std::optional<NpyArray> array = read_npy_head(is_read);
      if (!array || (array->type != "<i4" && array->type != "<u4") || array->shape.size() != 1)
        fail("isn't a NumPy array of int32 of shape (N,)");
      bytes -= first_byte_;
      if (array->shape[0] != bytes / sizeof(PrimitiveIndex)) fail("isn't as long as its header says");
    } else if (path.ends_with(".npy")) {
      fail("isn't a NumPy array");
    }
    if (bytes % sizeof(PrimitiveIndex) != 0) fail("isn't a whole number of int32 numbers");
    count_ = bytes / sizeof(PrimitiveIndex);
    if (rays && *rays != count_) fail(fmt::format("holds {} primitives for {} rays", count_, *rays));
  }

  // Of `count` rays from `first` on. Throws Error(input) where the file has no more. For threads at the same
  // time.
  std::vector<PrimitiveIndex> of_rays(std::uint64_t first, std::size_t count) const {
    if (first > count_ || count > count_ - first)
      throw Error(ErrorCode::input, file_.path(),
                  fmt::format("holds {} primitives, fewer than rays", count_));
    std::vector<PrimitiveIndex> excluded(count);
    file_.read(first_byte_ + first * sizeof(PrimitiveIndex),
               {reinterpret_cast<std::uint8_t*>(excluded.data()), count * sizeof(PrimitiveIndex)});
    return excluded;
  }

private:
  InputFile file_;
  std::uint64_t first_byte_ = 0, count_ = 0;
};

// Tracing and writing of chunks, in any order and at the same time.
class ListTracer {
public:
  // Collective.
  ListTracer(const ResidentTracer& tracer, const RayListJob& job, Ranks& ranks, bool quiet)
      : tracer_(tracer), job_(job), ranks_(ranks), progress_("tracing", quiet),
        in_double_(resolved(job.request.tracing.precision, tracer.scene()) == Precision::doubled),
        format_(job.hits, job.fields, row_of(job)), file_(job.rays, job.format),
        chunks_(file_, rays_per_chunk(job), ranks) {
    report_.files = job.hits.empty() ? 0 : 1;
    if (job.resume == Resume::all) find_kept();
    if (report_.kept > 0) return;
    if (ranks.count() > 1) file_.find_chunks(rays_per_chunk(job), ranks);
    if (!job.excluded.empty()) excluded_.emplace(job.excluded, file_.count());
    if (!job.hits.empty()) open_hits();
  }

  bool is_kept() const { return report_.kept > 0; }

  // Besides those that a GPU has: one is written, one is about to be.
  std::size_t chunks_under_way() const {
    const std::size_t bytes = rays_per_chunk(job_) *
                              (file_.format().bytes_per_ray() + 2 * format_.record_bytes()),
                      queries =
                          tracer_.device() == Device::cuda ? queries_per_gpu * tracer_.device_count() : 1;
    return std::min(tasks_under_way(tracer_, bytes), queries + 2);
  }

  // The next chunk, traced; or nothing.
  std::shared_ptr<Chunk> trace(std::size_t device) {
    std::shared_ptr<Chunk> chunk = chunks_.next();
    if (!chunk) return {};
    RayList rays(chunk->rays.data(), chunk->count, file_.format());
    const RayResults results = chunk->make_room(format_.fields(), row_of(job_));
    if (excluded_) {
      chunk->excluded = excluded_->of_rays(chunk->index * rays_per_chunk(job_), chunk->count);
      rays.filters.excluded = chunk->excluded.data();
    }
    if (!job_.object_masks.empty()) {
      rays.filters.object_masks = job_.object_masks.data();
      rays.filters.object_count = job_.object_masks.size();
    }
    RaysRequest request = job_.request;
    if (!needs_hits_in_order(rays, results, request)) request.loop = loop_for(rays);
    const QueryReport report =
        repeated(0, job_.repeat, [&] { return tracer_.trace(rays, results, request, device); });
    chunk->totals = {chunk->count, in_double_ ? invalid_rays<double>(rays) : invalid_rays<float>(rays),
                     report.counts};
    const std::lock_guard lock(mutex_);
    report_.seconds += report.seconds;
    return chunk;
  }

  void write(const Chunk& chunk) {
    const Stopwatch watch;
    if (!job_.hits.empty()) write_records(chunk.index, chunk.records(format_.record_bytes()));
    const std::uint64_t done = ranks_.add_finished(chunk.file_bytes);
    const std::lock_guard lock(mutex_);
    report_.write_seconds += watch.seconds();
    report_.totals += chunk.totals;
    show_progress(done);
  }

  // By any thread: trace() doesn't wait for the next rays of a pipe any longer, and finds none.
  void cancel() { file_.cancel(); }

  // Collective: when all chunks are written.
  TracingReport finish() {
    const Stopwatch watch;
    if (shared_) {
      if (ranks_.rank() == 0 && file_.all_rays() == 0) write_records(0, {}); // the head alone
      shared_->close();
    }
    ranks_.wait_for_all([this] { show_progress(ranks_.add_finished(0)); });
    if (shared_ && ranks_.rank() == 0) shared_->commit();
    ranks_.wait_for_all();
    if (hits_) {
      const std::string head = format_.head(report_.totals.rays); // now that their number is known
      if (report_.totals.rays == 0) write_records(0, {});         // the head alone
      head == format_.head(file_.count().value_or(0)) ? hits_->commit() : hits_->commit(head);
    }
    report_.write_seconds += watch.seconds();
    sum_up(ranks_, report_);
    return report_;
  }

private:
  // Found out by the first chunk that is traced.
  RayLoop loop_for(const RayList& rays) {
    const std::lock_guard lock(choosing_loop_); // not std::call_once: see render_views.cpp
    if (!loop_)
      loop_ = tracer_.device() == Device::cuda && tracer_.structure() != nullptr
                  ? automatic_loop(tracer_, rays, job_.request.query, job_.request.tracing.precision)
                  : RayLoop::warp_refill;
    return *loop_;
  }

  // Collective: whether the hits are there, by rank 0.
  void find_kept() {
    std::string kept; // k where they are
    if (ranks_.rank() == 0 && masu::is_kept(job_.hits, format_.known_by(file_.count()))) kept = "k";
    ranks_.broadcast(kept);
    report_.kept = kept.size();
  }

  // Collective.
  void open_hits() {
    const std::uint64_t all = ranks_.count() > 1 ? file_.all_rays() : file_.count().value_or(0);
    const std::size_t each = rays_per_chunk(job_);
    PartedForm form = format_.parts(
        chunks_of(all, each), [each](std::uint64_t chunk) { return chunk * each; }, all);
    if (ranks_.count() > 1) {
      shared_.emplace(job_.hits, std::move(form), ranks_);
      return;
    }
    hits_.emplace(job_.hits, std::move(form));
    if (!file_.count() && job_.hits.ends_with(".npy") && !hits_->has_places())
      throw Error(
          ErrorCode::output, job_.hits,
          "is a pipe, where a NumPy array can't begin before the number of rays is known: write .csv, or "
          "records without an ending");
  }

  void show_progress(std::uint64_t bytes_done) {
    if (file_.bytes() > 0) progress_(static_cast<double>(bytes_done) / static_cast<double>(file_.bytes()));
  }

  // As a part of the hits' file.
  void write_records(std::uint64_t part, std::vector<std::uint8_t> records) {
    const std::uint64_t all = shared_ ? file_.all_rays() : file_.count().value_or(0);
    std::vector<std::uint8_t> bytes = format_.part(std::move(records), part * rays_per_chunk(job_), all);
    shared_ ? shared_->write(part, std::move(bytes)) : hits_->write(part, std::move(bytes));
  }

  const ResidentTracer& tracer_;
  const RayListJob& job_;
  Ranks& ranks_;
  Progress progress_;
  bool in_double_;
  HitFormat format_;
  RayFile file_;
  ChunkReader chunks_;
  std::optional<ExcludedFile> excluded_;
  std::optional<PartedFile> hits_;   // where this process writes them alone
  std::optional<SharedFile> shared_; // else
  std::mutex choosing_loop_;
  std::optional<RayLoop> loop_;
  std::mutex mutex_; // of what follows
  TracingReport report_;
};

} // namespace

TracingReport trace_ray_list(const ResidentTracer& tracer, const RayListJob& job, Ranks& ranks, bool quiet) {
  const Stopwatch elapsed;
  ListTracer tracing(tracer, job, ranks, quiet);
  if (tracing.is_kept()) return tracing.finish();
  // A chunk may still be read from a pipe when another one fails.
  const auto ending = [&](const auto& act) {
    try {
      return act();
    } catch (...) {
      tracing.cancel();
      throw;
    }
  };
  run_tasks(
      tracer, tracing.chunks_under_way(),
      [&](std::size_t device) { return ending([&] { return tracing.trace(device); }); },
      [&](const Chunk& chunk) { ending([&] { tracing.write(chunk); }); });
  TracingReport report = tracing.finish();
  report.elapsed_seconds = elapsed.seconds();
  return report;
}

} // namespace masu
