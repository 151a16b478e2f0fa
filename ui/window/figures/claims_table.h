// The paper's sentences about a figure and the results: whether each holds, and what was measured.
// The selected row of the table also shows the quantity, the criterion and the note; so does its
// tool tip. GUI thread, owned by its parent; the results in words: any thread.
#pragma once

#include <QTableWidget>
#include <vector>

#include "core/paper/claim.h"

namespace asperity {

/// Returns "yes", "no", "undecided", or "only for scheme ...".
QString verdictText(const Claim& claim);

/// Returns "1.26 ± 0.04", with the digits that the uncertainty allows; three where there is none.
QString estimateText(const Estimate& estimate);

class ClaimsTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit ClaimsTable(QWidget* parent = nullptr);

  void setClaims(const std::vector<Claim>& claims);
  /// Returns the selected row; -1: none.
  int unfolded() const;

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showTexts();
  void fill();
  int longest(int column) const;
  void setWidths();
  void unfold(int row);

  std::vector<Claim> claims_;
};

}  // namespace asperity
