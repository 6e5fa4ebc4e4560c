/* A depth picture of a mesh: writes torus.pgm; and torus.scene and torus.grid, as the tools do. */
#include <masu/masu.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { around = 96, across = 48, width = 320, height = 240 };

static void check(masu_status status) {
  if (status == MASU_OK) return;
  fprintf(stderr, "depth: %s\n", masu_error());
  exit((int)status);
}

static float vertices[around * across][3];
static uint32_t indices[2 * around * across][3];
static float rays[height * width][6]; /* origin, direction */
static float t[height * width];
static uint32_t primitive[height * width];

int main(void) {
  for (uint32_t i = 0; i < around; ++i)
    for (uint32_t j = 0; j < across; ++j) {
      const uint32_t a = i * across + j, b = i * across + (j + 1) % across;
      const uint32_t right = (i + 1) % around * across, c = right + j, d = right + (j + 1) % across;
      const float u = 6.2831853f * (float)i / around, v = 6.2831853f * (float)j / across,
                  r = 1 + 0.4f * cosf(v);
      vertices[a][0] = r * cosf(u), vertices[a][1] = r * sinf(u), vertices[a][2] = 0.4f * sinf(v);
      indices[2 * a][0] = a, indices[2 * a][1] = c, indices[2 * a][2] = b;
      indices[2 * a + 1][0] = b, indices[2 * a + 1][1] = c, indices[2 * a + 1][2] = d;
    }
  const masu_mesh mesh = {sizeof mesh, vertices[0],         NULL, around * across,
                          indices[0],  2 * around * across, NULL};
  const masu_geometry geometry = {.size = sizeof geometry, .meshes = &mesh, .mesh_count = 1};
  masu_scene* scene;
  masu_grid* grid;
  masu_tracer* tracer;
  check(masu_scene_create(&geometry, &scene));
  check(masu_grid_build(scene, NULL, &grid));
  check(masu_tracer_create(scene, grid, NULL, &tracer));

  for (int y = 0; y < height; ++y) /* the camera at (0, -2, 2.5) looks at the origin */
    for (int x = 0; x < width; ++x) {
      const float right = ((float)x + 0.5f - width / 2) / height,
                  up = (height / 2 - (float)y - 0.5f) / height;
      float* ray = rays[y * width + x];
      ray[0] = 0, ray[1] = -2, ray[2] = 2.5f;
      ray[3] = right, ray[4] = 0.62f + 0.78f * up, ray[5] = -0.78f + 0.62f * up;
    }
  const masu_query query = {.size = sizeof query, .format = MASU_RAYS_FLOAT32_6, .coherent = 1};
  const masu_hits hits = {.size = sizeof hits, .t = t, .primitive = primitive};
  check(masu_nearest(tracer, rays, width * height, &query, &hits));
  masu_tracer_free(tracer);
  check(masu_scene_write(scene, "torus.scene"));
  check(masu_grid_write(grid, "torus.grid"));
  masu_grid_free(grid);
  masu_scene_free(scene);

  FILE* file = fopen("torus.pgm", "wb");
  if (!file || fprintf(file, "P5 %d %d 255\n", width, height) < 0) return perror("torus.pgm"), 3;
  for (int i = 0; i < width * height; ++i) /* near is bright */
    putc(primitive[i] == MASU_NONE ? 0 : (int)fmaxf(1, 255 * (4.2f - t[i]) / 3), file);
  return fclose(file) == 0 ? 0 : 3;
}
