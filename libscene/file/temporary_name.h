// A hidden, temporary name for a file that is being written, and ends of a process, which remove them all.
#pragma once

#include <sys/stat.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <initializer_list>
#include <string>

namespace masu {

// A name in a folder that no other process uses: it is created with O_EXCL, and the file stays locked (flock)
// as long as its process lives. So an unlocked file was left by a killed process, and is removed. Names are
// derived from the final name, so that the next process that writes the same file finds stale ones.
class TemporaryName {
public:
  // `folder`: file descriptor, open for the lifetime of this object. No name is created yet.
  TemporaryName(int folder, const std::string& name);
  ~TemporaryName();
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  // Removes what killed processes left of names for the same file. A name that is taken removes those before
  // it.
  void remove_left() const;
  // Creates an empty file of that name; returns its descriptor, open for writing, or -1 and errno.
  int create();
  // Links an unnamed file (O_TMPFILE) to the name. Returns false and sets errno when it fails.
  bool link(int file);
  // Renames the file to its final name, replacing any file there. Returns false and sets errno when it fails.
  bool rename_to(const std::string& name);
  const std::string& name() const { return name_; } // empty: none

private:
  // Tries names until act(name), which sets errno, is true or fails for another reason than EEXIST.
  template <class Act>
  bool take(const Act& act);
  bool remove_stale(const char* name) const;
  std::string numbered(int number) const;

  int folder_;
  std::size_t hash_;
  std::string name_;
};

// One line says why a process ends: the first thread that calls this goes on, all others wait for the end.
void claim_last_line();

// Writes the parts and a newline to standard error, if no other thread has claimed that, removes all
// temporary names and ends the process, as where an input can't be used. Calls only async-signal-safe
// functions.
[[noreturn]] void end_with_line(std::initializer_list<const char*> parts);

inline bool is_same_file(const struct stat& a, const struct stat& b) {
  return a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

// That end programs.
inline constexpr std::array ending_signals{SIGINT, SIGTERM, SIGHUP};

// For a program's main: these signals remove all temporary names, also those that are just being made, then
// end the process as by default. Ignored signals stay ignored.
void remove_temporary_names_on_signals();

} // namespace masu
