// The addresses that the page asks, and the page itself.
#pragma once

#include "tools/view/http_server.h"
#include "tools/view/viewer.h"

namespace masu {

// Status 404 for any other path; 409 where the parameter `files`, which any may have, isn't Viewer::files(),
// for another gridview has the port by now. Throws Error(usage) for parameters that are missing, unknown or
// out of range.
HttpReply answer(const Viewer& viewer, const HttpRequest& request);

} // namespace masu
