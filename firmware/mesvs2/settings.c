#include "settings.h"

static const struct {
  const char* name;
  uint32_t* number;
  uint32_t most;
} known[] = {{"lrc_threshold", &stereo_settings.lrc_threshold, 255},
             {"texture_threshold", &stereo_settings.texture_threshold, 65025},
             {"disparity_threshold", &stereo_settings.disparity_threshold, 65025}};

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
      }
    }
    if (next == 0) {
      return line;
    }
    text = next;
  }
  return 0;
}
