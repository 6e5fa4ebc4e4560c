#include "tools/lists/ray_file.h"

#include "libscene/base/error.h"
#include "tools/lists/npy.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace masu {
namespace {

constexpr std::size_t looked_at = 4096; // bytes that say whether it is a text
constexpr std::size_t text_piece = std::size_t{1} << 20;

// Printable ASCII alone: float32 or float64 numbers that are all so are next to impossible.
bool is_plainly_text(std::span<const std::uint8_t> bytes) {
  constexpr std::array<std::uint8_t, 3> byte_order_mark{0xef, 0xbb, 0xbf};
  if (bytes.size() > byte_order_mark.size() &&
      std::equal(byte_order_mark.begin(), byte_order_mark.end(), bytes.begin()))
    bytes = bytes.subspan(byte_order_mark.size());
  return !bytes.empty() && std::ranges::all_of(bytes, [](std::uint8_t byte) {
    return (byte >= ' ' && byte < 0x7f) || byte == '\t' || byte == '\n' || byte == '\r';
  });
}

std::vector<std::uint8_t> bytes_of(const std::vector<double>& rays) {
  const auto* const first = reinterpret_cast<const std::uint8_t*>(rays.data());
  return {first, first + rays.size() * sizeof(double)};
}

} // namespace

RayFile::RayFile(const std::string& path, const RayFormat& numbers)
    : path_(path), stream_(path), format_(numbers) {
  const auto mode = stream_.status().st_mode;
  if (S_ISCHR(mode) || S_ISBLK(mode)) stream_.fail("is a device: name a file or a pipe");
  if (is_named_file()) bytes_ = static_cast<std::uint64_t>(stream_.status().st_size);
  if (path.ends_with(".csv")) {
    csv_.emplace(path);
    read_names();
    return;
  }
  start_.resize(looked_at);
  start_.resize(stream_.read(start_.data(), start_.size()));
  if (std::string_view(reinterpret_cast<const char*>(start_.data()), start_.size()).starts_with(npy_magic))
    read_npy_head();
  else if (path.ends_with(".npy"))
    stream_.fail("isn't a NumPy array: give it the name of what it is, such as .f32 or .csv");
  else if (is_plainly_text(start_))
    stream_.fail(
        "is a text, where numbers of 32 or 64 bits are expected: name a CSV file, which ends in .csv");
  if (!is_named_file()) return;
  const std::uint64_t bytes = bytes_ - std::min(first_byte_, bytes_), rays = bytes / format_.bytes_per_ray();
  if (bytes % format_.bytes_per_ray() != 0) fail_by_bytes(bytes);
  if (expected_ && rays != *expected_) fail_by_rays(rays);
  expected_ = rays;
}

void RayFile::fail_by_bytes(std::uint64_t bytes) const {
  stream_.fail(fmt::format("holds {} bytes, not a whole number of rays: a ray is {} {}-bit floats", bytes,
                           format_.numbers, format_.is_float64 ? 64 : 32));
}

void RayFile::fail_by_rays(std::uint64_t rays) const {
  stream_.fail(
      fmt::format("holds {} rays, its {} says {}", rays, first_byte_ > 0 ? "header" : "size", *expected_));
}

std::size_t RayFile::read(void* to, std::size_t bytes) {
  const std::size_t known = std::min(bytes, start_.size());
  std::copy_n(start_.data(), known, static_cast<std::uint8_t*>(to));
  start_.erase(start_.begin(), start_.begin() + static_cast<std::ptrdiff_t>(known));
  return known + stream_.read(static_cast<std::uint8_t*>(to) + known, bytes - known);
}

// --- What it begins with -----------------------------------------------------------------------------------

void RayFile::read_npy_head() {
  const std::optional<NpyArray> array = masu::read_npy_head([this](void* to, std::size_t bytes) {
    first_byte_ += bytes;
    return read(to, bytes) == bytes;
  });
  if (!array || array->shape.size() != 2 || (array->type != "<f4" && array->type != "<f8") ||
      (array->shape[1] != 6 && array->shape[1] != 8))
    stream_.fail("isn't a NumPy array of rays, or ends in its header: they are float32 or float64, in C "
                 "order, of shape (N, 6) or (N, 8)");
  format_.is_float64 = array->type == "<f8";
  format_.numbers = static_cast<int>(array->shape[1]);
  expected_ = array->shape[0];
}

void RayFile::read_names() {
  do {
    read_more_text();
    first_byte_ = csv_->read_names(text_, is_all_);
  } while (first_byte_ == 0);
  text_.erase(0, first_byte_);
  format_.is_float64 = true;
  format_.numbers = csv_->numbers();
}

