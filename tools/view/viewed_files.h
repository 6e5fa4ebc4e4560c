// What gridview shows: files, or what it makes in memory of a standard scene, a mesh or NFF text.
#pragma once

#include "libgrid/file/structure_file.h"
#include "libscene/file/scene_file.h"

#include <string>
#include <vector>

namespace masu {

// Command lines, as words, that write the file that is in memory; none where it is a file already.
using Commands = std::vector<std::vector<std::string>>;

struct ViewedStructure {
  std::string path; // of a file in memory the one that its commands write
  StructureFile file;
  Commands made_by{};
};

struct ViewedFiles {
  std::string path;
  SceneFile scene;
  std::vector<ViewedStructure> structures{};
  Commands made_by{};
};

// A scene file and its grids. Without grids `scene` may be NFF text or a mesh, too, and gets an irregular
// grid and a hierarchy; `demo`, a scene of the SPD instead of it, also a uniform grid and one merged by
// balance. Says what was made. Throws as what reads and builds them does, Error(usage) for another demo, and
// Error(input) for a mesh of a format that Assimp alone reads.
ViewedFiles viewed_files(const std::string& scene, const std::vector<std::string>& grids,
                         const std::string& demo, bool quiet);

} // namespace masu
