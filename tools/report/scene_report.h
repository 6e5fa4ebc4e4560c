// What the tools that make scene files share: writing one, warnings, and the report of --info.
#pragma once

#include "libscene/file/scene_file.h"
#include "libscene/mesh/files/mesh_file.h"
#include "tools/common/cli.h"

#include <string>

namespace masu {

// What is done with a scene.
struct SceneOutput {
  std::string path; // empty: no file is written
  Store store = Store::automatic;
  std::string origin = "auto"; // auto, none or X,Y,Z
  bool info = false, json = false;

  // --output, --store, --origin, --info, --json.
  void add_to(const CommandLine& command);
  // Throws Error(usage) where there is nothing to do.
  void check() const;
};

// What a tool couldn't take from its input as it was: lines on stderr.
void print_warnings(const char* tool, const std::string& input, const SceneWarnings& warnings);
void print_warnings(const char* tool, const std::string& input, const ImportNotes& notes);

// Writes the scene's file, warns on stderr of what `tool` couldn't take from `input` as it was, and prints
// the report, as `output` has it. Throws as write_scene does.
void write_and_report(const char* tool, const std::string& input, const Scene& scene,
                      const SceneOutput& output);

// Prints the report of a scene file.
void print_report(const SceneFile& file, bool json);

} // namespace masu
