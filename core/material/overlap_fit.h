// The least-squares fit of the shift between two isotherms over the range in which they overlap.
// isotherm_overlap.h finds where the fit starts and judges its result. Pure functions; any thread.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/material/isotherm_overlap.h"

namespace asperity {

/// An isotherm in decades (decimal logarithms).
struct LogSweep {
  std::vector<double> x, storage, loss;
};

LogSweep logarithms(const Isotherm& isotherm);
std::vector<LogSweep> logarithms(std::span<const Isotherm> isotherms);

/// The common range of two isotherms after the colder one has been moved, on the axis of the warmer
/// one.
struct CommonRange {
  double from, to;
  double width() const { return to - from; }
};

CommonRange commonRange(const LogSweep& colder, const LogSweep& warmer, double shift);

/// The moduli from which a shift is determined.
enum class ShiftModuli { Both, Storage, Loss };

/// The shifts that bring two isotherms together.
struct FittedShifts {
  Estimate horizontal, vertical;  // decades
  double ofExpected = 0;  // decades, part of the horizontal shift that the expected vertical makes
  OverlapResiduals residuals{};  // of both moduli
};

/// Returns the shifts from these moduli; nothing where the points do not determine them. The fit
/// starts at `shift` (decades), and is repeated until its window and its shift agree.
/// expectedVertical: decades; empty where there is no vertical shift.
std::optional<FittedShifts> fittedShift(const LogSweep& colder, const LogSweep& warmer,
                                        double shift, std::optional<double> expectedVertical,
                                        ShiftModuli moduli);

}  // namespace asperity
