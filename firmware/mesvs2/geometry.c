#include "geometry.h"

#include "settings.h"

struct geometry geometry;

void geometry_start(void) {
  geometry.window = (int)stereo_settings.window;
  geometry.half_window = geometry.window / 2;
  geometry.disparity_min = (int)stereo_settings.disparity_min;
  geometry.disparity_count =
      (int)(stereo_settings.disparity_max - stereo_settings.disparity_min) + 1;
  geometry.first_column = geometry.disparity_min + geometry.half_window;
  geometry.columns = MAP_WIDTH - geometry.half_window - geometry.first_column;
}
