/* A depth picture of a mesh: writes torus.scene, torus.grid and torus.pgm. */
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
  const masu_mesh mesh = {vertices[0], NULL, around * across, indices[0], 2 * around * across, NULL};
  check(masu_write_scene("torus.scene", &mesh, 1, MASU_STORE_AUTO, NULL));
  check(masu_build_grid("torus.scene", "torus.grid", NULL));

  for (int y = 0; y < height; ++y) /* the camera at (0, -2, 2.5) looks at the origin */
    for (int x = 0; x < width; ++x) {
      const float right = ((float)x + 0.5f - width / 2) / height,
                  up = (height / 2 - (float)y - 0.5f) / height;
      float* ray = rays[y * width + x];
      ray[0] = 0, ray[1] = -2, ray[2] = 2.5f;
      ray[3] = right, ray[4] = 0.62f + 0.78f * up, ray[5] = -0.78f + 0.62f * up;
    }
  masu_tracer* tracer;
  check(masu_open("torus.scene", "torus.grid", MASU_CPU, &tracer));
  const masu_query query = {.format = MASU_RAYS_FLOAT32_6, .coherent = 1};
  const masu_hits hits = {.t = t, .primitive = primitive};
  check(masu_nearest(tracer, rays, width * height, &query, &hits));
  masu_close(tracer);

  FILE* file = fopen("torus.pgm", "wb");
  if (!file || fprintf(file, "P5 %d %d 255\n", width, height) < 0) return perror("torus.pgm"), 3;
  for (int i = 0; i < width * height; ++i) /* near is bright */
    putc(primitive[i] == MASU_NONE ? 0 : (int)fmaxf(1, 255 * (4.2f - t[i]) / 3), file);
  return fclose(file) == 0 ? 0 : 3;
}
