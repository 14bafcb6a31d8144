/* Switches that are nested, that have loops around and inside, whose default stands anywhere, whose
 * cases lie in blocks of other statements (Duff's device), and that jump over declarations. */
#include "report.h"

APART static int nested(int a, int b) {
  int n = 0;
  switch (a) {
    case 0:
      switch (b) {
        case 0:
          n = 1;
          break;
        case 1:
          n = 2;
        default:
          n += 3;
      }
      break;
    default:
      n = 50;
    case 1:
      switch (b & 1)
      case 1:
        n += 7;
      n += 11;
      break;
    case 2: {
      int c = b * 2;
      switch (c + a) {
        case 4:
          return 100;
        case 6:
          break;
        case 8:
          n = c;
          goto out;
      }
      n -= c;
    }
  }
  n *= 3;
out:
  return n + b;
}
APART static void copy(char* to, const char* from, int count) {
  int rounds = (count + 7) / 8;
  if (count <= 0)
    return;
  switch (count % 8) {
    case 0:
      do {
        *to++ = *from++;
        case 7:
          *to++ = *from++;
        case 6:
          *to++ = *from++;
        case 5:
          *to++ = *from++;
        case 4:
          *to++ = *from++;
        case 3:
          *to++ = *from++;
        case 2:
          *to++ = *from++;
        case 1:
          *to++ = *from++;
      } while (--rounds > 0);
  }
}
APART static unsigned machine(const char* text) {
  unsigned words = 0, numbers = 0, others = 0;
  for (int state = 0; *text != 0; text++) {
    switch (*text) {
      case ' ':
        if (state == 1)
          words++;
        if (state == 2)
          numbers++;
        state = 0;
        continue;
      case '#':
        while (text[1] != 0 && text[1] != '\n')
          text++;
        break;
      case '!':
        goto done;
      default:
        if (*text >= '0' && *text <= '9') {
          if (state == 0)
            state = 2;
        } else if (*text >= 'a' && *text <= 'z') {
          state = 1;
        } else {
          others++;
          break;
        }
        continue;
    }
    others += 100;
  }
done:
  return words + numbers * 16 + others * 256;
}
APART static int over_declarations(int x) {
  switch (x) {
    int kept;
    case 1:
      kept = 5;
      return kept + x;
    case 2: {
      int array[3] = {x, x + 1, x + 2};
      kept = array[1];
      return kept;
    }
    case 3:
      kept = x;
      for (int i = 0; i < 4; i++)
      case 4:
        x += 3;
  }
  return x;
}
int main(void) {
  unsigned s = 0;
  for (int a = -1; a < 5; a++)
    for (int b = -1; b < 5; b++)
      s = mix(s, (unsigned)nested(a, b));
  report("nested", s);
  static const char text[] = "abcdefghijklmnopqrstuvwxyz";
  for (int i = 0; i < 26; i++) {
    char to[32] = {0};
    copy(to, text, i);
    for (int k = 0; k < 32; k++)
      s = mix(s, (unsigned char)to[k]);
  }
  report("device", s);
  report("machine", machine("one 2 three#four\n 55 six ? 7x 8 !9 ten "));
  s = (unsigned)(over_declarations(1) + over_declarations(2) * 10 + over_declarations(3) * 100);
  report("declarations", s);
  return 0;
}
