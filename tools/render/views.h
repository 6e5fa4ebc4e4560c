// Views of a scene: cameras from the command line, from a list, or around a point; the names of their
// pictures.
#pragma once

#include "libscene/file/scene_file.h"
#include "renderer/camera.h"
#include "tools/common/number_list.h"

#include <optional>
#include <string>
#include <vector>

namespace masu {

// Why a camera can't see. `part`: from, at, up or angle.
struct CameraFault {
  const char* part;
  std::string what;
};
// Points outside `places` are faults.
std::optional<CameraFault> fault_of(const Camera& camera, const Boxd& places);

// Where a scene's cameras can be so that the arithmetic holds their coordinates.
Boxd camera_places(const SceneFile& scene);

// The camera rays of X,Y,W,H: pixels of a picture, from its top left corner. Throws Error(usage, option, …)
// for another text, and where that isn't within the picture.
RayWindow cropped(const char* option, const std::string& text, const Camera& camera, Sampling sampling);

struct View {
  std::string name; // as part of a file name
  Camera camera;
};

// Reads a list, a JSON object per line: name, from, at, up [x, y, z], angle (degrees), size [width, height].
// What a line leaves out is the base's, a missing name the view's index. `path`: in errors. Throws
// Error(input, "path:line", …) for whatever isn't such an object, for a camera with a fault, and for a name
// that isn't safe in a file name or that another view has.
std::vector<View> parse_views(const std::string& text, const std::string& path, const Camera& base,
                              const Boxd& places);

// `count` views from a circle around the axis through `at` along `up`, the first one from where the camera
// is, counterclockwise as seen from above. Names are indices.
std::vector<View> turntable(const Camera& camera, int count);

// The file names of all views: {index} and {name} are replaced. Throws Error(usage, pattern, …) where several
// views would have one name.
std::vector<std::string> file_names(const std::string& pattern, const std::vector<View>& views);

} // namespace masu
