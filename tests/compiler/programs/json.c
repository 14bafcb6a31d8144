/* A reader and a writer of JSON: recursive descent over text, a tree in an arena, numbers, escapes,
 * errors with their place. */
#include <stdio.h>
#include <string.h>

enum kind { number, string, array, object };
struct value {
  enum kind kind;
  int number;
  const char *text, *name;
  struct value *child, *next;
};
struct reader {
  const char *at, *begin, *error;
  struct value pool[60];
  char letters[400];
  int values, used;
};

static struct value* read_value(struct reader* r);

static void skip(struct reader* r) {
  while (*r->at == ' ' || *r->at == '\n' || *r->at == '\t')
    r->at++;
}
static struct value* fail(struct reader* r, const char* why) {
  if (r->error == NULL)
    r->error = why;
  return NULL;
}
static int expect(struct reader* r, char c) {
  skip(r);
  if (*r->at != c)
    return 0;
  r->at++;
  return 1;
}
static const char* read_string(struct reader* r) {
  static const char codes[] = "n\nt\t\"\"\\\\//";
  if (!expect(r, '"'))
    return (const char*)fail(r, "a string was expected");
  char* begin = r->letters + r->used;
  while (*r->at != '"') {
    char c = *r->at++;
    if (c == 0)
      return (const char*)fail(r, "a string does not end");
    if (c == '\\') {
      const char* code = codes;
      while (*code != 0 && *code != *r->at)
        code += 2;
      if (*code == 0)
        return (const char*)fail(r, "an unknown escape");
      c = code[1];
      r->at++;
    }
    r->letters[r->used++] = c;
  }
  r->at++;
  r->letters[r->used++] = 0;
  return begin;
}
static struct value* make(struct reader* r, enum kind kind) {
  struct value* v = &r->pool[r->values++];
  memset(v, 0, sizeof *v);
  v->kind = kind;
  return v;
}
static struct value* read_list(struct reader* r, enum kind kind, char end) {
  struct value *list = make(r, kind), **last = &list->child;
  if (expect(r, end))
    return list;
  do {
    const char* name = NULL;
    if (kind == object && ((name = read_string(r)) == NULL || !expect(r, ':')))
      return fail(r, "a name was expected");
    if ((*last = read_value(r)) == NULL)
      return NULL;
    (*last)->name = name;
    last = &(*last)->next;
  } while (expect(r, ','));
  return expect(r, end) ? list : fail(r, "a list does not end");
}
static struct value* read_value(struct reader* r) {
  skip(r);
  char c = *r->at;
  if (c == '{' || c == '[') {
    r->at++;
    return c == '{' ? read_list(r, object, '}') : read_list(r, array, ']');
  }
  if (c == '"') {
    const char* text = read_string(r);
    if (text == NULL)
      return NULL;
    struct value* v = make(r, string);
    v->text = text;
    return v;
  }
  struct value* v = make(r, number);
  int sign = c == '-' ? -1 : 1;
  if (sign < 0)
    c = *++r->at;
  if (c >= '0' && c <= '9') {
    for (; *r->at >= '0' && *r->at <= '9'; r->at++)
      v->number = v->number * 10 + sign * (*r->at - '0');
    return v;
  }
  return fail(r, "no value");
}
static void write(const struct value* v) {
  if (v->name != NULL)
    printf("%s=", v->name);
  switch (v->kind) {
    case number:
      printf("%d", v->number);
      break;
    case string:
      printf("'%s'", v->text);
      break;
    default:
      putchar(v->kind == array ? '[' : '{');
      for (const struct value* c = v->child; c != NULL; c = c->next) {
        write(c);
        if (c->next != NULL)
          putchar(' ');
      }
      putchar(v->kind == array ? ']' : '}');
  }
}
static void test(const char* text) {
  static struct reader r;
  r.at = r.begin = text;
  r.error = NULL;
  r.values = r.used = 0;
  struct value* v = read_value(&r);
  if (v == NULL)
    printf("%s at %d", r.error, (int)(r.at - r.begin));
  else
    write(v);
  printf(" %d %d\n", r.values, r.used);
}

int main(void) {
  test("{\"name\": \"whale\", \"length\": -27, \"parts\": [1, 2, [3, []], {}]}");
  test(" [ \"a\\n\\\"b\\\"\", -0 , 12,{\"x\":{\"y\":[0]}} ] ");
  test("[1, 2");
  test("{\"a\" 1}");
  test("[truth]");
  test("\"open");
  return 0;
}
