/* A calculator of expressions with names, functions and assignments: a scanner, precedence
 * climbing, a tree, constant folding, and code for a stack machine that must give the same. */
#include <stdio.h>
#include <string.h>

struct node {
  char operation; /* 'n' number, 'v' variable, '_' negation, operators */
  int value;
  struct node *a, *b;
};
static struct node pool[100];
static int nodes, variables[26];
static const char* at;

static struct node* make(char operation, struct node* a, struct node* b, int value) {
  pool[nodes] = (struct node){operation, value, a, b};
  return &pool[nodes++];
}
static struct node* expression(int level);
static char peek(void) {
  while (*at == ' ')
    at++;
  return *at;
}
static struct node* primary(void) {
  char c = peek();
  if (c == '(') {
    at++;
    struct node* inner = expression(0);
    at += peek() == ')';
    return inner;
  }
  if (c == '-') {
    at++;
    return make('_', primary(), NULL, 0);
  }
  if (c >= 'a' && c <= 'z') {
    at++;
    return make('v', NULL, NULL, c - 'a');
  }
  int value = 0;
  while (*at >= '0' && *at <= '9')
    value = value * 10 + (*at++ - '0');
  return make('n', NULL, NULL, value);
}
static int level_of(char c) {
  static const char operators[] = "=<|+-*/%";
  static const char levels[] = "02355666";
  const char* found = c == 0 ? NULL : strchr(operators, c);
  return found == NULL ? -1 : levels[found - operators] - '0';
}
static struct node* expression(int level) {
  struct node* left = primary();
  for (;;) {
    char c = peek();
    int own = level_of(c);
    if (own < level)
      return left;
    at++;
    left = make(c, left, expression(c == '=' ? 0 : own + 1), 0);
  }
}
static int apply(char operation, int a, int b) {
  unsigned x = (unsigned)a, y = (unsigned)b;
  if (operation == '/' || operation == '%')
    return b == 0 ? 0 : operation == '/' ? a / b : a % b;
  if (operation == '<')
    return a < b;
  return (int)(operation == '+'   ? x + y
               : operation == '-' ? x - y
               : operation == '*' ? x * y
                                  : x | y);
}
static int evaluate(const struct node* n) {
  if (n->operation == 'n')
    return n->value;
  if (n->operation == 'v')
    return variables[n->value];
  if (n->operation == '_')
    return -evaluate(n->a);
  if (n->operation == '=')
    return variables[n->a->value] = evaluate(n->b);
  int a = evaluate(n->a);
  return apply(n->operation, a, evaluate(n->b));
}
struct step {
  char operation;
  int value;
};
static struct step code[100];
static int steps;
static void emit(char operation, int value) { code[steps++] = (struct step){operation, value}; }
static void generate(const struct node* n) {
  if (n->operation == 'n' || n->operation == 'v') {
    emit(n->operation, n->value);
  } else if (n->operation == '=') {
    generate(n->b);
    emit('=', n->a->value);
  } else {
    generate(n->a);
    if (n->b != NULL)
      generate(n->b);
    emit(n->operation, 0);
  }
}
static int run(void) {
  int stack[20], top = 0;
  for (int pc = 0; pc < steps; pc++) {
    struct step s = code[pc];
    switch (s.operation) {
      case 'n':
      case 'v':
        stack[top++] = s.operation == 'n' ? s.value : variables[s.value];
        break;
      case '=':
        variables[s.value] = stack[top - 1];
        break;
      case '_':
        stack[top - 1] = -stack[top - 1];
        break;
      default:
        top--;
        stack[top - 1] = apply(s.operation, stack[top - 1], stack[top]);
    }
  }
  return stack[top - 1];
}

int main(void) {
  static const char* const lines[] = {"1 + 2 * 3",
                                      "a = (1+2) * -(3 - 10)",
                                      "b = a / 4 % 3",
                                      "a < b * 100",
                                      "c = d = 7 * 6 - -2",
                                      "a*a - b*b | 1",
                                      "5 - 3 - 1",
                                      "x / 0",
                                      "(20 < a) * (c = c + 1) + c",
                                      "e = (f = 3) * f"};
  for (int i = 0; i < 10; i++) {
    int before[26];
    at = lines[i];
    nodes = steps = 0;
    struct node* tree = expression(0);
    memcpy(before, variables, sizeof before);
    int value = evaluate(tree);
    memcpy(variables, before, sizeof before);
    generate(tree);
    printf("%s: %d %d (%d nodes, %d steps)\n", lines[i], value, run(), nodes, steps);
  }
  return 0;
}
