// The examples of a manual page, run as a reader would run them.
//
// A page's ```console blocks hold commands behind "$ " and what they print below, on both streams.
// Each is run by sh in the test's folder; what it prints must be what the page says, to the byte.
// "$ echo $?" is the exit code of the command before. A ```toml or ```asm block is written into the
// folder under the file name that the text above it calls last. With FINBACK_REFRESH set in the
// environment the page is written anew instead (scripts/refresh-traces.sh).
#pragma once

#include <string>

namespace finback::cli {

// `page`: a file of docs/. Fails the running test where page and truth part; a page without any
// example fails too.
void check_page_examples(const std::string& page, const std::string& folder);

}  // namespace finback::cli
