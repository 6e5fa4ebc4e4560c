// For builds without CUDA, in which --backend cuda is refused before this is called.
#include "libscene/base/error.h"
#include "tools/bench/screen_division/screen_division.h"

namespace masu {

DividedFrame render_divided_cuda(const SceneFile&, const StructureFile&, const FrameRequest&, ScreenDivision,
                                 int) {
  throw Error(ErrorCode::device, "cuda", "this program was built without it: use --backend cpu");
}

} // namespace masu
