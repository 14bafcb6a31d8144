// An annotated function as text and as JSON (docs/finback-annotate.md).
#pragma once

#include <string>

#include <report/annotation.hpp>
#include <report/page.hpp>

namespace finback::report {

[[nodiscard]] std::string to_text(const Annotation& annotation, const Style& style);
[[nodiscard]] std::string to_json(const Annotation& annotation);

}  // namespace finback::report
