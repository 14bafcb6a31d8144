/* string.h at every alignment. */
#include <stdio.h>
#include <string.h>

#include "report.h"

static int sign(int v) { return (v > 0) - (v < 0); }

static const char *or_none(const char *found) { return found != NULL ? found : "none"; }

static void at_every_alignment(void) {
  unsigned sum = 0;
  for (int to = 0; to < 5; to++)
    for (int from = 0; from < 5; from++)
      for (int length = 0; length < 14; length++) {
        static char source[32], target[40];
        memset(source, 'z', sizeof source);
        memset(target, '-', sizeof target);
        for (int i = 0; i < length; i++) source[from + i] = (char)('a' + (i * 7 + to) % 26);
        source[from + length] = 0;
        strcpy(target + to, source + from);
        sum = mix(sum, (unsigned)strlen(target + to) * 3 + (target[to + length + 1] == '-'));
        sum = mix(sum, (unsigned)(strcmp(target + to, source + from) == 0));
        if (length != 0) target[to + length / 2] ^= 1;
        sum = mix(sum, (unsigned)sign(strcmp(target + to, source + from)));
        sum = mix(sum, (unsigned)sign(memcmp(target + to, source + from, (size_t)length)));
        sum = mix(sum, (unsigned)sign(strncmp(target + to, source + from, (size_t)length / 2)));
        strncat(target + to, source + from, 4);
        strcat(target + to, "!");
        strncpy(target + to + 20, source + from, 9);
        for (int i = 0; i < 40; i++) sum = mix(sum, (unsigned char)target[i]);
      }
  report("alignments", sum);
}

int main(void) {
  at_every_alignment();
  const char *text = "the quick brown fox jumps over the lazy dog";
  printf("%s|%s|%s|%s\n", or_none(strchr(text, 'q')), or_none(strrchr(text, 't')),
         or_none(strchr(text, 'X')), or_none(strstr(text, "over")));
  printf("%s|%s|%s\n", or_none(strstr(text, "thx")), or_none(strstr(text, "")),
         or_none(strstr("aaab", "aab")));
  printf("%d %d %d\n", (int)strspn(text, "eht "), (int)strcspn(text, "xyz"),
         (int)(strchr(text, 0) - text));
  printf("%s %s\n", or_none(strpbrk(text, "fqb")), or_none(strpbrk(text, "XYZ")));
  printf("%s %d\n", (char *)memchr(text, 'b', 40), memchr(text, 'b', 5) == NULL);
  char list[] = ",,one, two;three ,";
  for (char *word = strtok(list, ", ;"); word != NULL; word = strtok(NULL, ", ;")) puts(word);
  printf("%d %d %d\n", sign(strcmp("\x80", "a")), sign(strcmp("", "")), sign(memcmp("\xff", "a", 1)));
  char moved[] = "0123456789";
  memmove(moved + 2, moved, 6);
  puts(moved);
  memmove(moved, moved + 3, 7);
  puts(moved);
  return 0;
}
