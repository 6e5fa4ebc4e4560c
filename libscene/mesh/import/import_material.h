// Materials of an Assimp scene as those of NFF: colour, Kd, Ks, shine, T and index of refraction.
//
// Phong materials (OBJ, PLY, STL, Collada, FBX, …): the colour is the diffuse one, T is 1 - opacity, Kd 1 -
// T. In NFF's model Ks is both highlight and mirror. So it is the specular colour's mean only where the file
// says that the surface mirrors (OBJ: illum 3 to 9; else times its reflectivity), and otherwise 0.
//
// Materials of metalness m and roughness r (glTF): with the gloss g = 1 - r, Ks = g (0.04 + 0.96 m) and
// Kd = (1 - T)(1 - m g), so that a smooth metal is a mirror and a rough one is matte. The exponent is that of
// a Phong lobe as wide as the microfacets' of alpha = r². T is the transmission (with the index of
// refraction, or 1.5), else 1 - alpha of the base colour in blended materials (which don't refract).
#pragma once

#include "libscene/scene.h"

#include <assimp/scene.h>

namespace masu::import {

struct ImportedMaterial {
  Material material;
  bool has_textures;
  bool multiplies_vertex_colors; // as glTF's; else vertex colours replace the material's
};

// All numbers are finite and in the range of NFF's.
ImportedMaterial imported_material(const aiMaterial& material);

} // namespace masu::import
