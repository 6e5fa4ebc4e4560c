#include "tools/ray_list.h"

#include "libscene/error.h"
#include "libscene/stopwatch.h"
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

  // The next rays, up to so many: fewer at the end.
  std::vector<std::uint8_t> rays(std::size_t count) {
    const std::size_t ray_bytes = format_.bytes_a_ray();
    std::vector<std::uint8_t> bytes = std::move(start_);
    const std::size_t before = bytes.size();
    start_.clear();
    bytes.resize(count * ray_bytes);
    bytes.resize(before + read(bytes.data() + before, bytes.size() - before));
    bytes_ += bytes.size();
    if (bytes.size() % ray_bytes != 0)
      fail(fmt::format("holds {} bytes, not a whole number of rays: a ray is {} {}-bit floats", bytes_,
                       format_.numbers, format_.is_float64 ? 64 : 32));
    rays_ += bytes.size() / ray_bytes;
    if (expected_ && bytes.size() < count * ray_bytes && rays_ != *expected_)
      fail(fmt::format("holds {} rays, its header says {}", rays_, *expected_));
    return bytes;
  }

private:
  struct Close {
    void operator()(std::FILE* file) const {
      if (file != stdin) static_cast<void>(std::fclose(file));
    }
  };

  [[noreturn]] void fail(const std::string& why) const { throw Error(ErrorCode::input, name_, why); }

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
    expected_ = array->shape[0];
  }

  std::string name_;
  RayFormat format_;
  std::unique_ptr<std::FILE, Close> file_;
  std::vector<std::uint8_t> start_; // read already
  std::uint64_t bytes_ = 0, rays_ = 0;
  std::optional<std::uint64_t> expected_;
};

// --- A chunk of the list -----------------------------------------------------------------------------------

struct Chunk {
  std::uint64_t first = 0; // ray's index in the list
  std::vector<std::uint8_t> rays;
  std::size_t count = 0;
  std::vector<float> t, uv, normal;
  std::vector<std::uint32_t> object, primitive;
  std::vector<std::uint8_t> occluded;

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

// A list's chunks in their order, each of which is read while those before it are traced.
class ChunkReader {
public:
  explicit ChunkReader(RayReader& reader) : reader_(reader) {}

  // Nothing after the last one. For threads at the same time.
  std::shared_ptr<Chunk> next() {
    const std::lock_guard lock(mutex_);
    if (!coming_.valid()) return {};
    std::shared_ptr<Chunk> chunk = coming_.get();
    if (chunk->count == 0) return {};
    coming_ = std::async(std::launch::async, [this] { return read(); });
    return chunk;
  }

private:
  std::shared_ptr<Chunk> read() {
    auto chunk = std::make_shared<Chunk>();
    chunk->rays = reader_.rays(rays_a_chunk);
    chunk->count = chunk->rays.size() / reader_.format().bytes_a_ray();
    chunk->first = read_;
    read_ += chunk->count;
    return chunk;
  }

  RayReader& reader_;
  std::uint64_t read_ = 0; // rays
  std::mutex mutex_;
  std::future<std::shared_ptr<Chunk>> coming_ = std::async(std::launch::async, [this] { return read(); });
};

// Tracing and writing of chunks, in any order and at the same time.
class ListTracer {
public:
  ListTracer(const Tracer& tracer, const RayListJob& job, const std::function<void(double)>& progress)
      : tracer_(tracer), job_(job), progress_(progress),
        in_double_(resolved(job.request.tracing.precision, tracer.scene()) == Precision::doubled),
        reader_(job.rays, job.format), head_bytes_(hits_head(job, 0).size()) {
    if (!job.hits.empty()) hits_.emplace(job.hits, hits_head(job, 0));
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
    const QueryReport report =
        repeated(0, job_.repeat, [&] { return tracer_.trace(rays, results, job_.request, device); });
    const std::uint64_t invalid = in_double_ ? invalid_rays<double>(rays) : invalid_rays<float>(rays);
    const std::lock_guard lock(mutex_);
    summary_.counts += report.counts;
    summary_.seconds += report.seconds;
    summary_.invalid += invalid;
    return chunk;
  }

  void write(const Chunk& chunk) {
    const Stopwatch watch;
    if (hits_)
      hits_->write({head_bytes_ + chunk.first * record_bytes_of(job_.fields), chunk.records(job_.fields)});
    const std::lock_guard lock(mutex_);
    summary_.write_seconds += watch.seconds();
    summary_.rays += chunk.count;
    if (reader_.expected_rays() > 0)
      progress_(static_cast<double>(summary_.rays) / static_cast<double>(reader_.expected_rays()));
  }

  RayListSummary finish() {
    const Stopwatch watch;
    if (hits_) hits_->commit(hits_head(job_, summary_.rays)); // now that their number is known
    summary_.write_seconds += watch.seconds();
    return summary_;
  }

private:
  const Tracer& tracer_;
  const RayListJob& job_;
  const std::function<void(double)>& progress_;
  bool in_double_;
  RayReader reader_;
  std::uint64_t head_bytes_;
  std::optional<PlacedFile> hits_;
  ChunkReader chunks_{reader_};
  std::mutex mutex_; // of what follows
  RayListSummary summary_;
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
                  fmt::format("'{}' isn't one of t, object, primitive, uv, normal, occluded", name));
    if (std::ranges::count(fields, found->field) > 0)
      throw Error(ErrorCode::usage, "--write", fmt::format("has {} twice", name));
    fields.push_back(found->field);
    begin = end + 1;
  }
  return fields;
}

RayListSummary trace_ray_list(const Tracer& tracer, const RayListJob& job,
                              const std::function<void(double)>& progress) {
  const Stopwatch elapsed;
  ListTracer tracing(tracer, job, progress);
  run_tasks(
      tracer, tracing.chunks_under_way(), [&](std::size_t device) { return tracing.trace(device); },
      [&](const Chunk& chunk) { tracing.write(chunk); });
  RayListSummary summary = tracing.finish();
  summary.elapsed_seconds = elapsed.seconds();
  return summary;
}

} // namespace masu
