// A hidden name that a file has on its way to its own.
#pragma once

#include <cstddef>
#include <string>

namespace masu {

// A name in a folder that no other process has: it is taken with O_EXCL, and the file is locked (flock) for
// as long as its process lives. So a name whose file isn't locked was left by a process that was killed, and
// is taken over. Names derive from the file's own, so that whoever writes that file next meets what is left
// of it.
class TemporaryName {
public:
  // `folder` is open, and stays so for as long as this lives. No name is taken yet.
  TemporaryName(int folder, const std::string& name);
  ~TemporaryName();
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName(TemporaryName&&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  TemporaryName& operator=(TemporaryName&&) = delete;

  // Makes an empty file of that name, and returns it, open for writing. -1 and errno where that can't be.
  int create();
  // Gives it to an unnamed file (O_TMPFILE). False and errno where that can't be.
  bool link(int file);
  // Gives the file its own name instead, replacing what has it. False and errno where that can't be.
  bool rename_to(const std::string& name);

private:
  // Tries names until act(name), which sets errno, is true or fails for another reason than EEXIST.
  template <class Act>
  bool take(const Act& act);
  bool remove_abandoned(const char* name) const;

  int folder_;
  std::size_t hash_;
  std::string name_; // empty: none is taken
};

// For a program's main: SIGINT, SIGTERM and SIGHUP remove the names that are taken before they end the
// process as they do by default. A signal that is ignored stays so.
void remove_temporary_names_on_signals();

} // namespace masu
