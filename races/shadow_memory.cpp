#include <races/shadow_memory.hpp>

namespace finback::races {

ShadowMemory::Page& ShadowMemory::page_at(Address page) {
  std::unique_ptr<Page>& found = pages_[page];
  if (found == nullptr) {
    found = std::make_unique<Page>();
  }
  return *found;
}

}  // namespace finback::races
