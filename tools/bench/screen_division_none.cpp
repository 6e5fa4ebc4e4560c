// Stands in for CUDA's where the program was built without it: --backend cuda is refused before.
#include "libscene/error.h"
#include "tools/bench/screen_division.h"

namespace masu {

DividedFrame render_divided_cuda(const SceneFile&, const GridFile&, const FrameRequest&, ScreenDivision,
                                 int) {
  throw Error(ErrorCode::device, "cuda", "this program was built without it: use --backend cpu");
}

} // namespace masu
