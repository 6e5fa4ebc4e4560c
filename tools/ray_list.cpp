#include "tools/ray_list.h"

#include "libscene/error.h"
#include "libscene/file/container.h"
#include "libscene/file/input_file.h"
#include "libscene/stopwatch.h"
#include "renderer/automatic_loop.h"
#include "tools/npy.h"
#include "tools/placed_file.h"
#include "tools/repeated.h"
#include "tools/run_tasks.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <future>
#include <memory>
#include <mutex>
#include <optional>

namespace masu {
namespace {

constexpr std::size_t rays_a_chunk = std::size_t{1} << 20;
constexpr std::size_t rays_a_task = 1 << 14;

struct FieldFormat {
  const char* name;
  HitField field;
  const char* type; // as NumPy has it
  std::size_t bytes;
};
constexpr FieldFormat field_formats[] = {
    {"t", HitField::t, "'<f4'", 4},
    {"object", HitField::object, "'<i4'", 4},
    {"primitive", HitField::primitive, "'<i4'", 4},
    {"face", HitField::face, "'<i4'", 4},
    {"uv", HitField::uv, "'<f4', (2,)", 8},
    {"normal", HitField::normal, "'<f4', (3,)", 12},
    {"occluded", HitField::occluded, "'|u1'", 1},
};

const FieldFormat& format_of(HitField field) {
  return *std::ranges::find(field_formats, field, &FieldFormat::field);
}

std::size_t record_bytes_of(const std::vector<HitField>& fields) {
  std::size_t bytes = 0;
  for (const HitField field : fields)
    bytes += format_of(field).bytes;
  return bytes;
}

// --- Reading -----------------------------------------------------------------------------------------------

class RayReader {
public:
  RayReader(const std::string& path, const RayFormat& format)
      : name_(path == "-" ? "standard input" : path), format_(format),
        file_(path == "-" ? stdin : std::fopen(path.c_str(), "rb")) {
    if (!file_) fail(std::strerror(errno));
    start_.resize(npy_magic.size());
    start_.resize(read(start_.data(), start_.size()));
    if (std::equal(start_.begin(), start_.end(), npy_magic.begin(), npy_magic.end())) {
      start_.clear();
      read_npy_header();
    }
  }

  const RayFormat& format() const { return format_; }
  // Of a regular file; 0 where it isn't known.
  std::uint64_t expected_rays() const {
    struct stat status {};
    if (fstat(fileno(file_.get()), &status) != 0 || !S_ISREG(status.st_mode)) return 0;
    return static_cast<std::uint64_t>(status.st_size) / format_.bytes_a_ray();
  }

  // Of a named file, whose rays can be read in any order: how many there are. Throws Error(usage) for another
  // one.
  std::uint64_t all_rays() const {
    struct stat status {};
    if (file_.get() == stdin || fstat(fileno(file_.get()), &status) != 0 || !S_ISREG(status.st_mode))
      throw Error(ErrorCode::usage, name_,
                  "isn't a file, which several ranks and --resume need: name a file");
    const std::uint64_t bytes = static_cast<std::uint64_t>(status.st_size) - first_byte_,
                        rays = bytes / format_.bytes_a_ray();
    if (bytes % format_.bytes_a_ray() != 0) fail_by_bytes(bytes);
    if (expected_ && rays != *expected_) fail_by_rays(rays);
    return rays;
  }
  std::vector<std::uint8_t> rays_at(std::uint64_t first, std::size_t count) const {
    return read_part(name_, first_byte_ + first * format_.bytes_a_ray(), count * format_.bytes_a_ray(),
                     ErrorCode::input);
  }

