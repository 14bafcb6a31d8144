// docs/events.md, as its reader runs it.
#include "page_examples.hpp"
#include "program.hpp"

namespace finback::cli {
namespace {

class Events : public ProgramTest {};

TEST_F(Events, ThePagesExampleRuns) { check_page_examples("events.md", folder().string()); }

}  // namespace
}  // namespace finback::cli
