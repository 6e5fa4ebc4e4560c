// A file of any kind that is read from its start to its end, once: a regular file, a pipe, standard input.
#pragma once

#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <string>

namespace masu {

// A pipe that no process has open for writing is waited for a few seconds.
class InputStream {
public:
  // `path` - is standard input. Throws Error(input, path or stdin, …).
  explicit InputStream(const std::string& path);
  ~InputStream();
  InputStream(const InputStream&) = delete;
  InputStream& operator=(const InputStream&) = delete;

  // As it was opened.
  const struct stat& status() const { return opened_; }
  bool is_file() const { return S_ISREG(opened_.st_mode); }

  // Fills `to`; reads fewer bytes only at the end, or once it is cancelled. Throws Error(input, …).
  std::size_t read(void* to, std::size_t bytes);
  // What is there, up to so many bytes, as soon as anything is; 0 when read() would read nothing.
  std::size_t read_some(void* to, std::size_t bytes);
  // By any thread: read() doesn't wait any longer, and reads nothing from now on.
  void cancel() { cancelled_ = true; }
  bool is_cancelled() const { return cancelled_; }

  [[noreturn]] void fail(const std::string& what) const; // Error(input, path or stdin, what)

private:
  void wait_for_writer();
  bool is_readable() const;

  std::string name_;
  bool is_ours_, begun_ = false; // ours: not standard input
  int file_;
  struct stat opened_ {};
  std::chrono::milliseconds waited_{0};
  std::atomic<bool> cancelled_ = false;
};

} // namespace masu