  // The next rays, up to so many: fewer at the end.
  std::vector<std::uint8_t> rays(std::size_t count) {
    const std::size_t ray_bytes = format_.bytes_a_ray();
    std::vector<std::uint8_t> bytes = std::move(start_);
    const std::size_t before = bytes.size();
    start_.clear();
    bytes.resize(count * ray_bytes);
    bytes.resize(before + read(bytes.data() + before, bytes.size() - before));
    bytes_ += bytes.size();
    if (bytes.size() % ray_bytes != 0) fail_by_bytes(bytes_);
    rays_ += bytes.size() / ray_bytes;
    if (expected_ && bytes.size() < count * ray_bytes && rays_ != *expected_) fail_by_rays(rays_);
    return bytes;
  }

private:
  struct Close {
    void operator()(std::FILE* file) const {
      if (file != stdin) static_cast<void>(std::fclose(file));
    }
  };

  [[noreturn]] void fail(const std::string& why) const { throw Error(ErrorCode::input, name_, why); }

  [[noreturn]] void fail_by_bytes(std::uint64_t bytes) const {
    fail(fmt::format("holds {} bytes, not a whole number of rays: a ray is {} {}-bit floats", bytes,
                     format_.numbers, format_.is_float64 ? 64 : 32));
  }
  [[noreturn]] void fail_by_rays(std::uint64_t rays) const {
    fail(fmt::format("holds {} rays, its header says {}", rays, *expected_));
  }

  std::size_t read(void* to, std::size_t bytes) {
    const std::size_t got = std::fread(to, 1, bytes, file_.get());
    if (std::ferror(file_.get()) != 0) fail(fmt::format("can't be read: {}", std::strerror(errno)));
    return got;
  }

  void read_npy_header() {
    std::uint8_t version_and_length[6];
    const std::size_t version_bytes = read(version_and_length, 4);
    std::size_t length = 0;
    if (version_bytes == 4) length = version_and_length[2] | std::size_t{version_and_length[3]} << 8;
    if (version_bytes == 4 && version_and_length[0] > 1) {
      if (read(version_and_length + 4, 2) != 2) fail("ends in its NumPy header");
      length |= std::size_t{version_and_length[4]} << 16 | std::size_t{version_and_length[5]} << 24;
    }
    std::string header(std::min<std::size_t>(length, 1 << 16), ' ');
    if (version_bytes != 4 || read(header.data(), header.size()) != header.size() || length > header.size())
      fail("ends in its NumPy header, or the header is too long");
    const std::optional<NpyArray> array = parsed_npy_header(header);
    if (!array || array->shape.size() != 2 || (array->type != "<f4" && array->type != "<f8") ||
        (array->shape[1] != 6 && array->shape[1] != 8))
      fail("isn't a NumPy array of rays: float32 or float64, in C order, of shape (N, 6) or (N, 8)");
    format_ = {array->type == "<f8", static_cast<int>(array->shape[1])};
    first_byte_ = static_cast<std::uint64_t>(std::ftell(file_.get()));
    expected_ = array->shape[0];
  }