// --- From the start to the end -----------------------------------------------------------------------------

RaysRead RayFile::next(std::size_t count) {
  if (csv_) return next_lines(count);
  RaysRead next{std::vector<std::uint8_t>(count * format_.bytes_per_ray())};
  next.rays.resize(read(next.rays.data(), next.rays.size()));
  if (stream_.is_cancelled()) return {};
  next.bytes = next.rays.size();
  taken_ += next.bytes;
  if (next.bytes % format_.bytes_per_ray() != 0) fail_by_bytes(taken_);
  const std::size_t rays = next.bytes / format_.bytes_per_ray();
  rays_ += rays;
  if (expected_ && rays < count && rays_ != *expected_) fail_by_rays(rays_);
  return next;
}

void RayFile::read_more_text() {
  const std::size_t before = text_.size();
  text_.resize(before + text_piece);
  text_.resize(before + stream_.read(text_.data() + before, text_piece));
  is_all_ = text_.size() < before + text_piece;
}

RaysRead RayFile::next_lines(std::size_t count) {
  const std::size_t wanted = count * static_cast<std::size_t>(csv_->numbers());
  RaysRead next;
  std::vector<double> numbers;
  for (;;) {
    const std::size_t rays_left = (wanted - numbers.size()) / static_cast<std::size_t>(csv_->numbers());
    const std::size_t taken = csv_->read_rays(text_, is_all_, rays_left, numbers);
    text_.erase(0, taken);
    next.bytes += taken;
    if (numbers.size() == wanted || is_all_) break;
    read_more_text();
    if (stream_.is_cancelled()) return {};
  }
  next.rays = bytes_of(numbers);
  return next;
}

// --- In chunks ---------------------------------------------------------------------------------------------

void RayFile::find_chunks(std::size_t rays_per_chunk, Ranks& ranks) {
  if (!is_named_file())
    throw Error(ErrorCode::usage, path_, "isn't a file, which several ranks need: name a file");
  file_.emplace(path_);
  rays_per_chunk_ = rays_per_chunk;
  if (!csv_) {
    all_rays_ = *expected_;
    return;
  }
  std::string found = ranks.rank() == 0 ? chunk_starts() : std::string();
  ranks.broadcast(found);
  starts_.resize(found.size() / sizeof(ChunkStart));
  std::memcpy(starts_.data(), found.data(), found.size());
  all_rays_ = starts_.back().ray;
}

// Reads the stream to its end.
std::string RayFile::chunk_starts() {
  RayCsv csv = *csv_;
  ChunkStart next{first_byte_, csv.line(), 0};
  std::string starts;
  const auto begin_chunk = [&] {
    next.line = csv.line();
    starts.append(reinterpret_cast<const char*>(&next), sizeof next);
  };
  begin_chunk();
  for (;;) {
    const std::uint64_t before = next.ray;
    const std::size_t taken =
        csv.skip_rays(text_, is_all_, rays_per_chunk_ - before % rays_per_chunk_, next.ray);
    text_.erase(0, taken);
    next.byte += taken;
    if (next.ray > before && next.ray % rays_per_chunk_ == 0) {
      begin_chunk();
    } else {
      if (is_all_) break;
      read_more_text();
    }
  }
  begin_chunk();
  return starts;
}

RaysRead RayFile::chunk(std::uint64_t index) const {
  const std::uint64_t first = index * rays_per_chunk_, ray_bytes = format_.bytes_per_ray();
  const std::size_t count = std::min<std::uint64_t>(rays_per_chunk_, all_rays_ - first);
  RaysRead read;
  if (!csv_) {
    read.rays.resize(count * ray_bytes);
    file_->read(first_byte_ + first * ray_bytes, read.rays);
    read.bytes = read.rays.size();
    return read;
  }
  const ChunkStart &begin = starts_[index], &end = starts_[index + 1];
  std::string text(end.byte - begin.byte, ' ');
  file_->read(begin.byte, {reinterpret_cast<std::uint8_t*>(text.data()), text.size()});
  RayCsv csv = *csv_;
  csv.set_line(begin.line);
  std::vector<double> numbers;
  csv.read_rays(text, true, count, numbers);
  if (numbers.size() != count * static_cast<std::size_t>(csv.numbers()))
    stream_.fail("was changed while it was read: run again when it is complete");
  read.rays = bytes_of(numbers);
  read.bytes = text.size();
  return read;
}

} // namespace masu
