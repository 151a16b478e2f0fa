// The panel of parameters, generated from the table alone: one ParameterRow for each row, grouped
// by section, in a scroll area. Owns the scene that its controls show; every accepted change is a
// new scene. A refused text changes nothing and is explained where it was typed; a scene that still
// misses something is kept and says so, but is not passed on. GUI thread.
#pragma once

#include <QMap>
#include <QSet>
#include <QWidget>
#include <functional>

#include "core/scene/scene.h"
#include "ui/panels/profile_defaults.h"
#include "ui/panels/value_entry.h"

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace asperity {

class ParameterRow;
struct Parameter;

/// Asks a user for a file, beginning in a folder; empty where none was chosen.
using FileChooser = std::function<QString(QWidget* parent, const QString& folder)>;

class ParameterPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterPanel(const Scene& scene, QWidget* parent = nullptr);

  const Scene& scene() const { return scene_; }

  /// Shows another scene; emits nothing.
  void setScene(const Scene& scene);

  /// A complaint about a parameter that only came up when the scene ran. Unknown keys are ignored.
  void showError(const QString& key, const QString& text);

  /// The scene runs: takes such complaints away.
  void clearErrors();

  /// The line that is on the screen, for what the scene leaves to a file.
  void showLine(const LineSize& line);

  /// A file dialog unless told otherwise.
  void setFileChooser(FileChooser chooser);

  QSize sizeHint() const override;

 signals:
  void sceneEdited(const asperity::Scene& scene);

 protected:
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void addSection(QVBoxLayout& column, const QString& section);
  ParameterRow& addRow(QVBoxLayout& column, const Parameter& parameter);
  template <class Change>
  void edit(ParameterRow& row, Change&& change, const QString& refusal = {});
  void takeText(ParameterRow& row, const QString& text);
  void showRows(const ParameterRow* edited);
  void showMissing();
  void chooseFile(ParameterRow& row);
  void showTexts();
  void applyStyle();

  Scene scene_;
  Scene passedOn_;  // the newest that came from outside or went there
  KeptSizes sizes_;
  LineSize line_;  // on the screen, where it is the scene's
  FileChooser chooser_;
  QSet<QString> complaints_;           // keys of showError()
  QMap<QString, ParameterRow*> rows_;  // by key
  QMap<QString, QLabel*> headings_;    // by section, where the heading has a line of its own
  QMap<const ParameterRow*, QString> headingRows_;  // the section of which a row is the heading
  QScrollArea* scroll_;
};

}  // namespace asperity
