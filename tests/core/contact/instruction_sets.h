// Tests that run on every instruction set of the machine.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/contact/kernels/kernels.h"

namespace asperity {

class EachInstructionSet : public testing::TestWithParam<InstructionSet> {
 protected:
  void SetUp() override {
    if (!chooseInstructionSet(GetParam())) GTEST_SKIP() << "not on this machine";
    ASSERT_EQ(instructionSet(), GetParam());
  }
  void TearDown() override { chooseInstructionSet(InstructionSet::Best); }
};

inline std::string wordFor(const testing::TestParamInfo<InstructionSet>& param) {
  std::string name = instructionSetName(param.param);
  std::erase(name, '-');
  return name;
}

}  // namespace asperity

#define ASPERITY_ON_EACH_INSTRUCTION_SET(suite)                                              \
  INSTANTIATE_TEST_SUITE_P(                                                                  \
      InstructionSets, suite,                                                                \
      testing::Values(InstructionSet::Scalar, InstructionSet::Avx2, InstructionSet::Avx512), \
      wordFor)
