#include <fmt/format.h>
#include <toml++/toml.h>

#include <common/error.hpp>
#include <common/file.hpp>
#include <power_model/power_file.hpp>

namespace finback::power {

namespace {

SourcePlace place(const std::string& file, const toml::source_position& at) {
  return {file, static_cast<int>(at.line), static_cast<int>(at.column)};
}

class PowerReader {
 public:
  PowerReader(const std::string& file, PowerParameters& parameters)
      : file_(file), parameters_(parameters) {}

  void read(const std::string& prefix, const toml::table& table) {
    for (const auto& [key, node] : table) {
      const std::string name = prefix + std::string(key.str());
      if (const toml::table* inner = node.as_table()) {
        read(name + ".", *inner);
      } else {
        set(name, key.source().begin, node);
      }
    }
  }

 private:
  void set(const std::string& name, const toml::source_position& at, const toml::node& node) {
    ParameterBase& parameter = find(name, at);
    if (!node.is_number()) {
      throw InputError(place(file_, node.source().begin), fmt::format("{} wants a number", name));
    }
    try {
      parameter.set(*node.value<double>());
    } catch (const InputError& error) {
      throw InputError(place(file_, node.source().begin), error.what());
    }
  }

  ParameterBase& find(const std::string& name, const toml::source_position& at) {
    std::vector<std::string> names;
    for (ParameterBase* parameter : parameters_.parameters()) {
      if (parameter->declaration().name == name) {
        return *parameter;
      }
      names.emplace_back(parameter->declaration().name);
    }
    const std::string near = nearest_name(name, names);
    throw InputError(place(file_, at),
                     fmt::format("unknown key {}{}", name,
                                 near.empty() ? "" : fmt::format(", did you mean {}", near)));
  }

  const std::string& file_;
  PowerParameters& parameters_;
};

}  // namespace

void read_power_parameters(std::string_view text, const std::string& file,
                           PowerParameters& parameters) {
  try {
    PowerReader(file, parameters).read("", toml::parse(text, file));
  } catch (const toml::parse_error& error) {
    throw InputError(place(file, error.source().begin), std::string(error.description()));
  }
}

void load_power_parameters(const std::filesystem::path& path, PowerParameters& parameters) {
  read_power_parameters(read_text_file(path), path.string(), parameters);
}

}  // namespace finback::power
