#include "tools/lists/ray_list.h"

#include "libscene/base/error.h"
#include "libscene/base/stopwatch.h"
#include "renderer/automatic_loop.h"
#include "tools/common/repeated.h"
#include "tools/jobs/run_tasks.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <future>
#include <memory>
#include <mutex>
#include <optional>

namespace masu {
namespace {

constexpr std::size_t rays_a_chunk = std::size_t{1} << 20;
constexpr std::size_t rays_a_task = 1 << 14;

// --- A chunk of the list -----------------------------------------------------------------------------------

struct Chunk {
  std::uint64_t task = 0, first = 0; // first: ray's index in the list
  std::vector<std::uint8_t> rays;
  std::size_t count = 0;
  std::uint64_t file_bytes = 0; // that they were read from
  std::vector<float> t, uv, normal;
  std::vector<std::uint32_t> object, primitive, face;
  std::vector<std::uint8_t> occluded;
  TaskTotals totals;

  RayResults results(const std::vector<HitField>& fields) {
    RayResults results;
    const auto room = [&](auto& array, std::size_t numbers) {
      array.resize(count * numbers);
      return array.data();
    };
    for (const HitField field : fields) {
      switch (field) {
      case HitField::t:
        results.t = room(t, 1);
        break;
      case HitField::object:
        results.object = room(object, 1);
        break;
      case HitField::primitive:
        results.primitive = room(primitive, 1);
        break;
      case HitField::face:
        results.face = room(face, 1);
        break;
      case HitField::uv:
        results.uv = reinterpret_cast<float(*)[2]>(room(uv, 2));
        break;
      case HitField::normal:
        results.normal = reinterpret_cast<float(*)[3]>(room(normal, 3));
        break;
      case HitField::occluded:
        results.occluded = room(occluded, 1);
        break;
      }
    }
    return results;
  }

  const void* array(HitField field) const {
    switch (field) {
    case HitField::t:
      return t.data();
    case HitField::object:
      return object.data();
    case HitField::primitive:
      return primitive.data();
    case HitField::face:
      return face.data();
    case HitField::uv:
      return uv.data();
    case HitField::normal:
      return normal.data();
    case HitField::occluded:
      return occluded.data();
    }
    return nullptr;
  }

  // A record a ray.
  std::vector<std::uint8_t> records(const std::vector<HitField>& fields) const {
    const std::vector<RecordField> layout = record_fields(fields);
    std::size_t record_bytes = 0;
    for (const RecordField& field : layout)
      record_bytes += field.bytes;
    std::vector<std::uint8_t> records(count * record_bytes);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, rays_a_task), [&](const auto& range) {
      std::size_t offset = 0;
      for (std::size_t k = 0; k < fields.size(); ++k) {
        const std::size_t bytes = layout[k].bytes;
        const auto* const from = static_cast<const std::uint8_t*>(array(fields[k]));
        for (std::size_t i = range.begin(); i != range.end(); ++i)
          std::memcpy(records.data() + i * record_bytes + offset, from + i * bytes, bytes);
        offset += bytes;
      }
    });
    return records;
  }
};

// In the numbers of the arithmetic that traces them.
template <class Real>
std::uint64_t invalid_rays(const RayList& rays) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, rays.count, rays_a_task), std::uint64_t{0},
      [&](const auto& range, std::uint64_t sum) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) {
          const Ray<Real> ray = loaded<Real>(rays.rays, rays.format, i);
          sum += is_valid(ray) && !std::isnan(ray.t_min) && !std::isnan(ray.t_max) ? 0 : 1;
        }
        return sum;
      },
      std::plus<>());
}

// --- Tasks -------------------------------------------------------------------------------------------------

// The chunks of a list, each of which is read while those before it are traced: all in their order, or those
// of the tasks that this process takes.
class ChunkReader {
public:
  // tasks: null where nobody else takes any.
  ChunkReader(RayFile& file, TaskList* tasks) : file_(file), tasks_(tasks) {}

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
    RaysRead read;
    if (tasks_ != nullptr) {
      const auto task = tasks_->next();
      if (!task) return chunk;
      chunk->task = *task;
      chunk->first = *task * rays_a_chunk;
      read = file_.chunk(*task);
    } else {
      chunk->first = read_;
      read = file_.next(rays_a_chunk);
    }
    chunk->rays = std::move(read.rays);
    chunk->file_bytes = read.bytes;
    chunk->count = chunk->rays.size() / file_.format().bytes_per_ray();
    read_ += chunk->count;
    return chunk;
  }

  RayFile& file_;
  TaskList* tasks_;
  std::uint64_t read_ = 0;
  bool ended_ = false;
  std::mutex mutex_;
  std::future<std::shared_ptr<Chunk>> coming_;
};

// Collective: finds out where the chunks of a list begin, which ranks take in any order.
void find_chunks(RayFile& file, Ranks& ranks) {
  std::string chunks = ranks.rank() == 0 ? file.chunks(rays_a_chunk) : std::string();
  ranks.broadcast(chunks);
  file.set_chunks(rays_a_chunk, chunks);
}

