#include <algorithm>
#include <array>

#include <isa_sim/isa/pattern_tree.hpp>
#include <isa_sim/isa/registers.hpp>

namespace finback::isa {
namespace {

constexpr std::size_t kLongestWord = 23;  // longer names are symbols

}  // namespace

Word& PatternTree::word(const std::string& text) {
  const auto found = words_.find(text);
  if (found != words_.end()) {
    return found->second;
  }
  word_texts_.push_back(std::make_unique<std::string>(text));
  return words_[*word_texts_.back()];
}

void PatternTree::add_registers() {
  for (int reg = 0; reg < kRegisterCount; ++reg) {
    const std::string name(register_name(static_cast<Register>(reg)));
    word(name).reg = reg;
    if (is_data_register(reg) || is_address_register(reg)) {
      for (const char part : {'L', 'H', 'B'}) {
        Word& half = word(name + "." + part);
        half.reg = reg;
        half.part = part;
      }
    }
  }
}

int PatternTree::literal_id(const std::string& text) {
  Word& entry = word(text);
  if (entry.literal == kNoWord) {
    entry.literal = next_literal_++;
  }
  return entry.literal;
}

int PatternTree::target(int from, const PatternStep& step) {
  const bool literal = step.kind == PatternStep::Kind::literal;
  const int id = literal ? literal_id(step.literal) : kNoWord;
  Node& node = nodes_[static_cast<std::size_t>(from)];
  std::vector<Node::Edge>& edges = literal ? node.literals : node.operands;
  const auto found = std::ranges::find(edges, step, &Node::Edge::step);
  if (found != edges.end()) {
    return found->target;
  }
  const int added = static_cast<int>(nodes_.size());
  edges.push_back({step, id, added});
  std::ranges::sort(edges, {}, &Node::Edge::literal);
  nodes_.emplace_back();
  return added;
}

void PatternTree::add_choice(OperandKind kind) {
  auto& all = choices_[kind];
  for (const Spelling& spelling : spellings(kind)) {
    auto& [literals, value] = all.emplace_back();
    value = spelling.value;
    for (const Token& token : tokenize(spelling.text)) {
      literals.push_back(literal_id(std::string(token.text)));
    }
  }
}

void PatternTree::add(int entry, Pattern pattern) {
  for (const OperandRole& role : pattern.roles) {
    if (is_choice(role.kind) && !choices_.contains(role.kind)) {
      add_choice(role.kind);
    }
  }
  add_steps(entry, pattern.steps);
  if (!pattern.short_steps.empty()) {
    add_steps(entry, pattern.short_steps);
  }
  patterns_.push_back(std::move(pattern));
}

void PatternTree::add_steps(int entry, const std::vector<PatternStep>& steps) {
  int node = 0;
  for (const PatternStep& step : steps) {
    node = target(node, step);
  }
  int& end = nodes_[static_cast<std::size_t>(node)].entry;
  if (end >= 0) {
    same_syntax_.emplace_back(end, entry);
  } else {
    end = entry;
  }
}

Word PatternTree::look_up(const Token& token) const {
  if (token.text.size() > kLongestWord || token.kind == TokenKind::text) {
    return {};
  }
  std::array<char, kLongestWord> buffer{};
  std::ranges::transform(token.text, buffer.begin(), [](unsigned char c) {
    return static_cast<char>(c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c);
  });
  const auto found = words_.find(std::string_view(buffer.data(), token.text.size()));
  return found == words_.end() ? Word{} : found->second;
}

std::vector<Word> PatternTree::look_up_all(std::span<const Token> tokens) const {
  std::vector<Word> found;
  found.reserve(tokens.size());
  for (const Token& token : tokens) {
    found.push_back(look_up(token));
  }
  return found;
}

}  // namespace finback::isa
