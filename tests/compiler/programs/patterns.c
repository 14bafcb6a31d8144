/* Finding texts and matching patterns: regular expressions by backtracking, wildcards, and three
 * searches (by a table of failures, by bad characters, by rolling sums) that must agree. */
#include <stdio.h>
#include <string.h>

static int match_here(const char* pattern, const char* text);

static int one(const char* pattern, char c) {
  if (*pattern == '.')
    return c != 0;
  if (*pattern == '\\')
    return c == pattern[1];
  if (*pattern == '[') {
    int inverted = pattern[1] == '^', found = 0;
    for (pattern += 1 + inverted; *pattern != ']'; pattern++)
      if (pattern[1] == '-' && pattern[2] != ']') {
        found |= c >= pattern[0] && c <= pattern[2];
        pattern += 2;
      } else {
        found |= c == *pattern;
      }
    return c != 0 && found != inverted;
  }
  return c == *pattern;
}
static const char* after(const char* pattern) {
  if (*pattern == '\\')
    return pattern + 2;
  if (*pattern == '[')
    return strchr(pattern, ']') + 1;
  return pattern + 1;
}
static int match_here(const char* pattern, const char* text) {
  if (*pattern == 0)
    return 1;
  if (*pattern == '$' && pattern[1] == 0)
    return *text == 0;
  const char* rest = after(pattern);
  if (*rest == '*' || *rest == '+' || *rest == '?') {
    int least = *rest == '+', most = *rest == '?' ? 1 : 1000, count = 0;
    while (count < most && one(pattern, text[count]))
      count++;
    for (; count >= least; count--)
      if (match_here(rest + 1, text + count))
        return 1;
    return 0;
  }
  return one(pattern, *text) && match_here(rest, text + 1);
}
static int match(const char* pattern, const char* text) {
  if (*pattern == '^')
    return match_here(pattern + 1, text) ? 0 : -1;
  for (int at = 0;; at++) {
    if (match_here(pattern, text + at))
      return at;
    if (text[at] == 0)
      return -1;
  }
}
static int wildcard(const char* pattern, const char* text) {
  const char *star = NULL, *kept = NULL;
  while (*text != 0) {
    if (*pattern == '*') {
      star = pattern++;
      kept = text;
    } else if (*pattern == '?' || *pattern == *text) {
      pattern++;
      text++;
    } else if (star != NULL) {
      pattern = star + 1;
      text = ++kept;
    } else {
      return 0;
    }
  }
  while (*pattern == '*')
    pattern++;
  return *pattern == 0;
}
static int by_failures(const char* text, const char* word) {
  int fail[32] = {0}, n = (int)strlen(word);
  for (int i = 1, k = 0; i < n; fail[i++] = k) {
    while (k > 0 && word[i] != word[k])
      k = fail[k - 1];
    k += word[i] == word[k];
  }
  for (int i = 0, k = 0; text[i] != 0; i++) {
    while (k > 0 && text[i] != word[k])
      k = fail[k - 1];
    if (text[i] == word[k] && ++k == n)
      return i - n + 1;
  }
  return -1;
}
static int by_characters(const char* text, const char* word) {
  unsigned char skip[256];
  int n = (int)strlen(word), size = (int)strlen(text);
  memset(skip, n, sizeof skip);
  for (int i = 0; i < n - 1; i++)
    skip[(unsigned char)word[i]] = (unsigned char)(n - 1 - i);
  for (int at = 0; at + n <= size; at += skip[(unsigned char)text[at + n - 1]]) {
    int i = n - 1;
    while (i >= 0 && text[at + i] == word[i])
      i--;
    if (i < 0)
      return at;
  }
  return -1;
}
static int by_sums(const char* text, const char* word) {
  unsigned n = (unsigned)strlen(word), wanted = 0, sum = 0, power = 1;
  for (unsigned i = 0; i < n; i++) {
    wanted = wanted * 257 + (unsigned char)word[i];
    if (i > 0)
      power *= 257;
    if (text[i] == 0)
      return -1;
    sum = sum * 257 + (unsigned char)text[i];
  }
  for (unsigned at = 0;; at++) {
    if (sum == wanted && memcmp(text + at, word, n) == 0)
      return (int)at;
    if (text[at + n] == 0)
      return -1;
    sum = (sum - (unsigned char)text[at] * power) * 257 + (unsigned char)text[at + n];
  }
}

int main(void) {
  static const char* const patterns[] = {"o",   "^the",    "l*az+y",  "[a-d]o[^x]$", "q.*x",
                                         "\\.", "j?um+ps", "z[xyz]?", "fox$",        "x*"};
  static const char text[] = "the quick brown fox jumps over the lazy dog";
  for (int i = 0; i < 10; i++)
    printf("%s: %d\n", patterns[i], match(patterns[i], text));
  static const char* const wildcards[] = {"*", "the*dog", "*q??ck*", "*fox", "t*e*z?*g", "?"};
  for (int i = 0; i < 6; i++)
    printf("%s: %d\n", wildcards[i], wildcard(wildcards[i], text));
  static const char* const words[] = {"aab", "abab", "dog",          "lazy",
                                      "e",   "xyz",  "the lazy dog", "abcabd"};
  static const char other[] = "aaaaabababcabcabdabab";
  for (int i = 0; i < 8; i++)
    printf("%s: %d %d %d, %d %d %d\n", words[i], by_failures(text, words[i]),
           by_characters(text, words[i]), by_sums(text, words[i]), by_failures(other, words[i]),
           by_characters(other, words[i]), by_sums(other, words[i]));
  return 0;
}
