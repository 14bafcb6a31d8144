// Hardware loops by name: LOOP, LOOP_BEGIN and LOOP_END become an LSETUP and two labels.
#include <fmt/format.h>

#include <isa_sim/assembler/assembler.hpp>

namespace finback::assembler {

using isa::Token;
using isa::TokenKind;

// LOOP name LC0 = P0; LOOP_BEGIN name; LOOP_END name;
bool Assembler::read_loop(const std::vector<Token>& tokens, const Statement& statement) {
  if (tokens.size() < 2 || tokens[0].kind != TokenKind::name || tokens[1].kind == TokenKind::sign) {
    return false;
  }
  const std::string word = lower_case(tokens[0].text);
  std::string_view name = tokens[1].text;
  if (is_numbered_reference(name)) {  // LOOP 1f belongs to LOOP_BEGIN 1
    name.remove_suffix(1);
  }
  const auto label = [&](const char* which) -> Symbol& {
    return symbols_.get(fmt::format("L$L${}__{}", name, which));
  };
  if (word == "loop_begin" && tokens.size() == 2) {
    define_label(label("BEGIN"), statement, tokens[1].text, section().location());
    return true;
  }
  if (word == "loop_end" && tokens.size() == 2) {  // names the instruction before it
    define_label(label("END"), statement, tokens[1].text, section().last_packet());
    return true;
  }
  if (word != "loop" || tokens.size() < 3) {
    return false;
  }
  std::vector<Token> setup(6,
                           Token{TokenKind::sign, false, tokens[0].line, tokens[0].column, 0, "("});
  setup[0].kind = setup[2].kind = setup[4].kind = TokenKind::name;
  setup[0].text = "LSETUP";
  setup[2].text = label("BEGIN").name;
  setup[3].text = ",";
  setup[4].text = label("END").name;
  setup[5].text = ")";
  for (const char* which : {"BEGIN", "END"}) {
    Symbol& used = label(which);
    if (!used.used && used.kind == Symbol::Kind::undefined) {
      used.defined = place_of(statement, tokens[1].text);
    }
    used.used = true;
  }
  setup.insert(setup.end(), tokens.begin() + 2, tokens.end());
  emit(read_packet(setup, statement), statement);
  return true;
}

}  // namespace finback::assembler