TaskListOf task_list_of(const RayListJob& job, RayFile& file, const HitFormat& hits, const Sharing& sharing) {
  if (!sharing.in_parts()) return {};
  find_chunks(file, sharing.ranks);
  TaskListOf tasks{fmt::format("{}\n{}\nrays {} {} {}", job.description, job.hits, file.is_text(),
                               file.format().is_float64, file.format().numbers),
                   job.hits, (file.all_rays() + rays_a_chunk - 1) / rays_a_chunk};
  const std::string partial = job.hits.empty() ? std::string() : partial_name(job.hits);
  tasks.writes = [&file, &hits, partial](std::uint64_t task) {
    std::vector<FileRange> ranges;
    if (!partial.empty()) ranges.push_back(hits.range(partial, task, task * rays_a_chunk, file.all_rays()));
    return ranges;
  };
  if (!sharing.resume) return tasks;
  std::string hash = sharing.ranks.rank() == 0 ? whole_file(job.rays).hash : std::string();
  sharing.ranks.broadcast(hash);
  tasks.description += "\n" + hash;
  return tasks;
}

// Tracing and writing of chunks, in any order and at the same time.
class ListTracer {
public:
  ListTracer(const Tracer& tracer, const RayListJob& job, const Sharing& sharing,
             const std::function<void(double)>& progress)
      : tracer_(tracer), job_(job), sharing_(sharing), progress_(progress),
        in_double_(resolved(job.request.tracing.precision, tracer.scene()) == Precision::doubled),
        format_(job.hits, record_fields(job.fields)), file_(job.rays, job.format),
        tasks_(sharing, task_list_of(job, file_, format_, sharing)),
        chunks_(file_, sharing.in_parts() ? &tasks_ : nullptr) {
    if (!job.hits.empty() && !sharing.in_parts()) hits_.emplace(format_, job.hits, file_.count());
  }

  // Besides those that a GPU has: one is written, one is about to be.
  std::size_t chunks_under_way() const {
    const std::size_t bytes = rays_a_chunk * (file_.format().bytes_per_ray() + 2 * format_.record_bytes()),
                      queries =
                          tracer_.device() == Device::cuda ? queries_per_gpu * tracer_.device_count() : 1;
    return std::min(tasks_under_way(tracer_, bytes), queries + 2);
  }

  // The next chunk, traced; or nothing.
  std::shared_ptr<Chunk> trace(std::size_t device) {
    std::shared_ptr<Chunk> chunk = chunks_.next();
    if (!chunk) return {};
    const RayList rays(chunk->rays.data(), chunk->count, file_.format());
    const RayResults results = chunk->results(job_.fields);
    RaysRequest request = job_.request;
    request.loop = loop_for(rays);
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
    std::vector<FileRange> written;
    if (hits_)
      hits_->write(chunk.first, chunk.records(job_.fields));
    else if (!job_.hits.empty())
      written.push_back(
          write_part(partial_name(job_.hits),
                     format_.part(chunk.task, chunk.first, chunk.records(job_.fields), file_.all_rays())));
    const double share = sharing_.in_parts() ? tasks_.finish(chunk.task, written, chunk.totals) : 0;
    const std::lock_guard lock(mutex_);
    report_.write_seconds += watch.seconds();
    if (sharing_.in_parts()) return progress_(share);
    report_.totals += chunk.totals;
    bytes_done_ += chunk.file_bytes;
    if (file_.bytes() > 0) progress_(static_cast<double>(bytes_done_) / static_cast<double>(file_.bytes()));
  }

  // By any thread: trace() doesn't wait for the next rays of a pipe any longer, and finds none.
  void cancel() { file_.cancel(); }

  // Collective: when all tasks are done.
  TracingReport finish() {
    const Stopwatch watch;
    if (sharing_.in_parts()) {
      finish_parts();
    } else if (hits_) {
      hits_->commit(report_.totals.rays); // now that their number is known
    }
    report_.write_seconds += watch.seconds();
    sum_up(sharing_.ranks, report_);
    return report_;
  }

private:
  // Found out by the first chunk that is traced.
  RayLoop loop_for(const RayList& rays) {
    std::call_once(loop_found_, [&] {
      if (tracer_.device() == Device::cuda && tracer_.grid() != nullptr)
        loop_ = automatic_loop(tracer_, rays, job_.request.query, job_.request.tracing.precision);
    });
    return loop_;
  }

  void finish_parts() {
    Ranks& ranks = sharing_.ranks;
    report_.totals = tasks_.totals();
    ranks.wait_for_all([&] { progress_(tasks_.share()); });
    if (ranks.rank() == 0) {
      if (!job_.hits.empty()) {
        std::vector<std::uint64_t> firsts;
        for (std::uint64_t first = 0; first < file_.all_rays(); first += rays_a_chunk)
          firsts.push_back(first);
        format_.finish(firsts, file_.all_rays());
        if (format_.is_text()) std::filesystem::remove(partial_name(job_.hits));
      }
      tasks_.remove_journals();
    }
    ranks.wait_for_all();
  }

  const Tracer& tracer_;
  const RayListJob& job_;
  const Sharing& sharing_;
  const std::function<void(double)>& progress_;
  bool in_double_;
  HitFormat format_;
  RayFile file_;
  TaskList tasks_;
  ChunkReader chunks_;
  std::optional<HitFile> hits_;
  std::once_flag loop_found_;
  RayLoop loop_ = RayLoop::warp_refill;
  std::mutex mutex_; // of what follows
  TracingReport report_;
  std::uint64_t bytes_done_ = 0;
};

} // namespace

TracingReport trace_ray_list(const Tracer& tracer, const RayListJob& job, const Sharing& sharing,
                             const std::function<void(double)>& progress) {
  const Stopwatch elapsed;
  ListTracer tracing(tracer, job, sharing, progress);
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