  std::string name_;
  RayFormat format_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<std::uint8_t> start_; // read already
  std::uint64_t first_byte_ = 0;    // of the first ray
  std::uint64_t bytes_ = 0, rays_ = 0;
  std::optional<std::uint64_t> expected_;
};

// --- A chunk of the list -----------------------------------------------------------------------------------

struct Chunk {
  std::uint64_t task = 0, first = 0; // first: ray's index in the list
  std::vector<std::uint8_t> rays;
  std::size_t count = 0;
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
    const std::size_t record_bytes = record_bytes_of(fields);
    std::vector<std::uint8_t> records(count * record_bytes);
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, rays_a_task), [&](const auto& range) {
      std::size_t offset = 0;
      for (const HitField field : fields) {
        const std::size_t bytes = format_of(field).bytes;
        const auto* const from = static_cast<const std::uint8_t*>(array(field));
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

// --- Writing -----------------------------------------------------------------------------------------------

// What the file of hits begins with: of a NumPy array a header, as long for any number of rays; else nothing.
std::string hits_head(const RayListJob& job, std::uint64_t rays) {
  if (!job.hits.ends_with(".npy")) return {};
  std::string type;
  for (const HitField field : job.fields)
    type += fmt::format("('{}', {}), ", format_of(field).name, format_of(field).type);
  return npy_header("[" + type + "]", rays);
}

// The chunks of a list, each of which is read while those before it are traced: all in their order, or those
// of the tasks that this process takes.
class ChunkReader {
public:
  // tasks: null where nobody else takes any.
  ChunkReader(RayReader& reader, TaskList* tasks)
      : reader_(reader), tasks_(tasks), rays_(tasks != nullptr ? reader.all_rays() : 0) {}

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
    if (tasks_ != nullptr) {
      const auto task = tasks_->next();
      if (!task) return chunk;
      chunk->task = *task;
      chunk->first = *task * rays_a_chunk;
      chunk->rays =
          reader_.rays_at(chunk->first, std::min<std::uint64_t>(rays_a_chunk, rays_ - chunk->first));
    } else {
      chunk->first = read_;
      chunk->rays = reader_.rays(rays_a_chunk);
    }
    chunk->count = chunk->rays.size() / reader_.format().bytes_a_ray();
    read_ += chunk->count;
    return chunk;
  }

  RayReader& reader_;
  TaskList* tasks_;
  std::uint64_t rays_, read_ = 0;
  bool ended_ = false;
  std::mutex mutex_;
  std::future<std::shared_ptr<Chunk>> coming_;
};

// Of the hashes of its pieces: files may be larger than memory.
Hash hash_of_file(const std::string& path) {
  constexpr std::uint64_t piece_bytes = std::uint64_t{1} << 22;
  const InputFile file(path);
  std::vector<std::uint8_t> piece, hashes;
  for (std::uint64_t offset = 0; offset < file.size(); offset += piece.size()) {
    piece.resize(std::min(piece_bytes, file.size() - offset));
    file.read(offset, piece);
    const Hash hash = hash_of(piece);
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&hash);
    hashes.insert(hashes.end(), bytes, bytes + sizeof(hash));
  }
  file.check_unchanged();
  return hash_of(hashes);
}

TaskListOf task_list_of(const RayListJob& job, const RayReader& reader, const Sharing& sharing) {
  if (!sharing.in_parts()) return {};
  const std::uint64_t chunks = (reader.all_rays() + rays_a_chunk - 1) / rays_a_chunk;
  TaskListOf tasks{job.description + "\n" + job.hits, job.hits, chunks};
  if (!sharing.resume) return tasks;
  std::string hash = sharing.ranks.rank() == 0 ? to_hex(hash_of_file(job.rays)) : std::string();
  sharing.ranks.broadcast(hash);
  tasks.description += "\nrays " + hash;
  return tasks;
}

// Tracing and writing of chunks, in any order and at the same time.
class ListTracer {
public:
  ListTracer(const Tracer& tracer, const RayListJob& job, const Sharing& sharing,
             const std::function<void(double)>& progress)
      : tracer_(tracer), job_(job), sharing_(sharing), progress_(progress),
        in_double_(resolved(job.request.tracing.precision, tracer.scene()) == Precision::doubled),
        reader_(job.rays, job.format), tasks_(sharing, task_list_of(job, reader_, sharing)),
        chunks_(reader_, sharing.in_parts() ? &tasks_ : nullptr), head_bytes_(hits_head(job, 0).size()) {
    if (!job.hits.empty() && !sharing.in_parts()) hits_.emplace(job.hits, hits_head(job, 0));
  }

  // Besides those that a GPU has: one is written, one is about to be.
  std::size_t chunks_under_way() const {
    const std::size_t bytes =
                          rays_a_chunk * (reader_.format().bytes_a_ray() + 2 * record_bytes_of(job_.fields)),
                      queries = tracer_.device() == Device::cuda ? queries_a_gpu * tracer_.device_count() : 1;
    return std::min(tasks_under_way(tracer_, bytes), queries + 2);
  }

