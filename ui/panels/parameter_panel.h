// The panel of parameters, generated from the table: one ParameterRow for each row, grouped by
// section, in a scroll area. It owns the scene that its controls show; every accepted change makes
// a new scene. A refused text changes nothing, and the reason is shown where it was typed; an
// incomplete scene is kept with a note, but not passed on. GUI thread.
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

/// Asks the user for a file, beginning in a folder; empty where none was chosen.
using FileChooser = std::function<QString(QWidget* parent, const QString& folder)>;

class ParameterPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ParameterPanel(const Scene& scene, QWidget* parent = nullptr);

  const Scene& scene() const { return scene_; }

  /// Shows another scene without emitting a signal.
  void setScene(const Scene& scene);

  /// Shows an error of a parameter that occurred only when the scene ran. Unknown keys are ignored.
  void showError(const QString& key, const QString& text);

  /// Removes such errors, because the scene runs.
  void clearErrors();

  /// Shows values of the present line where the scene takes them from a file.
  void showLine(const LineSize& line);

  /// Replaces the usual file dialog.
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
  Scene passedOn_;  // the newest scene that was set or passed on
  KeptSizes sizes_;
  LineSize line_;  // of the present line, if it belongs to the scene
  FileChooser chooser_;
  QSet<QString> complaints_;           // keys of showError()
  QMap<QString, ParameterRow*> rows_;  // by key
  QMap<QString, QLabel*> headings_;    // by section, where the heading has a line of its own
  QMap<const ParameterRow*, QString> headingRows_;  // the section of a row that is in the heading
  QScrollArea* scroll_;
};

}  // namespace asperity
