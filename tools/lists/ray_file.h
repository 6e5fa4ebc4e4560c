// Lists of rays in files and pipes: numbers one after the other, NumPy arrays, CSV.
#pragma once

#include "libscene/file/input_file.h"
#include "libscene/file/input_stream.h"
#include "renderer/rays/ray_query.h"
#include "tools/jobs/ranks.h"
#include "tools/lists/ray_csv.h"

#include <optional>
#include <string>
#include <vector>

namespace masu {

// Rays, and the bytes of the file that they were read from.
struct RaysRead {
  std::vector<std::uint8_t> rays;
  std::uint64_t bytes = 0;
};

// How a list is read is said by the end of its name: .npy and .csv; else it is numbers, or a NumPy array by
// its content. Throws Error(input): for what isn't a whole number of rays, another kind of array, a text that
// isn't named .csv, a device, a pipe that nobody writes to.
class RayFile {
public:
  // `path` - is standard input. `numbers`: the format of what is numbers alone.
  RayFile(const std::string& path, const RayFormat& numbers);

  // Of what is read.
  const RayFormat& format() const { return format_; }
  std::uint64_t bytes() const { return bytes_; }                   // of a named file, else 0
  std::optional<std::uint64_t> count() const { return expected_; } // where it is known at the start

  // --- From the start to the end
  // The next rays, up to so many: fewer at the end alone.
  RaysRead next(std::size_t count);
  // By any thread: next() doesn't wait for a pipe any longer, and reads nothing from now on.
  void cancel() { stream_.cancel(); }

  // --- In chunks, in any order, by any thread
  // Collective (ranks.h): finds out where chunks of so many rays begin; to be called before what follows, and
  // instead of next(). Throws Error(usage) for what isn't a named file.
  void find_chunks(std::size_t rays_per_chunk, Ranks& ranks);
  std::uint64_t all_rays() const { return all_rays_; }
  RaysRead chunk(std::uint64_t index) const;

private:
  // The byte that a chunk's lines begin at, the line before it, and the index of its first ray.
  struct ChunkStart {
    std::uint64_t byte, line, ray;
  };

  bool is_named_file() const { return path_ != "-" && stream_.is_file(); }
  std::size_t read(void* to, std::size_t bytes);
  void read_npy_head();
  void read_names();
  void read_more_text();
  RaysRead next_lines(std::size_t count);
  std::string chunk_starts();
  [[noreturn]] void fail_by_bytes(std::uint64_t bytes) const;
  [[noreturn]] void fail_by_rays(std::uint64_t rays) const;

  std::string path_;
  InputStream stream_;
  RayFormat format_;
  std::optional<RayCsv> csv_;
  std::uint64_t bytes_ = 0, first_byte_ = 0; // first_byte_: of the first ray
  std::optional<std::uint64_t> expected_;    // rays

  std::vector<std::uint8_t> start_;    // read to see what it is; what of it isn't taken yet
  std::string text_;                   // of a CSV file, the same of what follows the last ray
  bool is_all_ = false;                // nothing follows text_
  std::uint64_t taken_ = 0, rays_ = 0; // bytes and rays so far

  std::optional<InputFile> file_; // for chunks
  std::size_t rays_per_chunk_ = 1;
  std::uint64_t all_rays_ = 0;
  std::vector<ChunkStart> starts_; // of a CSV file's chunks, and its end
};

} // namespace masu