  // The next chunk, traced; or nothing.
  std::shared_ptr<Chunk> trace(std::size_t device) {
    std::shared_ptr<Chunk> chunk = chunks_.next();
    if (!chunk) return {};
    const RayList rays(chunk->rays.data(), chunk->count, reader_.format());
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
    if (!job_.hits.empty()) {
      FilePart part{head_bytes_ + chunk.first * record_bytes_of(job_.fields), chunk.records(job_.fields)};
      if (hits_)
        hits_->write(std::move(part));
      else
        written.push_back(write_part(partial_name(job_.hits), with_head(std::move(part))));
    }
    const double share = sharing_.in_parts() ? tasks_.finish(chunk.task, written, chunk.totals) : 0;
    const std::lock_guard lock(mutex_);
    report_.write_seconds += watch.seconds();
    if (sharing_.in_parts()) return progress_(share);
    report_.totals += chunk.totals;
    if (reader_.expected_rays() > 0)
      progress_(static_cast<double>(report_.totals.rays) / static_cast<double>(reader_.expected_rays()));
  }

  // Collective: when all tasks are done.
  TracingReport finish() {
    const Stopwatch watch;
    if (sharing_.in_parts()) {
      finish_parts();
    } else if (hits_) {
      hits_->commit(hits_head(job_, report_.totals.rays)); // now that their number is known
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

  // The first part begins with the head, for the number of rays is known.
  FilePart with_head(FilePart part) const {
    if (part.offset > head_bytes_) return part;
    const std::string head = hits_head(job_, reader_.all_rays());
    part.bytes.insert(part.bytes.begin(), head.begin(), head.end());
    return {0, std::move(part.bytes)};
  }

  void finish_parts() {
    Ranks& ranks = sharing_.ranks;
    report_.totals = tasks_.totals();
    ranks.wait_for_all([&] { progress_(tasks_.share()); });
    if (ranks.rank() == 0) {
      if (!job_.hits.empty()) {
        const std::uint64_t rays = reader_.all_rays();
        if (rays == 0) write_part(partial_name(job_.hits), with_head({head_bytes_, {}}));
        finish_partial(job_.hits, head_bytes_ + rays * record_bytes_of(job_.fields));
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
  RayReader reader_;
  TaskList tasks_;
  ChunkReader chunks_;
  std::uint64_t head_bytes_;
  std::optional<PlacedFile> hits_;
  std::once_flag loop_found_;
  RayLoop loop_ = RayLoop::warp_refill;
  std::mutex mutex_; // of what follows
  TracingReport report_;
};

} // namespace

std::vector<HitField> hit_fields(const std::string& names) {
  std::vector<HitField> fields;
  for (std::size_t begin = 0; begin <= names.size();) {
    const std::size_t end = std::min(names.find(',', begin), names.size());
    const std::string name = names.substr(begin, end - begin);
    const auto* const found =
        std::ranges::find_if(field_formats, [&](const auto& f) { return name == f.name; });
    if (found == std::end(field_formats))
      throw Error(ErrorCode::usage, "--write",
                  fmt::format("'{}' isn't one of t, object, primitive, face, uv, normal, occluded", name));
    if (std::ranges::count(fields, found->field) > 0)
      throw Error(ErrorCode::usage, "--write", fmt::format("has {} twice", name));
    fields.push_back(found->field);
    begin = end + 1;
  }
  return fields;
}

TracingReport trace_ray_list(const Tracer& tracer, const RayListJob& job, const Sharing& sharing,
                             const std::function<void(double)>& progress) {
  const Stopwatch elapsed;
  ListTracer tracing(tracer, job, sharing, progress);
  run_tasks(
      tracer, tracing.chunks_under_way(), [&](std::size_t device) { return tracing.trace(device); },
      [&](const Chunk& chunk) { tracing.write(chunk); });
  TracingReport report = tracing.finish();
  report.elapsed_seconds = elapsed.seconds();
  return report;
}

} // namespace masu
