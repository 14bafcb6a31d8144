#include "settings.h"

#include "stereo_config.h"

static const struct {
  const char* name;
  uint32_t* number;
  uint32_t least;
  uint32_t most;
} known[] = {{"window", &stereo_settings.window, 3, WINDOW},
             {"disparity_min", &stereo_settings.disparity_min, 1, HIGHEST_DISPARITY_MIN},
             {"disparity_max", &stereo_settings.disparity_max, 2, 255},
             {"lrc_threshold", &stereo_settings.lrc_threshold, 0, 255},
             {"texture_threshold", &stereo_settings.texture_threshold, 0, 65025},
             {"disparity_threshold", &stereo_settings.disparity_threshold, 0, 65025}};

/* What follows `name` and a space; 0 where the text is another. */
static const char* behind_name(const char* text, const char* name) {
  for (; *name != 0; ++name, ++text) {
    if (*text != *name) {
      return 0;
    }
  }
  return *text == ' ' ? text + 1 : 0;
}

/* The text behind a number's line, which is then in `number`; 0 where there is no such number. */
static const char* read_number(const char* text, uint32_t most, uint32_t* number) {
  const char* first = text;
  uint32_t read = 0;
  for (; *text >= '0' && *text <= '9'; ++text) {
    read = 10 * read + (uint32_t)(*text - '0');
    if (read > most) {
      return 0;
    }
  }
  if (text == first || *text != '\n') {
    return 0;
  }
  *number = read;
  return text + 1;
}

int settings_read(const char* text) {
  for (int line = 1; *text >= ' ' && *text <= '~'; ++line) {
    const char* next = 0;
    for (unsigned i = 0; i < sizeof known / sizeof known[0] && next == 0; ++i) {
      const char* number = behind_name(text, known[i].name);
      if (number != 0) {
        next = read_number(number, known[i].most, known[i].number);
        next = *known[i].number < known[i].least ? 0 : next;
      }
    }
    if (next == 0 || stereo_settings.window % 2 == 0) {
      return line;
    }
    text = next;
  }
  return 0;
}

int settings_range_fits(void) {
  return stereo_settings.disparity_max > stereo_settings.disparity_min &&
         stereo_settings.disparity_max - stereo_settings.disparity_min < DISPARITY_COUNT;
}
