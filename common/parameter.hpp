// Declared parameters: every uncertain or adjustable number of the machine.
//
// A parameter is declared once, as a member of a ParameterGroup, with its dotted name, unit, range,
// default, certainty (V verified, D derived, M from memory, E estimate, as hardware.md uses the
// letters), source and meaning. The TOML parser, error messages, `finback machine --parameters`,
// the manual and sweeps all read that declaration. Reading a value in the model costs one load.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace finback {

class ParameterGroup;

struct ParameterDeclaration {
  std::string_view name;  // "memory.l2.read_cycles"
  std::string_view unit;  // "CCLK", "SCLK", "bytes", "MHz", ...; "" for a plain number
  double default_value = 0;
  double minimum = 0;
  double maximum = 0;
  char certainty = 'E';      // V, D, M or E
  std::string_view source;   // document and section
  std::string_view meaning;  // one sentence
};

class ParameterBase {
 public:
  ParameterBase(ParameterGroup* group, const ParameterDeclaration& declaration, bool is_integer);
  ParameterBase(const ParameterBase&) = delete;
  ParameterBase& operator=(const ParameterBase&) = delete;
  virtual ~ParameterBase() = default;

  [[nodiscard]] const ParameterDeclaration& declaration() const { return declaration_; }
  [[nodiscard]] bool is_integer() const { return is_integer_; }
  [[nodiscard]] virtual double value() const = 0;
  // Sets the value. Throws InputError naming the parameter, its unit and its range when it is
  // outside the range, or has a fraction where whole numbers are wanted.
  void set(double value);

 protected:
  virtual void store(double value) = 0;

 private:
  ParameterDeclaration declaration_;
  bool is_integer_;
};

// T is std::int64_t for whole numbers or double.
template <class T>
class Parameter final : public ParameterBase {
 public:
  Parameter(ParameterGroup* group, const ParameterDeclaration& declaration)
      : ParameterBase(group, declaration, !std::is_floating_point_v<T>),
        value_(static_cast<T>(declaration.default_value)) {}

  // Not explicit: a parameter reads like the number that it is.
  operator T() const { return value_; }
  [[nodiscard]] double value() const override { return static_cast<double>(value_); }

 private:
  void store(double value) override { value_ = static_cast<T>(value); }
  T value_;
};

using IntegerParameter = Parameter<std::int64_t>;
using RealParameter = Parameter<double>;

// Base of a room's parameters; its members register themselves in the order of their declaration.
class ParameterGroup {
 public:
  ParameterGroup() = default;
  ParameterGroup(const ParameterGroup&) = delete;
  ParameterGroup& operator=(const ParameterGroup&) = delete;

  [[nodiscard]] const std::vector<ParameterBase*>& parameters() const { return parameters_; }

 protected:
  ~ParameterGroup() = default;

 private:
  friend class ParameterBase;
  std::vector<ParameterBase*> parameters_;
};

// The name among `known` that is nearest to `name` by edit distance, or "" when none is near; for
// "unknown key X, did you mean Y".
[[nodiscard]] std::string nearest_name(std::string_view name,
                                       const std::vector<std::string>& known);

}  // namespace finback
