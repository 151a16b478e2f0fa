// A reading of the status line: it keeps space for other texts and is never narrower than its own.
// GUI thread; owned by its parent. Cannot fail.
#pragma once

#include <QLabel>
#include <QString>
#include <QStringList>
#include <algorithm>
#include <array>

#include "ui/panels/labels.h"

namespace asperity {

/// A reading as a whole and, for a narrow window, a brief one.
using StatusForms = std::array<QString, 2>;

class StatusReading : public QLabel {
 public:
  using QLabel::QLabel;

  void setForms(const StatusForms& forms) {
    forms_ = forms;
    setText(forms_[isBrief_]);
  }
  void setForm(const QString& only) { setForms({only, only}); }
  void setBrief(bool isBrief) {
    isBrief_ = isBrief;
    if (text() != forms_[isBrief]) setText(forms_[isBrief]);
  }
  /// Keeps the space of a number in each form, or of the widest of these texts.
  void reserve(const StatusForms& forms) {
    reserved_ = {widestText(*this, {forms[0]}), widestText(*this, {forms[1]})};
    updateGeometry();
  }
  void reserve(const QStringList& texts) {
    reserved_.fill(widestText(*this, texts));
    updateGeometry();
  }
  QSize sizeHint() const override {
    return QLabel::sizeHint().expandedTo({reserved_[isBrief_], 0});
  }
  QSize minimumSizeHint() const override { return QLabel::sizeHint(); }
  int wholeWidth() const { return std::max(reserved_[0], widestText(*this, {forms_[0]})); }

 private:
  StatusForms forms_;
  std::array<int, 2> reserved_{};
  bool isBrief_ = false;
};

}  // namespace asperity
