// What the program was compiled for.
#pragma once

namespace masu {

// Throws Error(device) where the processor lacks instructions that this program was compiled for.
void check_processor();

} // namespace masu
