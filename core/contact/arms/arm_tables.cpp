#include "core/contact/arms/arm_tables.h"

namespace asperity {

std::shared_ptr<const ArmTable> ArmTables::at(double velocity, const PreparedProfile& line) {
  constexpr std::size_t kMostKept = 256;  // velocities of a curve, with room
  const Key key{velocity, line.spacing, line.length, line.blocks.size()};
  {
    const std::scoped_lock lock(mutex_);
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
  }
  auto made = std::make_shared<const ArmTable>(law_, modes_, velocity, line);
  const std::scoped_lock lock(mutex_);
  if (known_.size() >= kMostKept) known_.clear();
  return known_.try_emplace(key, std::move(made)).first->second;
}

}  // namespace asperity
