// Linked into test programs of the core: invalid operations and divisions by zero end the program
// instead of becoming NaN in silence. NaN as a mark for "not applicable" raises nothing. Threads
// inherit it. Lanes of vectors compute both sides of every choice and keep one; what the other
// raises means nothing, and FlushDenormals lets it pass.
#include <gtest/gtest.h>

#include <cfenv>

namespace asperity {
namespace {

class FloatingPointTraps : public testing::Environment {
 public:
  void SetUp() override { ASSERT_NE(::feenableexcept(FE_INVALID | FE_DIVBYZERO), -1); }
};

[[maybe_unused]] const auto* const kTraps =
    testing::AddGlobalTestEnvironment(new FloatingPointTraps);

}  // namespace
}  // namespace asperity
