// A child process for what may fault, loop or take all memory, as libraries do with damaged files.
#pragma once

namespace masu {

// Goes on in a child process, and returns 0 there. The parent waits for the child, and passes on to it the
// signals that end programs. Where a fault or a limit ended the child, the parent gets that signal; otherwise
// it ends as the child did. A parent that is killed takes the child with it.
//
// What the child prints on standard error, if that isn't a terminal, is printed when it has ended, and not at
// all where a fault or a limit ended it: libraries say more than a line about their faults.
//
// To be called before there are threads, and with nothing left in the buffers of standard output. Throws
// Error(input, process, …) where there can't be another process.
int continue_in_child();

} // namespace masu
