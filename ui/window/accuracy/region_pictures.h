// Shows the diagrams of a sheet one at a time and as large as possible, with a button for each
// above them: work-precision diagrams by region. GUI thread; owned by its parent.
#pragma once

#include <QWidget>
#include <optional>

#include "core/chart/diagram.h"

class QButtonGroup;
class QHBoxLayout;
class QLabel;

namespace asperity {

class DiagramView;

class RegionPictures : public QWidget {
  Q_OBJECT

 public:
  explicit RegionPictures(QWidget* parent = nullptr);

  /// Shows a sheet. The diagram that was chosen last comes first, if there is one with its name.
  void showSheet(DiagramSheet sheet);
  void showText(const QString& text);

  /// Returns whether there is a sheet, and no text in its place.
  bool hasSheet() const { return sheet_.has_value(); }

 private:
  void choose(int index);

  std::optional<DiagramSheet> sheet_;
  QWidget* bar_;
  QHBoxLayout* places_;
  QButtonGroup* buttons_;
  QLabel* range_;  // rest of the chosen diagram's title after its name
  DiagramView* picture_;
  QString chosen_;  // name of the chosen diagram
};

}  // namespace asperity
