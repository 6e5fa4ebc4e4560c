// One function for each scene; spd.cpp checks the size first.
#pragma once

#include "libscene/spd/nff_writer.h"

namespace masu::spd {

void write_balls(NffWriter& nff, int size, bool background);
void write_gears(NffWriter& nff, int size, bool background);
void write_mount(NffWriter& nff, int size, bool background);
void write_nurbs(NffWriter& nff, int size, bool background);
void write_rings(NffWriter& nff, int size, bool background);
void write_teapot(NffWriter& nff, int size, bool background);
void write_tetra(NffWriter& nff, int size, bool background);
void write_tree(NffWriter& nff, int size, bool background);

} // namespace masu::spd
