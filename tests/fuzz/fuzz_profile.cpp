// The profile reader: what it takes is at least three finite heights.
#include <cmath>

#include "core/surface/profile_file.h"
#include "tests/fuzz/fuzz_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace asperity;
  return readOrRefuse(data, size, [](std::string_view text) {
    const Profile profile = parseProfile(text, "profile");
    require(profile.height.size() >= 3 && std::isfinite(profile.length) && profile.length >= 0);
    for (const double height : profile.height) require(std::isfinite(height));
  });
}
